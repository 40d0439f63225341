//! Parts of the manual's pages by themselves: topics cut to a control, the sentences of the search, NC blocks in colours.
use ciklo::output::manual::for_control::{Names, keep};
use ciklo::output::manual::highlight::html;
use ciklo::output::manual::search::sentences;

fn for_first(markdown: &str) -> String {
    keep(markdown, &Names { own: vec!["TNC 1"], others: vec!["TNC 2", "iTNC 3"] })
}

#[test]
fn what_other_controls_have_goes_with_what_belongs_to_it() {
    let markdown = "Both do it. On the TNC 2 it is slow. It waits.\n\nIt moves (set by M1; TNC 2: M2); on the TNC 2 it turns. \
                    It ends.\n\n## TNC 2\n\nOnly there.\n\n## TNC 1\n\nOnly here.\n\n\
                    On the iTNC 3 these are known:\n\n- one\n- two\n\n## End\n\n- all\n- TNC 2 alone\n";
    assert_eq!(
        for_first(markdown),
        "Both do it.\n\nIt moves (set by M1). It ends.\n\n## TNC 1\n\nOnly here.\n\n## End\n\n- all\n\n"
    );
}

#[test]
fn tables_lose_rows_columns_and_parts_of_cells() {
    let markdown = "| What | TNC 1 | TNC 2, iTNC 3 |\n|---|---|---|\n| a | b | c |\n| d | – | e |\n\n\
                    | Control | What |\n|---|---|\n| TNC 2 | x |\n| TNC 1, TNC 2 | y; on the iTNC 3 z |\n\n\
                    | Axis | Plane |\n|---|---|\n| Z (TNC 2: Z or W) | X |\n";
    let expected = "| What | TNC 1 |\n| --- | --- |\n| a | b |\n\n| Control | What |\n| --- | --- |\n\
                    | TNC 1, TNC 2 | y |\n\n| Axis | Plane |\n| --- | --- |\n| Z | X |\n\n";
    assert_eq!(for_first(markdown).replace("---", "-").replace('-', "---"), expected);
}

#[test]
fn what_begins_a_sentence_now_has_a_capital_unless_it_is_a_name() {
    let of_third = |text| keep(text, &Names { own: vec!["iTNC 3"], others: vec!["TNC 1", "TNC 2"] });
    assert_eq!(of_third("Teeth. TNC 1:ssa 20; iTNC 3:ssa 99.\n").trim(), "Teeth. iTNC 3:ssa 99.");
    assert_eq!(of_third("Teeth. On the TNC 1 20; on the iTNC 3 99.\n").trim(), "Teeth. On the iTNC 3 99.");
}

#[test]
fn a_topic_of_one_control_is_not_changed() {
    let text = "On the TNC 2 it is slow.\n";
    assert_eq!(keep(text, &Names { own: vec!["TNC 1"], others: Vec::new() }), text);
}

#[test]
fn a_row_is_one_sentence_and_knows_its_place() {
    let page = "<nav>x</nav><main id=\"content\"><h1><span>CYCL DEF 1</span> Pecking</h1><nav><p>no</p></nav>\
                <p>It pecks &amp; drills.</p><table><tr id=\"Q200\"><th>Q200</th><td><p>Set-up.</p></td></tr></table>\
                <pre>Q200=2</pre></main>";
    // The heading is the title of the page, which the index has once.
    let expected =
        [("", "It pecks & drills."), ("Q200", "Q200 Set-up.")].map(|(place, text)| (place.to_owned(), text.to_owned()));
    assert_eq!(sentences(page), expected);
}

#[test]
fn parts_are_marked_and_the_text_stays() {
    let text = "6 CYCL DEF 901 ENGRAVING\n    QS500=\"A;<B\" ;TEXT\n    Q513=+10\n";
    let shown = html(text, &|q| q == "Q513");
    let expected = "<span class=\"b\">6</span> <span class=\"k\">CYCL DEF 901</span> ENGRAVING\n    \
                    <span class=\"q\">QS500</span>=<span class=\"t\">&quot;A;&lt;B&quot;</span> \
                    <span class=\"c\">;TEXT</span>\n    <a class=\"q\" href=\"#Q513\">Q513</a>=+10\n";
    assert_eq!(shown, expected);
}
