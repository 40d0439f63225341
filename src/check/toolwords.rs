//! What the words for a tool say of it: its name in the table or the program, and a comment beside its call.
//!
//! Invariant: words that leave a doubt say nothing.
use crate::check::cycle::removes_material;
use crate::check::program::with_meaning;
use crate::spec::{Cycle, Group};

/// A kind of tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToolKind {
    /// A drill.
    Drill,
    /// A drill that only centres.
    Spot,
    /// A tap.
    Tap,
    /// A thread mill.
    ThreadMill,
    /// A reamer.
    Reamer,
    /// A boring bar.
    Boring,
    /// A tool that counterbores from below.
    BackBoring,
    /// A face mill.
    FaceMill,
    /// An end mill.
    EndMill,
    /// A ball nose mill.
    Ball,
    /// A tool for chamfers.
    Chamfer,
    /// A tool for engraving.
    Engraver,
    /// A touch probe.
    Probe,
}

/// Words for kinds of tools, alone or as the beginning of a word.
const WORDS: [(ToolKind, &[&str], &[&str]); 13] = [
    (ToolKind::ThreadMill, &["GF"], &["THREADMILL", "GEWINDEFR", "GEWFR", "KIERREJYRS"]),
    (ToolKind::Tap, &["TAP", "GB"], &["TAPPING", "GEWINDEBOHR", "GEWBOHR", "MASCHIO", "MACHO", "KIERRETAP"]),
    (ToolKind::Reamer, &["REAM"], &["REAMER", "REIBAHL", "ALESATOR", "ALARGADOR", "KALVI", "POVRTAL"]),
    (ToolKind::BackBoring, &[], &["BACKBOR", "BACKSPOT"]),
    (ToolKind::Boring, &[], &["BORINGBAR", "BORBAR", "BORING", "BOHRSTANGE"]),
    (ToolKind::Spot, &["SPOT", "CENT"], &["SPOTDRILL", "CENTERDR", "CENTREDR", "ZENTRIER", "ANBOHR"]),
    (ToolKind::Probe, &["TS"], &["PROBE", "TASTER", "TOUCHPROBE"]),
    (ToolKind::FaceMill, &["FACE"], &["FACEMILL", "PLANFR"]),
    (ToolKind::Ball, &["BALL"], &["BALLNOSE", "KUGELFR"]),
    (ToolKind::Chamfer, &[], &["CHAMFER", "FASENFR", "COUNTERSINK", "CSINK", "SENKER"]),
    (ToolKind::Engraver, &[], &["ENGRAV", "GRAVIER"]),
    (ToolKind::Drill, &["DRILL", "BOHRER", "BROCA", "PORA", "SVEDER"], &["SPIRALB", "TWISTDRILL"]),
    (ToolKind::EndMill, &["EM", "ENDMILL", "FRESA", "JYRSIN"], &["ENDMILL", "SCHAFTFR", "SCHLICHTFR", "SCHRUPPFR"]),
];

impl ToolKind {
    /// The kind that words name first.
    pub fn named(words: &str) -> Option<Self> {
        let words = words.to_ascii_uppercase();
        let mut parts = words.split(|sign: char| !sign.is_alphabetic()).filter(|part| !part.is_empty()).peekable();
        while let Some(part) = parts.next() {
            let next = parts.peek().copied().unwrap_or_default();
            match (part, next) {
                ("THREAD", "MILL") => return Some(Self::ThreadMill),
                ("SLOT", "DRILL") => return Some(Self::EndMill),
                ("TAP" | "CORE" | "PILOT", "DRILL") => return Some(Self::Drill),
                ("END", "MILL") => return Some(Self::EndMill),
                ("GEW" | "GEWINDE", _) if next.starts_with("BOHR") => return Some(Self::Tap),
                ("GEW" | "GEWINDE", _) if next.starts_with("FR") => return Some(Self::ThreadMill),
                ("CENTER" | "CENTRE" | "CENTERING" | "CENTRING", "DRILL") => return Some(Self::Spot),
                ("BACK", _) if next.starts_with("BOR") => return Some(Self::BackBoring),
                ("DRILL", "MILL" | "THREAD") => return None,
                _ => {}
            }
            let is = |whole: &[&str], stems: &[&str]| {
                whole.contains(&part) || stems.iter().any(|stem| part.starts_with(stem))
            };
            if let Some((kind, ..)) = WORDS.iter().find(|(_, whole, stems)| is(whole, stems)) {
                return Some(*kind);
            }
        }
        None
    }

    /// The kind that the column TYP of a tool table names, if it leaves no doubt.
    pub fn of_type(word: &str) -> Option<Self> {
        Some(match word.to_ascii_uppercase().as_str() {
            "DRILL" => Self::Drill,
            "CENT" => Self::Spot,
            "REAM" => Self::Reamer,
            "TAP" => Self::Tap,
            "MILL_FACE" => Self::FaceMill,
            "MILL" | "MILL_R" | "MILL_F" | "MILL_SIDE" | "TORUS" => Self::EndMill,
            "BALL" => Self::Ball,
            "MILL_CHAMFER" | "CSINK" => Self::Chamfer,
            _ => return None,
        })
    }

    /// What the column TYP of a tool table calls it, as it is known best.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Drill => "DRILL",
            Self::Spot => "CENT",
            Self::Tap => "TAP",
            Self::ThreadMill => "THREADMILL",
            Self::Reamer => "REAM",
            Self::Boring => "BORING",
            Self::BackBoring => "BACKBORE",
            Self::FaceMill => "MILL_FACE",
            Self::EndMill => "MILL",
            Self::Ball => "BALL",
            Self::Chamfer => "CHAMFER",
            Self::Engraver => "ENGRAVER",
            Self::Probe => "TCHP",
        }
    }

    /// Whether it only cuts along its axis.
    pub const fn only_along_axis(self) -> bool {
        matches!(self, Self::Drill | Self::Tap | Self::Reamer)
    }

    /// Whether a cycle cannot be meant for such a tool.
    pub fn misfits(self, cycle: &Cycle) -> bool {
        if !removes_material(cycle) {
            return false;
        }
        let has = |meaning: &str| with_meaning(cycle, meaning).is_some();
        let mills = is_milling(cycle);
        match cycle.file.group {
            _ if matches!(self, Self::Probe) => true,
            Group::Drilling if mills => self.only_along_axis() || matches!(self, Self::Spot),
            // Counterboring from below, and boring that leaves the wall before it retracts.
            Group::Drilling if has("counterbore-depth") => {
                self.only_along_axis() || matches!(self, Self::Spot | Self::FaceMill | Self::EndMill | Self::Ball)
            }
            Group::Drilling if has("disengaging-direction") && !has("plunging-depth") => {
                self.only_along_axis() || matches!(self, Self::Spot | Self::ThreadMill)
            }
            Group::Drilling if is_reaming(cycle) => {
                matches!(self, Self::Tap | Self::ThreadMill | Self::Spot | Self::FaceMill | Self::Drill)
            }
            Group::Drilling if has("centring-diameter") => {
                matches!(self, Self::Tap | Self::ThreadMill | Self::Reamer | Self::FaceMill)
            }
            Group::Drilling => {
                matches!(self, Self::Tap | Self::ThreadMill | Self::Reamer | Self::FaceMill | Self::Boring)
            }
            // Its tool drills before it mills.
            Group::Threads if mills && has("plunging-depth") => {
                matches!(self, Self::Tap | Self::Reamer | Self::FaceMill | Self::Ball | Self::EndMill)
            }
            Group::Threads if mills => {
                self.only_along_axis() || matches!(self, Self::FaceMill | Self::Ball | Self::EndMill)
            }
            Group::Threads => !matches!(self, Self::Tap),
            // Drilling for a rough-out tool.
            Group::Contours => matches!(self, Self::Tap | Self::Reamer),
            Group::Pockets | Group::Surfaces => self.only_along_axis(),
            _ => false,
        }
    }
}

/// The side of a workpiece for which a tool is that turns it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TurnedPart {
    /// Outside.
    Outside,
    /// Inside, in a hole.
    Inside,
}

impl TurnedPart {
    /// The side that words name; nothing if they name both.
    pub fn named(words: &str) -> Option<Self> {
        const OUTSIDE: (&[&str], &[&str]) =
            (&["OUT", "EXT"], &["OUTSIDE", "OUTER", "EXTERN", "EXTERIOR", "AUSSEN", "ESTERN", "ULKO", "ZUNAN"]);
        const INSIDE: (&[&str], &[&str]) = (
            &["INT", "BORING", "BORE"],
            &[
                "INSIDE", "INNER", "INTERN", "INTERIOR", "INNEN", "SISÄ", "SISA", "NOTRAN", "BAREN", "MANDRIL",
                "BOREBAR", "BORBAR", "BORINGB", "BOHRST",
            ],
        );
        let words = words.to_uppercase();
        let parts = || words.split(|sign: char| !sign.is_alphabetic()).filter(|part| !part.is_empty());
        let is = |(whole, stems): (&[&str], &[&str])| {
            parts().any(|part| whole.contains(&part) || stems.iter().any(|stem| part.starts_with(stem)))
        };
        let bar = parts().zip(parts().skip(1)).any(|pair| matches!(pair, ("BORING" | "BORE" | "BOR", "BAR")));
        match (is(OUTSIDE), is(INSIDE) || bar) {
            (true, false) => Some(Self::Outside),
            (false, true) => Some(Self::Inside),
            _ => None,
        }
    }
}

/// Whether a cycle for holes or threads mills: it has a type of milling, or, for a thread, a feed for it.
pub fn is_milling(cycle: &Cycle) -> bool {
    let has = |meaning: &str| with_meaning(cycle, meaning).is_some();
    has("milling-type") || cycle.file.group == Group::Threads && has("milling-feed")
}

/// Whether a cycle goes down and back at feeds and does no more, as a reamer does.
pub fn is_reaming(cycle: &Cycle) -> bool {
    let has = |meaning: &str| with_meaning(cycle, meaning).is_some();
    cycle.file.group == Group::Drilling
        && has("retraction-feed")
        && !["plunging-depth", "disengaging-direction", "milling-type", "deepened-starting-point", "counterbore-depth"]
            .iter()
            .any(|own| has(own))
}

/// The diameter that the name of a tool gives, mm: `DRILL_6.8`, `EM_D12`, `REAMER_8H7`; nothing if there are several.
pub fn diameter_of(name: &str) -> Option<f64> {
    let kind = ToolKind::named(name)?;
    // Of a tool for centring the number is rather the angle of its point, and `#7` is none of millimetres.
    if name.contains('#') || matches!(kind, ToolKind::Spot) && name.bytes().filter(u8::is_ascii_digit).count() > 1 {
        return None;
    }
    if matches!(kind, ToolKind::Tap | ToolKind::ThreadMill | ToolKind::Chamfer | ToolKind::Engraver | ToolKind::Probe) {
        return None;
    }
    let name = name.to_ascii_uppercase().replace(',', ".");
    let parts = || name.split(|sign: char| !(sign.is_ascii_alphanumeric() || sign == '.'));
    // `DRILL_1_4IN` is a fraction of an inch.
    let inches = |part: &str| matches!(part.trim_start_matches(|sign: char| sign.is_ascii_digit()), "IN" | "INCH");
    if parts().any(inches) {
        return None;
    }
    let number = |part: &str| {
        let part = part.strip_prefix('D').unwrap_or(part);
        let end = part.find(|sign: char| !(sign.is_ascii_digit() || sign == '.')).unwrap_or(part.len());
        let (digits, rest) = part.split_at_checked(end)?;
        let fits = rest.is_empty() || rest == "MM" || rest.starts_with('H') && rest.len() <= 3;
        // `EM_500` and `DR_3125` are thousandths of an inch.
        digits.parse::<f64>().ok().filter(|own| fits && *own > 0.0 && *own < 200.0)
    };
    let mut all = parts().filter_map(number);
    let first = all.next()?;
    all.next().is_none().then_some(first)
}

/// Whether words name the left hand, in any of the languages.
pub fn is_left(words: &str) -> bool {
    const WHOLE: [&str; 5] = ["L", "LH", "LI", "SX", "IZQ"];
    const STEMS: [&str; 7] = ["LEFT", "LINK", "SINIST", "ESQUERD", "VASEN", "VASUR", "LEV"];
    let words = words.to_uppercase();
    // M8LH, too.
    let parts = words.split(|sign: char| !sign.is_alphabetic());
    parts.into_iter().any(|part| WHOLE.contains(&part) || STEMS.iter().any(|stem| part.starts_with(stem)))
}
