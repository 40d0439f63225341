//! Codes of diagnostics that had another name before.
//!
//! Old names are still understood wherever a user names a code: `ciklo explain`, `[rules]` of `ciklo.toml`, and comments
//! `; ciklo: allow RULE reason`. Diagnostics only ever have the present names.

/// The old names, in their order, each with the present one.
pub const RENAMED: &[(&str, &str)] = &[
    ("accord-argument", "consistency-argument"),
    ("accord-code", "consistency-code"),
    ("accord-forbidden", "consistency-forbidden"),
    ("accord-label-of-another", "consistency-label-of-another"),
    ("accord-label-twice", "consistency-label-twice"),
    ("accord-number", "consistency-number"),
    ("accord-quantity", "consistency-quantity"),
    ("accord-reference", "consistency-reference"),
    ("accord-reference-word", "consistency-reference-word"),
    ("accord-swapped", "consistency-swapped"),
    ("accord-term", "consistency-term"),
    ("accord-unit", "consistency-unit"),
    ("behind-end", "blocks-after-end"),
    ("contour-unnamed", "contour-not-selected"),
    ("convert-cycle-lacking", "convert-cycle-not-on-control"),
    ("convert-field-lacking", "convert-field-not-on-control"),
    ("convert-value-means-else", "convert-value-differs-in-meaning"),
    ("cycle-line-alone", "cycle-line-zero-missing"),
    ("cycle-of-tool-before", "cycle-of-previous-tool"),
    ("data-lacks", "data-directory-missing"),
    ("direction-unsaid", "arc-direction-missing"),
    ("engine-silent", "engine-not-responding"),
    ("frame-mismatch", "begin-end-mismatch"),
    ("infeeds-never-arrive", "infeeds-never-reach-depth"),
    ("iso-word-not-taken", "iso-word-not-allowed"),
    ("out-of-range-elsewhere", "out-of-usual-range"),
    ("probe-measurements-apart", "probe-measurements-differ"),
    ("selection-missing", "program-not-selected"),
    ("subprogram-end-alone", "subprogram-end-without-label"),
    ("syntax-iso-remark", "syntax-bracket-comment"),
    ("syntax-remark", "syntax-text-after-tab"),
    ("table-value-not-taken", "table-value-not-allowed"),
    ("tool-unfit", "wrong-tool-type"),
    ("turning-feed-unit", "feed-unit"),
    ("unlike-elsewhere", "differs-from-other-control"),
    ("value-without-sense", "meaningless-value"),
];

/// The present name of a code: the code itself, unless it is an old one.
pub fn present(code: &str) -> &str {
    let at = RENAMED.binary_search_by_key(&code, |(old, _)| old);
    at.ok().and_then(|at| RENAMED.get(at)).map_or(code, |(_, new)| new)
}
