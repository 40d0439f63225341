//! The words that begin a contour element.

/// The kind of a contour element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Path {
    /// Straight line.
    L,
    /// Straight line, polar.
    Lp,
    /// Straight line with the surface normal, or the direction of the tool.
    Ln,
    /// Positioning along one axis, without a word of its own: `X+40 R+`.
    Axis,
    /// Circle centre or pole.
    Cc,
    /// Circle about the centre.
    C,
    /// Circle of a radius.
    Cr,
    /// Tangential circle.
    Ct,
    /// Circle about the pole.
    Cp,
    /// Tangential circle, polar.
    Ctp,
    /// Rounding.
    Rnd,
    /// Chamfer.
    Chf,
    /// Approach to a contour.
    Appr(Approach),
    /// Departure from a contour.
    Dep(Approach),
    /// Straight line of a free contour.
    Fl,
    /// Tangential straight line of a free contour.
    Flt,
    /// Circle of a free contour.
    Fc,
    /// Tangential circle of a free contour.
    Fct,
    /// Pole of a free contour.
    Fpol,
    /// Spline.
    Spl,
}

/// The form of an approach or a departure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Approach {
    /// `LT`: tangential line.
    Lt,
    /// `LN`: line perpendicular to the contour.
    Ln,
    /// `CT`: tangential arc.
    Ct,
    /// `LCT`: tangential arc and line.
    Lct,
    /// `PLT`: `LT`, polar.
    Plt,
    /// `PLN`: `LN`, polar.
    Pln,
    /// `PCT`: `CT`, polar.
    Pct,
    /// `PLCT`: `LCT`, polar.
    Plct,
}

impl Approach {
    /// The form of an upper-case word.
    pub fn by_name(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"LT" => Self::Lt,
            b"LN" => Self::Ln,
            b"CT" => Self::Ct,
            b"LCT" => Self::Lct,
            b"PLT" => Self::Plt,
            b"PLN" => Self::Pln,
            b"PCT" => Self::Pct,
            b"PLCT" => Self::Plct,
            _ => return None,
        })
    }

    /// Whether an arc belongs to it.
    pub const fn has_arc(self) -> bool {
        matches!(self, Self::Ct | Self::Lct | Self::Pct | Self::Plct)
    }
}

impl Path {
    /// The path of an upper-case word; of approach and departure another word gives the form.
    pub fn by_name(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"L" => Self::L,
            b"LP" => Self::Lp,
            b"LN" => Self::Ln,
            b"CC" => Self::Cc,
            b"C" => Self::C,
            b"CR" => Self::Cr,
            b"CT" => Self::Ct,
            b"CP" => Self::Cp,
            b"CTP" => Self::Ctp,
            b"RND" => Self::Rnd,
            b"CHF" => Self::Chf,
            b"FL" => Self::Fl,
            b"FLT" => Self::Flt,
            b"FC" => Self::Fc,
            b"FCT" => Self::Fct,
            b"FPOL" => Self::Fpol,
            b"SPL" => Self::Spl,
            _ => return None,
        })
    }

    /// The name of the kind of block.
    pub const fn name(self) -> &'static str {
        match self {
            Self::L => "l",
            Self::Lp => "lp",
            Self::Ln => "ln",
            Self::Axis => "axis",
            Self::Cc => "cc",
            Self::C => "c",
            Self::Cr => "cr",
            Self::Ct => "ct",
            Self::Cp => "cp",
            Self::Ctp => "ctp",
            Self::Rnd => "rnd",
            Self::Chf => "chf",
            Self::Appr(_) => "appr",
            Self::Dep(_) => "dep",
            Self::Fl => "fl",
            Self::Flt => "flt",
            Self::Fc => "fc",
            Self::Fct => "fct",
            Self::Fpol => "fpol",
            Self::Spl => "spl",
        }
    }

    /// Whether it changes the corner between two elements and leads nowhere itself.
    pub const fn is_corner(self) -> bool {
        matches!(self, Self::Rnd | Self::Chf)
    }

    /// Whether `R` with a value is its radius.
    pub const fn has_radius(self) -> bool {
        match self {
            Self::Cr | Self::Rnd | Self::Fc | Self::Fct => true,
            Self::Appr(form) | Self::Dep(form) => form.has_arc(),
            _ => false,
        }
    }
}

/// A path in one byte: long programs have millions of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PathCode {
    L,
    Lp,
    Ln,
    Axis,
    Cc,
    C,
    Cr,
    Ct,
    Cp,
    Ctp,
    Rnd,
    Chf,
    Fl,
    Flt,
    Fc,
    Fct,
    Fpol,
    Spl,
    ApprLt,
    ApprLn,
    ApprCt,
    ApprLct,
    ApprPlt,
    ApprPln,
    ApprPct,
    ApprPlct,
    DepLt,
    DepLn,
    DepCt,
    DepLct,
    DepPlt,
    DepPln,
    DepPct,
    DepPlct,
}

/// All paths, in the order of their codes.
const PATHS: [(PathCode, Path); 34] = [
    (PathCode::L, Path::L),
    (PathCode::Lp, Path::Lp),
    (PathCode::Ln, Path::Ln),
    (PathCode::Axis, Path::Axis),
    (PathCode::Cc, Path::Cc),
    (PathCode::C, Path::C),
    (PathCode::Cr, Path::Cr),
    (PathCode::Ct, Path::Ct),
    (PathCode::Cp, Path::Cp),
    (PathCode::Ctp, Path::Ctp),
    (PathCode::Rnd, Path::Rnd),
    (PathCode::Chf, Path::Chf),
    (PathCode::Fl, Path::Fl),
    (PathCode::Flt, Path::Flt),
    (PathCode::Fc, Path::Fc),
    (PathCode::Fct, Path::Fct),
    (PathCode::Fpol, Path::Fpol),
    (PathCode::Spl, Path::Spl),
    (PathCode::ApprLt, Path::Appr(Approach::Lt)),
    (PathCode::ApprLn, Path::Appr(Approach::Ln)),
    (PathCode::ApprCt, Path::Appr(Approach::Ct)),
    (PathCode::ApprLct, Path::Appr(Approach::Lct)),
    (PathCode::ApprPlt, Path::Appr(Approach::Plt)),
    (PathCode::ApprPln, Path::Appr(Approach::Pln)),
    (PathCode::ApprPct, Path::Appr(Approach::Pct)),
    (PathCode::ApprPlct, Path::Appr(Approach::Plct)),
    (PathCode::DepLt, Path::Dep(Approach::Lt)),
    (PathCode::DepLn, Path::Dep(Approach::Ln)),
    (PathCode::DepCt, Path::Dep(Approach::Ct)),
    (PathCode::DepLct, Path::Dep(Approach::Lct)),
    (PathCode::DepPlt, Path::Dep(Approach::Plt)),
    (PathCode::DepPln, Path::Dep(Approach::Pln)),
    (PathCode::DepPct, Path::Dep(Approach::Pct)),
    (PathCode::DepPlct, Path::Dep(Approach::Plct)),
];

/// Each path is found at the place that its code is.
const _: () = {
    let mut at = 0;
    while at < PATHS.len() {
        assert!(PATHS[at].0 as usize == at);
        at += 1;
    }
};

impl PathCode {
    /// The code of a path.
    pub(super) fn of(path: Path) -> Self {
        PATHS.iter().find(|(_, own)| *own == path).map_or(Self::L, |(code, _)| *code)
    }

    /// The path that it stands for.
    pub(super) const fn path(self) -> Path {
        PATHS[self as usize].1
    }
}
