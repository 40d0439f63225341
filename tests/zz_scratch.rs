use std::collections::BTreeSet;
use ciklo::locale::{Args, Locales, Scope};
use ciklo::spec::{Catalogue, texts};
#[test]
fn texts_of_all() {
    let files = ciklo::data::embedded();
    let (catalogue, _) = Catalogue::load(&files);
    let (locales, found) = Locales::load(files.iter().map(|(p, t)| (p.clone(), t.clone())));
    for d in &found { println!("LOCALE {d:?}"); }
    let lang = std::env::var("L").unwrap_or_else(|_| "en".into());
    let en = locales.language(&lang).unwrap();
    let mut used = BTreeSet::new();
    let mut names: Vec<(String, String)> = Vec::new();
    for on in catalogue.controls.values() {
        for cycle in on.cycles.values() {
            names.clear();
            for p in &cycle.params { names.push((format!("q-{}", p.is.as_str()), p.q.map_or("Q?".into(), |q| q.to_string()))); }
            for (n, v) in &on.control.data.0 { names.push((format!("mp-{}", n.as_str()), v.as_str().to_owned())); }
            for t in texts(cycle, on) {
                used.insert(t.id.clone());
                let mut args = Args::new().number("cycle", f64::from(cycle.key.number)).text("control", on.id()).text("control-name", "X");
                for (n, v) in &names { args = args.text(n, v.as_str()); }
                let key = match t.attribute { Some(a) => format!("{}.{a}", t.id), None => t.id.clone() };
                match en.text(&key, &Scope::new(cycle.name(), on.id()), &args) { Ok(x) => if std::env::var("V").is_ok() { println!("{} {key}: {x}", cycle.key) }, Err(e) => println!("BAD {} {} {key} {e:?}", on.id(), cycle.key) }
            }
        }
    }
    for id in en.ids() { let base = id.split("__").next().unwrap(); if !used.contains(base) && !base.starts_with("diag-") { println!("UNUSED {id}"); } }
}
