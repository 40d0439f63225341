//! The manual site: every page of the built data is valid HTML without a dead link, a few pages of a
//! small catalogue are compared whole, and what is missing stops the build.
//! `UPDATE=1 cargo test --test suite manual` rewrites the compared pages in `tests/small/site/`.
use crate::built::{Built, built};
use crate::html;
use crate::small as catalogue;

use std::collections::{BTreeMap, HashSet};
use std::path::Path;
use std::sync::{Mutex, OnceLock};

use ciklo::base::data::Files;
use ciklo::base::diag::Diagnostic;
use ciklo::language::locale::{Locales, Scope};
use ciklo::language::text::with_texts;
use ciklo::output::manual::{self, Request};
use ciklo::spec::Catalogue;

type Produced = BTreeMap<String, Vec<u8>>;

fn build(files: &Files, languages: &[String]) -> Result<Produced, Vec<Diagnostic>> {
    build_at(files, languages, None)
}

fn build_at(files: &Files, languages: &[String], base_url: Option<&str>) -> Result<Produced, Vec<Diagnostic>> {
    let (catalogue, _) = Catalogue::load(files);
    let (locales, _) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    build_of(&Request { catalogue: &catalogue, locales: &locales, files, controls: &[], languages, base_url })
}

fn build_of(request: &Request<'_>) -> Result<Produced, Vec<Diagnostic>> {
    let produced = Mutex::new(Produced::new());
    let sink = |path: &str, bytes: &[u8]| {
        let before = produced.lock().expect("no thread panics").insert(path.to_owned(), bytes.to_vec());
        assert!(before.is_none(), "{path} is written twice");
        Ok(())
    };
    let built = manual::build(request, &sink)?;
    let produced = produced.into_inner().expect("no thread panics");
    assert_eq!(built.files, produced.len());
    assert_eq!(built.pages, produced.keys().filter(|path| path.ends_with(".html")).count());
    Ok(produced)
}

/// The languages in which nothing is missing.
fn complete() -> Vec<String> {
    let locales = &built().locales;
    let whole = |tag: &&str| locales.audit(tag).is_ok_and(|audit| audit.missing.is_empty());
    locales.tags().filter(whole).map(str::to_owned).collect()
}

/// The site of all built data; made once for all tests that look at it.
fn whole_site() -> &'static Produced {
    static SITE: OnceLock<Produced> = OnceLock::new();
    SITE.get_or_init(make_whole_site)
}

fn make_whole_site() -> Produced {
    let languages = complete();
    assert!(languages.iter().any(|tag| tag == "en"), "the source language is complete");
    let Built { files, catalogue, locales } = built();
    let request = Request { catalogue, locales, files, controls: &[], languages: &languages, base_url: None };
    build_of(&request).unwrap_or_else(|faults| {
        let shown: Vec<String> = faults.iter().map(|fault| format!("{} {:?}", fault.code, fault.args)).collect();
        panic!("{shown:#?}")
    })
}

/// The pages of that site, read once for all tests that look at them.
fn whole_pages() -> &'static BTreeMap<&'static str, html::Page> {
    static PAGES: OnceLock<BTreeMap<&str, html::Page>> = OnceLock::new();
    PAGES.get_or_init(|| {
        let all: Vec<(&str, &str)> = pages(whole_site()).collect();
        let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        let read = |part: &[(&'static str, &str)]| -> Vec<(&'static str, html::Page)> {
            part.iter().map(|(path, text)| (*path, html::read(text))).collect()
        };
        std::thread::scope(|scope| {
            let parts = all.chunks(all.len().div_ceil(threads).max(1));
            let running: Vec<_> = parts.map(|part| scope.spawn(move || read(part))).collect();
            running.into_iter().flat_map(|part| part.join().expect("pages can be read")).collect()
        })
    })
}

/// The small catalogue with the general texts and the templates.
fn small() -> Files {
    const GENERAL: [&str; 3] = ["locales/en/text.ftl", "locales/en/units.ftl", "locales/en/site.ftl"];
    catalogue::files(|path| GENERAL.contains(&path) || path.starts_with("templates/"))
}

fn pages(site: &Produced) -> impl Iterator<Item = (&str, &str)> {
    let text = |bytes| std::str::from_utf8(bytes).expect("pages are UTF-8");
    site.iter().filter(|(path, _)| path.ends_with(".html")).map(move |(path, bytes)| (path.as_str(), text(bytes)))
}

#[test]
fn every_page_is_valid_html_in_its_language_with_unique_ids() {
    for (&path, page) in whole_pages() {
        assert!(page.errors.is_empty(), "{path}: {:?}", page.errors);
        let ids: HashSet<&String> = page.ids.iter().collect();
        assert_eq!(ids.len(), page.ids.len(), "{path}: {:?}", page.ids);
        let language = path.split('/').nth(1).unwrap_or("en");
        assert_eq!(page.lang, language, "{path}");
        let scripts = page.elements.iter().filter(|name| *name == "script").count();
        assert_eq!(scripts > 1, path.ends_with("/search.html"), "{path}: only searching needs a script of its own");
        assert!(!page.text.contains(['\u{2068}', '\u{2069}', '\u{2060}']), "{path}: a mark that nobody sees");
        let count = |name: &str| page.elements.iter().filter(|own| *own == name).count();
        for name in ["main", "h1"] {
            assert_eq!(count(name), 1, "{path}: {name}");
        }
        // Each figure has a title and a description of its own.
        assert_eq!(count("title"), 1 + count("desc"), "{path}: titles");
    }
}

#[test]
fn every_link_leads_to_a_file_or_an_id_of_the_site() {
    let site = whole_site();
    let read = whole_pages();
    for (path, page) in read {
        for link in &page.links {
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let target = resolve(path, file);
            assert!(site.contains_key(&target), "{path}: {link}");
            if !anchor.is_empty() {
                assert!(read[target.as_str()].ids.iter().any(|id| id == anchor), "{path}: {link}");
            }
        }
    }
}

fn resolve(from: &str, link: &str) -> String {
    if link.is_empty() {
        return from.to_owned();
    }
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in link.split('/') {
        match part {
            ".." => assert!(parts.pop().is_some(), "{link} leaves the site"),
            part => parts.push(part),
        }
    }
    parts.join("/")
}

#[test]
fn every_page_can_be_reached_from_the_first_one() {
    let site = whole_site();
    let mut open = vec!["index.html".to_owned()];
    let mut seen: HashSet<String> = open.iter().cloned().collect();
    while let Some(path) = open.pop() {
        let Some(page) = whole_pages().get(path.as_str()) else { continue };
        for link in &page.links {
            let target = resolve(&path, link.split('#').next().unwrap_or_default());
            if seen.insert(target.clone()) {
                open.push(target);
            }
        }
    }
    // A server shows it where there is no page.
    seen.insert("404.html".to_owned());
    let lost: Vec<&String> = site.keys().filter(|path| !seen.contains(*path)).collect();
    assert!(lost.is_empty(), "{lost:?}");
}

/// The pages of cycles, of a control and language.
fn cycle_pages<'s>(site: &'s Produced, below: &'s str) -> impl Iterator<Item = (&'s str, &'s str)> {
    let is_cycle = |name: &str| name.starts_with("cycl-def-") || name.starts_with("tch-probe-");
    pages(site).filter(move |(path, _)| path.strip_prefix(below).is_some_and(is_cycle))
}

#[test]
fn what_is_needed_first_comes_first() {
    let order =
        ["id=\"purpose\"", "id=\"parameters\"", "id=\"run\"", "id=\"results\"", "id=\"notes\"", "id=\"checks\""];
    for (path, text) in cycle_pages(whole_site(), "tnc640/en/") {
        let places: Vec<usize> = order.iter().filter_map(|id| text.find(id)).collect();
        assert!(places.len() >= 3 && places.is_sorted(), "{path}: {places:?}");
    }
}

#[test]
fn each_page_and_each_printed_sheet_names_the_control_and_the_date_of_the_data() {
    let built = crate::built::built();
    let date = built.catalogue.pages.as_ref().and_then(|pages| pages.edition.clone()).expect("a date");
    for on in built.catalogue.controls.values() {
        let title = &on.control.title;
        for (path, text) in cycle_pages(whole_site(), &format!("{}/fi/", on.id())) {
            let sheet =
                text.split_once("@top-left").and_then(|(_, rest)| rest.split_once("</style>")).expect("a sheet").0;
            let foot = text.split_once("<footer").expect("a foot").1.replace("&#x2f;", "/");
            for part in [sheet, foot.as_str()] {
                assert!(part.contains(title.as_str()) && part.contains(&date), "{path}: {part}");
            }
        }
    }
}

#[test]
fn no_note_is_lost() {
    let built = crate::built::built();
    let language = built.locales.language("sl").expect("the language");
    let site = whole_site();
    let mut folded = 0;
    for on in built.catalogue.controls.values() {
        let read = |file: &str| html::read(&String::from_utf8_lossy(&site[&format!("{}/sl/{file}", on.id())])).text;
        let general = read("notes.html");
        for cycle in on.cycles.values() {
            let key = cycle.key.to_string().to_lowercase().replace(' ', "-");
            let page = read(&format!("{key}.html"));
            let notes = with_texts(on, cycle, language, |text| {
                text.notes().into_iter().map(|(_, note)| note.into_owned()).collect::<Vec<_>>()
            });
            for note in notes.expect("all texts are there") {
                let start: String = note.chars().take_while(|c| !"*_`[\\".contains(*c)).collect();
                let here = page.contains(start.trim());
                folded += usize::from(!here);
                assert!(here || general.contains(start.trim()), "{} {key}: {note}", on.id());
            }
        }
    }
    assert!(folded > 500, "notes for many cycles are on one page: {folded}");
}

#[test]
fn worked_programs_are_on_the_pages_of_their_cycles_with_comments_of_the_language() {
    let built = crate::built::built();
    let site = whole_site();
    let language = built.locales.language("fi").expect("the language");
    let mut shown = 0;
    for on in built.catalogue.controls.values() {
        let read = |file: &str| html::read(&String::from_utf8_lossy(&site[&format!("{}/fi/{file}", on.id())]));
        let all = read("programs.html");
        for worked in on.worked.iter() {
            assert!(all.ids.iter().any(|id| id == worked.name()), "{} {}", on.id(), worked.name());
            for id in worked.comments() {
                let words = language.plain(&format!("comment-{id}"), &Scope::NONE).expect("a comment");
                assert!(all.text.contains(&format!("; {words}")), "{} {id}: {words}", on.id());
            }
        }
        for cycle in on.cycles.values() {
            let key = cycle.key.to_string();
            let page = read(&format!("{}.html", key.to_lowercase().replace(' ', "-")));
            for worked in on.worked.iter() {
                let defines = worked.text().lines().any(|line| {
                    let head = line.split_once(&key).map(|(_, rest)| rest);
                    head.is_some_and(|rest| rest.is_empty() || rest.starts_with([' ', '.']))
                });
                let link = format!("programs.html#{}", worked.name());
                let is_of = defines || worked.key == cycle.key;
                assert_eq!(page.links.contains(&link), is_of, "{} {key}: {link}", on.id());
                shown += usize::from(is_of);
            }
        }
    }
    assert!(shown > 40, "programs on pages of cycles: {shown}");
}

#[test]
fn a_path_of_the_control_keeps_its_backslash() {
    let site = whole_site();
    let page = |name: &str| String::from_utf8_lossy(&site[name]).into_owned();
    assert!(page("tnc640/en/notes.html").contains(r"in the directory TNC:\."));
    assert!(page("tnc426-430/en/notes.html").contains(r"to RS232:\."));
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let files = small();
    let first = build(&files, &[]).expect("the small site is whole");
    assert_eq!(first, build(&files, &[]).expect("the small site is whole"));
}

#[test]
fn pages_of_the_small_catalogue_are_as_they_were() {
    let site = build(&small(), &[]).expect("the small site is whole");
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/small/site");
    let compared = [
        "index.html",
        "small/en/index.html",
        "small/en/cycl-def-901.html",
        "small/en/cycl-def-9.html",
        "small/en/parameters.html",
        "small/en/topic-pecking-basics.html",
        "small/en/glossary.html",
        "small/en/keywords.html",
        "small/en/notes.html",
        "search/en.js",
        "404.html",
        "small/en/dialogs.json",
    ];
    for path in compared {
        let file = directory.join(path.replace('/', "-"));
        let produced = std::str::from_utf8(&site[path]).expect("it is UTF-8");
        if std::env::var_os("UPDATE").is_some() {
            std::fs::write(&file, produced).expect("the page can be written");
        }
        let kept = std::fs::read_to_string(&file).unwrap_or_default();
        assert_eq!(produced, kept, "{path} differs; UPDATE=1 rewrites it");
    }
}

#[test]
fn a_missing_text_stops_the_build_and_all_of_them_are_told() {
    let mut files = small();
    for (path, text) in &mut files {
        if path == "locales/en/small.ftl" {
            *text = text.replace("choice-plain = Plain", "").replace("step-peck = The tool pecks.", "");
        }
    }
    let faults = build(&files, &[]).expect_err("two texts are missing");
    let keys: Vec<String> = faults.iter().map(|fault| format!("{} {:?}", fault.code, fault.get("key"))).collect();
    assert_eq!(keys.len(), 2, "{keys:?}");
    assert!(faults.iter().all(|fault| fault.code == "locale-missing-text" && fault.place.is_some()), "{keys:?}");
}

#[test]
fn a_topic_without_a_page_or_a_title_stops_the_build() {
    for (text, code) in [(None, "manual-topic-missing"), (Some("No title.\n"), "manual-topic-title")] {
        let mut files = small();
        match text {
            None => files.retain(|(path, _)| !path.ends_with("pecking-basics.md")),
            Some(text) => {
                let page = files.iter_mut().find(|(path, _)| path.ends_with("pecking-basics.md")).expect("the page");
                page.1 = text.to_owned();
            }
        }
        let faults = build(&files, &[]).expect_err("the topic cannot be shown");
        assert_eq!(faults.iter().map(|fault| fault.code).collect::<Vec<_>>(), [code]);
        assert!(faults[0].place.is_some());
    }
}

#[test]
fn the_index_of_the_search_leads_from_one_form_of_a_word_to_all() {
    let words = [
        ("en", vec!["drill", "drills", "drilling"]),
        ("fi", vec!["syvyys", "syvyyden", "syvyyteen"]),
        ("it", vec!["foro", "fori"]),
        ("pt", vec!["furo", "furos"]),
        ("sl", vec!["vrtina", "vrtine", "vrtin"]),
    ];
    let site = whole_site();
    for (tag, same) in words {
        let index = search_index(site, tag);
        let groups: Vec<&str> =
            index["stems"].as_array().expect("a list").iter().filter_map(|own| own.as_str()).collect();
        let has = |group: &&&str, form: &str| group.split(' ').skip(1).any(|own| own == form);
        let group = groups.iter().find(|group| has(group, same[0])).unwrap_or_else(|| panic!("{tag}: no {}", same[0]));
        assert!(same.iter().all(|form| has(&group, form)), "{tag}: {same:?} {group}");
        let pages = index["pages"].as_array().expect("a list");
        let drilling = pages.iter().position(|page| page[0] == "cycl-def-200.html").expect("its page");
        let sentences = index["sentences"][drilling].as_array().expect("a list");
        let says = |sentence: &serde_json::Value| {
            let text = sentence[1].as_str().expect("a sentence").to_lowercase();
            text.split(|c: char| !c.is_alphanumeric()).any(|word| has(&group, word))
        };
        assert!(sentences.iter().any(says), "{tag}: {same:?} do not lead to the page of drilling");
    }
}

fn search_index(site: &Produced, tag: &str) -> serde_json::Value {
    let script = std::str::from_utf8(&site[&format!("search/{tag}.js")]).expect("it is UTF-8");
    let json = script.strip_prefix("const cikloIndex = ").and_then(|rest| rest.strip_suffix(";\n"));
    serde_json::from_str(json.expect("one object")).expect("the object is JSON")
}

#[test]
fn every_place_of_the_search_exists_on_every_control_that_it_names() {
    let site = whole_site();
    let index = search_index(site, "pt");
    let list = |value: &serde_json::Value| value.as_array().expect("a list").clone();
    let controls: Vec<String> =
        list(&index["controls"]).iter().map(|own| own[0].as_str().expect("an id").to_owned()).collect();
    assert_eq!(controls.len(), 4);
    let mut read: BTreeMap<String, HashSet<String>> = BTreeMap::new();
    let mut looked_at = 0;
    for (page, sentences) in list(&index["pages"]).iter().zip(list(&index["sentences"])) {
        let (file, anchor) =
            page[0].as_str().and_then(|file| file.split_once('#')).unwrap_or((page[0].as_str().expect("a file"), ""));
        for sentence in list(&sentences) {
            let place = if anchor.is_empty() { sentence[0].as_str().expect("a place") } else { anchor };
            let on = sentence[2].as_u64().expect("bits");
            assert!(on > 0 && on & !page[2].as_u64().expect("bits") == 0, "{file}: {sentence}");
            for (_, control) in controls.iter().enumerate().filter(|(bit, _)| on & (1 << bit) != 0) {
                let path = format!("{control}/pt/{file}");
                let ids = read
                    .entry(path.clone())
                    .or_insert_with(|| whole_pages()[path.as_str()].ids.iter().cloned().collect());
                assert!(place.is_empty() || ids.contains(place), "{path}: {place}");
                looked_at += 1;
            }
        }
    }
    assert!(looked_at > 5000, "{looked_at}");
}

#[test]
fn a_topic_is_cut_to_its_control_alike_in_all_languages() {
    let site = whole_site();
    let shape = |path: &str| -> Vec<String> {
        let shown = |name: &&String| ["h2", "h3", "p", "li", "tr", "td", "pre"].contains(&name.as_str());
        whole_pages()[path].elements.iter().filter(shown).cloned().collect()
    };
    let topics: Vec<&str> = pages(site).map(|(path, _)| path).filter(|path| path.contains("/en/topic-")).collect();
    assert!(topics.len() > 60, "{}", topics.len());
    for path in topics {
        for tag in ["fi", "it", "pt", "sl"] {
            assert_eq!(shape(path), shape(&path.replace("/en/", &format!("/{tag}/"))), "{path} in {tag}");
        }
    }
    let page = |name: &str| String::from_utf8_lossy(&site[name]).into_owned();
    // The soft keys and machine parameters of one control are not on the pages of another.
    assert!(!page("tnc426-430/en/topic-calibration-basics.html").contains("CALIBRATE TS"));
    assert!(!page("tnc640/en/topic-calibration-basics.html").contains("MP7411"));
    assert!(page("tnc640/en/topic-calibration-basics.html").contains("CALIBRATE TS"));
}

#[test]
fn sentences_lead_to_the_cycles_and_terms_that_they_mention() {
    let page = |name: &str| String::from_utf8_lossy(&whole_site()[name]).into_owned();
    // A number after the word for a cycle, a Q parameter of the cycle, a term in an inflected form.
    assert!(page("tnc640/fi/cycl-def-22.html").contains("<a href=\"cycl-def-21.html\">21</a>"));
    assert!(page("tnc640/sl/cycl-def-200.html").contains("<a href=\"#Q206\">Q206</a>"));
    assert!(page("tnc640/sl/cycl-def-200.html").contains("<a href=\"glossary.html#term-set-up-clearance\">varnostn"));
    // A number that is not one of a cycle.
    assert!(!page("tnc640/en/tch-probe-451.html").contains("cycl-def-4.html"));
}

#[test]
fn the_address_of_the_site_gives_canonical_addresses_and_a_sitemap() {
    let files = small();
    let site = build_at(&files, &[], Some("https://example.org/manual")).expect("the small site is whole");
    let text = |path: &str| String::from_utf8_lossy(&site[path]).into_owned();
    let canonical = "<link rel=\"canonical\" href=\"https://example.org/manual/small/en/cycl-def-901.html\">";
    assert!(text("small/en/cycl-def-901.html").contains(canonical));
    assert!(text("404.html").contains("href=\"https://example.org/manual/assets/ciklo.css\""));
    let sitemap = text("sitemap.xml");
    assert_eq!(sitemap.matches("<loc>").count(), pages(&site).count() - 1, "every page but 404.html");
    assert!(sitemap.contains("<loc>https://example.org/manual/small/en/index.html</loc>"));
}

#[test]
fn a_comparison_marks_only_what_differs_in_effect() {
    let site = whole_site();
    let page = String::from_utf8_lossy(&site["compare/en/tch-probe-412.html"]).into_owned();
    let row = |q: &str| {
        let start = page.find(&format!("<tr id=\"{q}\">")).unwrap_or_else(|| panic!("no row {q}"));
        page[start..].split_once("</tr>").expect("a row").0.to_owned()
    };
    // Only one of the manuals prints a range, and the examples differ.
    assert!(!row("Q321").contains("differs"), "{}", row("Q321"));
    // One of the controls does not have it, and one moves on an arc with the same value.
    assert!(row("Q303").contains("differs"), "{}", row("Q303"));
    assert!(row("Q301").contains("choices differs"), "{}", row("Q301"));
}

#[test]
fn a_template_that_uses_an_unknown_value_stops_the_build() {
    let mut files = small();
    for (path, text) in &mut files {
        if path == "templates/cycle.html" {
            *text = text.replace("words.purpose", "words.purpoise");
        }
    }
    let faults = build(&files, &[]).expect_err("a word does not exist");
    assert!(faults.iter().all(|fault| fault.code == "manual-template"), "{faults:?}");
}

#[test]
fn a_template_without_an_end_stops_the_build() {
    let mut files = small();
    for (path, text) in &mut files {
        if path == "templates/cycle.html" {
            text.insert_str(0, "{% for i in range(100000) %}{% for j in range(100000) %}{% endfor %}{% endfor %}");
        }
    }
    let faults = build(&files, &["en".to_owned()]).expect_err("the page has no end");
    assert!(faults.iter().all(|fault| fault.code == "manual-template"), "{faults:?}");
}

#[test]
fn what_is_not_there_cannot_be_asked_for() {
    let files = small();
    let faults = build(&files, &["xx".to_owned()]).expect_err("there is no such language");
    assert_eq!(faults[0].code, "locale-unknown-language");
}
