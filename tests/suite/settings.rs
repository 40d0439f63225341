//! The settings of `ciklo.toml`: which of them hold for a file, and what is wrong in them.
use ciklo::base::diag::{Severity, Source};
use ciklo::check::Config;

fn parsed(text: &str) -> Result<Config, Vec<&'static str>> {
    let source = Source::new("ciklo.toml", text);
    let known = |word: &str| word != "nonsense";
    Config::parse(&source, &known, &known, &known)
        .map_err(|found| found.iter().map(|diagnostic| diagnostic.code).collect())
}

#[test]
fn what_comes_later_wins() {
    let config = parsed(
        "control = \"tnc640\"\n[rules]\nguard = \"off\"\nspindle-off = \"error\"\n\
         [[folder]]\npath = \"old\"\ncontrol = \"itnc530\"\nrules = { guard = \"note\" }\n\
         [[folder]]\npath = \"**/fi/*.h\"\nlang = \"fi\"\n",
    )
    .unwrap();
    let top = config.of("a.h");
    assert_eq!((top.control.as_deref(), top.language.as_deref()), (Some("tnc640"), None));
    assert_eq!(top.rules.get("guard"), Some(&None));
    let below = config.of("old/x/fi/b.h");
    assert_eq!((below.control.as_deref(), below.language.as_deref()), (Some("itnc530"), Some("fi")));
    assert_eq!(below.rules.get("guard"), Some(&Some(Severity::Note)));
    assert_eq!(below.rules.get("spindle-off"), Some(&Some(Severity::Error)));
    assert_eq!(config.of("older/a.h"), top);
}

#[test]
fn an_old_name_of_a_rule_is_understood() {
    let config = parsed("[rules]\nbehind-end = \"off\"\n").unwrap();
    assert_eq!(config.of("a.h").rules.get("blocks-after-end"), Some(&None));
}

#[test]
fn every_mistake_is_reported() {
    for (text, codes) in [
        ("control = ", vec!["config-syntax"]),
        ("control = 5\nother = 1\n", vec!["config-unknown-word", "config-unknown-key"]),
        ("control = \"nonsense\"", vec!["config-unknown-word"]),
        ("[rules]\nnonsense = \"off\"\nguard = \"bad\"\n", vec!["config-value", "config-unknown-rule"]),
        ("folder = 1\n", vec!["config-value"]),
        ("[[folder]]\ncontrol = \"a\"\n", vec!["config-value"]),
        ("rules = 1\n", vec!["config-value"]),
    ] {
        assert_eq!(parsed(text).unwrap_err(), codes, "{text}");
    }
}

#[test]
fn a_machine_has_limits() {
    let config = parsed(
        "[machine]\nspeed = 12000\nfeed = 9999.5\n[machine.travel]\nX = [-100, 500]\nC = [-360.0, 360.0]\n\
         [[folder]]\npath = \"big\"\nmachine = { speed = 18000, travel = { X = [0, 2000] } }\n",
    )
    .unwrap();
    let top = config.of("a.h").machine;
    assert_eq!((top.speed, top.feed, top.helix), (Some(12000.0), Some(9999.5), None));
    assert_eq!(top.travel.get("X"), Some(&[-100.0, 500.0]));
    let big = config.of("big/a.h").machine;
    assert_eq!((big.speed, big.feed), (Some(18000.0), Some(9999.5)));
    assert_eq!((big.travel.get("X"), big.travel.get("C")), (Some(&[0.0, 2000.0]), Some(&[-360.0, 360.0])));
    for (text, codes) in [
        ("machine = 1\n", vec!["config-value"]),
        (
            "[machine]\nspeed = 0\nfeed = \"fast\"\npower = 5\n",
            vec!["config-value", "config-unknown-machine", "config-value"],
        ),
        (
            "[machine.travel]\nX = [500, -100]\nY = 5\nQ = [0, 1]\n",
            vec!["config-unknown-machine", "config-value", "config-value"],
        ),
    ] {
        assert_eq!(parsed(text).unwrap_err(), codes, "{text}");
    }
}

#[test]
fn patterns() {
    let check = |pattern: &str, path: &str| {
        let config = parsed(&format!("[[folder]]\npath = \"{pattern}\"\ncontrol = \"a\"\n")).unwrap();
        config.of(path).control.is_some()
    };
    assert!(check("*.h", "a.h") && check("**/*.h", "a/b.h") && check("**/*.h", "b.h") && check("a/?", "a/b/c.h"));
    assert!(check("p*t*.h", "part.h") && check(".", "a.h") && check("a/**", "a/b/c.h"));
    assert!(!check("*.h", "a.i") && !check("b", "a/b.h") && !check("a/?", "a/bc/c.h") && !check("p*t", "pat.h"));
}
