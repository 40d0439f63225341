//! The kinds of tables and their columns, as the manuals name them.
//!
//! Invariant: a name appears here only if a manual has it; other columns of a file are kept and read as text.

/// What the cells of a column hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The number of the row.
    Key,
    /// Text or a word.
    Text,
    /// mm, or inch in a table in inches.
    Length,
    /// mm/min, or inch/min in a table in inches.
    Feed,
    /// Degrees.
    Angle,
    /// A number without a unit.
    Number,
}

/// A column: its name, its width in characters and what it holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// The printed name.
    pub name: &'static str,
    /// Characters from its start to the start of the next one.
    pub width: usize,
    /// What it holds.
    pub quantity: Quantity,
}

/// The kinds of tables that cycles read and write.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum TableKind {
    /// Tools, `TOOL.T`.
    Tool,
    /// Touch probes, `tchprobe.tp`.
    Probe,
    /// Presets, `PRESET.PR`.
    Preset,
    /// Datums, any `.D`.
    Datum,
    /// Positions for machining cycles (`.PNT`).
    Points,
    /// Turning tools, `TOOLTURN.TRN`.
    Turning,
    /// Tables whose columns are those of their file (`.TAB`).
    Free,
}

/// Columns that controls write into tables of tools and touch probes and that no manual here describes: they are known,
/// and their cells are not checked.
const WRITTEN: [&str; 28] = [
    "TYP",
    "NMAX",
    "LIFTOFF",
    "TP_NO",
    "T-ANGLE",
    "PITCH",
    "LAST_USE",
    "PTYP",
    "ACC",
    "KINEMATIC",
    "AFC",
    "AFC-LOAD",
    "AFC-OVLD1",
    "AFC-OVLD2",
    "OVRTIME",
    "RCUTS",
    "LU",
    "RN",
    "TSHAPE",
    "TMAT",
    "CDT",
    "DR2TABLE",
    "DOC",
    "PLC",
    "P-TYP",
    "P-LOCK",
    "PLC-VAL",
    "CR",
];

/// The types of turning tools: for roughing, finishing, threads, recesses, with a round insert, for recess turning.
const TYPES: [&str; 6] = ["ROUGH", "FINISH", "THREAD", "RECESS", "BUTTON", "RECTURN"];

/// Room for `-99999.999999999` and a blank: the engine's results keep 1e-9 mm.
const WIDE: usize = 17;

const fn key(name: &'static str) -> Column {
    Column { name, width: 8, quantity: Quantity::Key }
}

const fn text(name: &'static str, width: usize) -> Column {
    Column { name, width, quantity: Quantity::Text }
}

const fn length(name: &'static str) -> Column {
    Column { name, width: WIDE, quantity: Quantity::Length }
}

const fn angle(name: &'static str) -> Column {
    Column { name, width: WIDE, quantity: Quantity::Angle }
}

const fn feed(name: &'static str) -> Column {
    Column { name, width: 11, quantity: Quantity::Feed }
}

const fn number(name: &'static str) -> Column {
    Column { name, width: 9, quantity: Quantity::Number }
}

/// Tool measurement: TNC 320 manual lines 6916-6955; LCUTS, ANGLE: TNC 640 4704; T-ANGLE: 1750; RS and P-ANGLE, the cutting
/// width: 7304, 8821; TP_NO: 10661; TL: 12624.
const TOOL: &[Column] = &[
    key("T"),
    text("NAME", 33),
    length("L"),
    length("R"),
    length("R2"),
    length("DL"),
    length("DR"),
    length("DR2"),
    text("TL", 4),
    number("CUT"),
    length("LTOL"),
    length("RTOL"),
    text("DIRECT.", 9),
    length("R-OFFS"),
    length("L-OFFS"),
    length("LBREAK"),
    length("RBREAK"),
    length("LCUTS"),
    angle("ANGLE"),
    angle("T-ANGLE"),
    angle("P-ANGLE"),
    length("RS"),
    length("CUTWIDTH"),
    number("TP_NO"),
    text("DOC", 33),
];

/// Turning tools: TO, RS, T-ANGLE, P-ANGLE TNC 640 manual line 7304, the cutting width 8821; the other columns are common
/// knowledge of the trade: lengths along Z, X and Y with their oversizes, the angle of the spindle, the length of the
/// edge, oversizes of radius and width, the type.
const TURNING: &[Column] = &[
    key("T"),
    text("NAME", 33),
    length("ZL"),
    length("XL"),
    length("YL"),
    length("DZL"),
    length("DXL"),
    length("DYL"),
    length("RS"),
    length("DRS"),
    number("TO"),
    angle("ORI"),
    angle("T-ANGLE"),
    angle("P-ANGLE"),
    length("CUTLENGTH"),
    length("CUTWIDTH"),
    length("DCW"),
    text("TYPE", 9),
    text("DOC", 33),
];

/// TNC 640 manual lines 10661-10671, TNC 320 lines 493-555.
const PROBE: &[Column] = &[
    key("NO"),
    text("TYPE", 17),
    length("CAL_OF1"),
    length("CAL_OF2"),
    angle("CAL_ANG"),
    feed("F"),
    feed("FMAX"),
    length("DIST"),
    length("SET_UP"),
    text("F_PREPOS", 14),
    text("TRACK", 7),
];

/// SPA, SPB, SPC: TNC 320 manual lines 794-795; the axes are those that cycles write.
const PRESET: &[Column] = &[
    key("NO"),
    text("DOC", 33),
    length("X"),
    length("Y"),
    length("Z"),
    angle("SPA"),
    angle("SPB"),
    angle("SPC"),
    angle("A"),
    angle("B"),
    angle("C"),
];

/// Point tables: TNC 640 manual 1583-1640.
const POINTS: &[Column] = &[key("NR"), length("X"), length("Y"), length("Z"), text("FADE", 3)];

/// A freely definable table has what its file has, and a number for each row.
const FREE: &[Column] = &[key("NR")];

/// TNC 640 manual lines 6422-6450.
const DATUM: &[Column] = &[
    key("D"),
    length("X"),
    length("Y"),
    length("Z"),
    angle("A"),
    angle("B"),
    angle("C"),
    length("U"),
    length("V"),
    length("W"),
    text("DOC", 33),
];

impl TableKind {
    /// Whether a column is one that controls write, though no manual describes it.
    pub fn is_written(self, name: &str) -> bool {
        matches!(self, Self::Tool | Self::Probe) && WRITTEN.iter().any(|own| same_name(own, name))
    }

    /// All kinds.
    pub const ALL: [Self; 7] =
        [Self::Tool, Self::Probe, Self::Preset, Self::Datum, Self::Points, Self::Turning, Self::Free];

    /// The columns in their order; the first is the number of the row.
    pub const fn columns(self) -> &'static [Column] {
        match self {
            Self::Tool => TOOL,
            Self::Probe => PROBE,
            Self::Preset => PRESET,
            Self::Datum => DATUM,
            Self::Points => POINTS,
            Self::Turning => TURNING,
            Self::Free => FREE,
        }
    }

    /// The extension of its files, with the dot, in upper case.
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Tool => ".T",
            Self::Probe => ".TP",
            Self::Preset => ".PR",
            Self::Datum => ".D",
            Self::Points => ".PNT",
            Self::Turning => ".TRN",
            Self::Free => ".TAB",
        }
    }

    /// The name of the file that a control has of this kind, or that a scene's table gets.
    pub const fn file_name(self) -> &'static str {
        match self {
            Self::Tool => "TOOL.T",
            Self::Probe => "tchprobe.tp",
            Self::Preset => "PRESET.PR",
            Self::Datum => "DATUM.D",
            Self::Points => "POINTS.PNT",
            Self::Turning => "TOOLTURN.TRN",
            Self::Free => "TABLE.TAB",
        }
    }

    /// The word for it in specifications and messages.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Tool => "tool",
            Self::Probe => "probe",
            Self::Preset => "preset",
            Self::Datum => "datum",
            Self::Points => "points",
            Self::Turning => "turning",
            Self::Free => "free",
        }
    }

    /// The kind of that word.
    pub fn by_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.as_str() == word)
    }

    /// The kind of a file by its extension.
    pub fn of_file(name: &str) -> Option<Self> {
        let extension = name.rsplit_once('.').map(|(_, extension)| format!(".{}", extension.to_ascii_uppercase()))?;
        Self::ALL.into_iter().find(|kind| kind.extension() == extension)
    }

    /// The range of a column, in mm: wear and breakage TNC 320 manual lines 6918-6955, iTNC 530 manual 1644-1683;
    /// teeth: 20 at most in 1644, up to 99 measurable in 2024.
    pub fn range(self, column: &str) -> Option<(f64, f64)> {
        match (self, column) {
            (Self::Tool, "LTOL" | "RTOL" | "LBREAK" | "RBREAK") => Some((0.0, 0.9999)),
            (Self::Tool, "CUT") => Some((0.0, 99.0)),
            (Self::Turning, "TO") => Some((1.0, 9.0)),
            _ => None,
        }
    }

    /// The range outside of which a number is hardly meant, in mm: 20 teeth (TNC 320 manual line 6918, TNC 640 line
    /// 14906), tool numbers TNC 640 line 13327; the greatest lengths and angles are those of the parameters of cycles.
    pub fn usual(self, column: &Column) -> Option<(f64, f64)> {
        match (self, column.name) {
            (Self::Tool, "T") => Some((0.0, 32767.9)),
            (Self::Tool, "CUT") => Some((0.0, 20.0)),
            (Self::Tool, "R" | "LCUTS" | "RS" | "CUTWIDTH") => Some((0.0, 99999.9999)),
            (Self::Turning, "T") => Some((0.0, 32767.9)),
            (Self::Turning, "RS" | "CUTLENGTH" | "CUTWIDTH") => Some((0.0, 99999.9999)),
            (Self::Turning, "T-ANGLE" | "P-ANGLE") => Some((0.0, 180.0)),
            (Self::Tool, "ANGLE") => Some((0.0, 90.0)),
            (Self::Tool, "T-ANGLE" | "P-ANGLE") => Some((0.0, 180.0)),
            (Self::Probe, "DIST" | "SET_UP") => Some((0.0, 99999.9999)),
            _ => match column.quantity {
                Quantity::Key => Some((0.0, 99999.0)),
                Quantity::Length => Some((-99999.9999, 99999.9999)),
                Quantity::Angle => Some((-360.0, 360.0)),
                // Nothing moves at a feed of 0.
                Quantity::Feed => Some((f64::MIN_POSITIVE, 300_000.0)),
                Quantity::Number | Quantity::Text => None,
            },
        }
    }

    /// Whether the numbers of a column are whole: tools have numbers with a decimal, too.
    pub fn is_whole(self, column: &Column) -> bool {
        match column.quantity {
            Quantity::Key => !matches!(self, Self::Tool | Self::Turning),
            _ => matches!(column.name, "CUT" | "TP_NO" | "TO"),
        }
    }

    /// The columns without which nothing can be done with a table; one of the axes is enough for one of datums.
    pub const fn needed(self) -> &'static [&'static str] {
        match self {
            Self::Tool => &["L", "R"],
            Self::Points => &["X", "Y"],
            Self::Preset => &["X", "Y", "Z"],
            Self::Turning => &["ZL", "XL", "TO"],
            Self::Probe | Self::Datum | Self::Free => &[],
        }
    }

    /// The words of a column that takes no others: TNC 640 manual lines 1583-1640 (FADE), 14907-14913 (TL, DIRECT.),
    /// 10670 (F_PREPOS, TRACK). Files that a control has written have 0 and 1 in TL.
    pub fn words(self, column: &str) -> Option<&'static [&'static str]> {
        match (self, column) {
            (Self::Tool, "TL") => Some(&["L", "-", "0", "1"]),
            (Self::Tool, "DIRECT.") => Some(&["+", "-"]),
            (Self::Turning, "TYPE") => Some(&TYPES),
            (Self::Points, "FADE") => Some(&["Y", "N", "-"]),
            (Self::Probe, "F_PREPOS") => Some(&["FMAX_PROBE", "FMAX_MACHINE", "-"]),
            (Self::Probe, "TRACK") => Some(&["ON", "OFF", "-"]),
            _ => None,
        }
    }

    /// The column of a name; manuals print some names with `-` or `_`, and with `TT:` in front.
    pub fn column(self, name: &str) -> Option<&'static Column> {
        self.columns().iter().find(|column| same_name(column.name, name))
    }
}

/// Whether two printed names mean the same column (R-OFFS, R_OFFS, TT:R_OFFS; the row's number is NO or NR).
pub(super) fn same_name(a: &str, b: &str) -> bool {
    let number = |name: &str| name.eq_ignore_ascii_case("NO") || name.eq_ignore_ascii_case("NR");
    if number(a) && number(b) {
        return true;
    }
    let bare = |name| str::strip_prefix(name, "TT:").unwrap_or(name).bytes();
    let folded = |byte: u8| if byte == b'-' { b'_' } else { byte.to_ascii_uppercase() };
    bare(a).map(folded).eq(bare(b).map(folded))
}
