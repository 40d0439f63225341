//! Every strategy that the engine has: one line each.
//!
//! Plans are compiled by this list, and executed through it. Invariant: a name that is not here is a mistake.
use glam::DVec3;

use super::action::{Action, Control};
use super::calculation::Calculation;
use super::contour::{Contours, OverContours};
use super::milling::Milling;
use super::pen::{Cutter, Path};
use super::signature::{Given, Output, Parameter, Results};
use super::{
    contour, contour_lines, contour_walls, cylinder, datum, digitizing, engraving, face, groove_shape, kinematics,
    measure, memory, plunge, pocket, probing, program, recess, rotary, rotation, setter, spindle, stud, thread,
    tilting, train, turning, turning_contour, turning_shape, turning_system, turning_thread,
};
use crate::engine::geometry::WorkingPlane;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::spec::Quantity;

/// A strategy as plans know it.
#[derive(Clone, Copy, Debug)]
pub struct Strategy {
    /// Its name in specifications.
    pub name: &'static str,
    /// Its arguments.
    pub parameters: &'static [Parameter],
    /// Its results.
    pub outputs: &'static [Output],
    /// Whether it moves the probe towards the workpiece.
    pub probes: bool,
    /// What it does with its arguments.
    pub does: Does,
}

/// What a strategy does with its arguments.
#[derive(Clone, Copy, Debug)]
pub enum Does {
    /// The path of a tool from a point: main, minor and tool coordinate.
    Mill(fn(Given<'_>, Cutter, DVec3) -> Result<Path, Fault>),
    /// The path of a tool over the contours that were read, from a point.
    MillOver(fn(Given<'_>, &Contours, Cutter, DVec3) -> Result<Path, Fault>),
    /// Values.
    Calculate(fn(Given<'_>, WorkingPlane) -> Result<Vec<f64>, Fault>),
    /// A change at the control, and values in a unit of so many mm.
    Act(fn(Given<'_>, &mut dyn Control, f64) -> Done<Vec<f64>>),
}

const fn mill<S: Milling>() -> Strategy {
    Strategy {
        name: S::NAME,
        parameters: S::PARAMETERS,
        outputs: &[],
        probes: false,
        does: Does::Mill(|given, tool, from| Ok(S::decode(given)?.path(tool, from))),
    }
}

const fn mill_over<S: OverContours>() -> Strategy {
    Strategy {
        name: S::NAME,
        parameters: S::PARAMETERS,
        outputs: &[],
        probes: false,
        does: Does::MillOver(|given, contours, tool, from| Ok(S::decode(given)?.path(contours, tool, from))),
    }
}

const fn calculate<S: Calculation>() -> Strategy {
    Strategy {
        name: S::NAME,
        parameters: S::PARAMETERS,
        outputs: S::Results::OUTPUTS,
        probes: false,
        does: Does::Calculate(|given, plane| Ok(S::decode(given)?.calculate(plane)?.numbers(1.0))),
    }
}

const fn act<S: Action>() -> Strategy {
    Strategy {
        name: S::NAME,
        parameters: S::PARAMETERS,
        outputs: S::Results::OUTPUTS,
        probes: S::PROBES,
        does: Does::Act(|given, control, mm| Ok(S::decode(given)?.act(control)?.numbers(mm))),
    }
}

/// Every strategy, by family.
pub static STRATEGIES: &[Strategy] = &[
    act::<datum::SetDatum>(),
    act::<datum::WriteDatumRow>(),
    act::<datum::WritePreset>(),
    act::<rotation::ResetBasicRotation>(),
    act::<rotation::WriteBasicRotation>(),
    act::<rotation::TurnBasicRotation>(),
    act::<rotary::AlignRotaryTable>(),
    act::<rotary::AlignRotaryAxis>(),
    act::<rotary::AlignDirection>(),
    act::<rotary::ZeroRotaryTable>(),
    act::<rotary::ZeroRotaryAxis>(),
    act::<rotary::AddAngleToDatumRow>(),
    calculate::<measure::Direction>(),
    calculate::<measure::IntersectLines>(),
    calculate::<measure::PlaneAngles>(),
    calculate::<measure::ToleranceBand>(),
    act::<probing::ProbeWithOwnPath>(),
    act::<probing::RetractFromTouchPoint>(),
    act::<probing::StoreProbeCalibration>(),
    act::<digitizing::RememberDigitizingRange>(),
    act::<digitizing::RememberRangeFromPoints>(),
    act::<digitizing::ApproachDigitizingStart>(),
    act::<digitizing::ApproachWorkpieceDownwards>(),
    act::<digitizing::ScanMeander>(),
    act::<digitizing::ScanLine>(),
    act::<digitizing::ReturnForNextLine>(),
    act::<contour_lines::ApproachContourLineStart>(),
    act::<contour_lines::ApproachWorkpieceInDirection>(),
    act::<contour_lines::ScanContourLine>(),
    act::<contour_lines::ScanFurtherContourLines>(),
    act::<digitizing::LeaveDigitizing>(),
    act::<memory::SaveKinematics>(),
    act::<memory::FindSavedKinematics>(),
    act::<memory::RestoreKinematics>(),
    act::<memory::ShowSavedKinematics>(),
    act::<memory::DeleteSavedKinematics>(),
    act::<memory::UseTextParameters>(),
    act::<kinematics::MeasureRotaryAxes>(),
    act::<kinematics::PresetIntoSphere>(),
    act::<kinematics::RateKinematics>(),
    act::<kinematics::OptimizeAxisPositions>(),
    act::<kinematics::OptimizeAxisAngles>(),
    act::<kinematics::OptimizeTransformationChain>(),
    act::<kinematics::AdoptKinematics>(),
    act::<kinematics::StoreKinematicsResults>(),
    mill::<plunge::PlungeOnHelix>(),
    mill::<plunge::PlungeInStrokes>(),
    mill::<plunge::PlungeAlongSlot>(),
    mill::<plunge::PlungeAlongCircularSlot>(),
    mill::<pocket::ClearRectangleLevel>(),
    mill::<pocket::ClearCircleLevel>(),
    mill::<pocket::ClearSlotLevel>(),
    mill::<pocket::ClearCircularSlotLevel>(),
    mill::<pocket::FinishRectangleSide>(),
    mill::<pocket::FinishCircleSide>(),
    mill::<pocket::FinishSlotSide>(),
    mill::<pocket::FinishCircularSlotSide>(),
    mill::<pocket::FinishRectangleFloor>(),
    mill::<pocket::FinishCircleFloor>(),
    mill::<pocket::FinishSlotFloor>(),
    mill::<pocket::FinishCircularSlotFloor>(),
    mill::<stud::MillRectangularStudLevel>(),
    mill::<stud::MillCircularStudLevel>(),
    mill::<stud::HalfTurn>(),
    mill::<face::MillFaceLevel>(),
    mill::<thread::MoveToThreadStartPlane>(),
    mill::<thread::ApproachThreadOnHelix>(),
    mill::<thread::MillThreadHelix>(),
    mill::<thread::DepartThreadTangentially>(),
    mill::<thread::CountersinkOnCircle>(),
    act::<contour::RecallContourData>(),
    act::<contour::FindInfeedPoints>(),
    act::<contour::FindMaterialLeft>(),
    act::<contour::FindDepthsOfPart>(),
    act::<contour_walls::FindDepthsOfWall>(),
    act::<contour_walls::FindPartialContours>(),
    calculate::<contour::StopDistance>(),
    mill_over::<contour::MoveOverInfeedPoint>(),
    mill_over::<contour::PlungeIntoRegion>(),
    mill_over::<contour::ClearRegionAtLevel>(),
    mill_over::<contour::ApproachRegionFloor>(),
    mill_over::<contour_walls::FollowContourSide>(),
    calculate::<engraving::LayOutText>(),
    mill::<engraving::MoveOverGlyph>(),
    mill::<engraving::EngraveGlyph>(),
    act::<train::FindContourStart>(),
    mill_over::<train::MoveOverContourStart>(),
    mill_over::<train::FollowContour>(),
    act::<cylinder::WrapOnCylinder>(),
    act::<cylinder::RetractFromCylinder>(),
    act::<cylinder::PlungeIntoCylinder>(),
    act::<cylinder::MoveOverWrappedContour>(),
    act::<cylinder::FollowWrappedContour>(),
    act::<cylinder::MoveOverSlotStart>(),
    act::<cylinder::FollowSlotWall>(),
    act::<cylinder::ApproximateSlotWalls>(),
    act::<cylinder::MoveOverRidgeStart>(),
    act::<cylinder::ApproachRidgeWall>(),
    act::<cylinder::FollowRidgeWall>(),
    act::<cylinder::LeaveRidgeWall>(),
    act::<turning_system::AlignTurningSystem>(),
    act::<turning_system::ReverseTurningTool>(),
    act::<turning_system::ResetTurningSystem>(),
    act::<turning_shape::TurnShoulder>(),
    mill_over::<turning::ClearTurningArea>(),
    mill_over::<turning::InfeedToTurningLevel>(),
    mill_over::<turning::RoughTurningLevel>(),
    mill_over::<turning::FollowTurnedContour>(),
    mill_over::<turning::LiftOffTurnedContour>(),
    mill_over::<turning::ReturnToStartOfCut>(),
    mill_over::<turning::ApproachTurningContour>(),
    mill_over::<turning::FinishTurnedContour>(),
    mill_over::<turning::RetractFromTurningContour>(),
    mill_over::<turning::ReturnToTurningStart>(),
    act::<turning_contour::AreaOfTurningContour>(),
    mill_over::<turning_contour::InfeedToParallelCut>(),
    mill_over::<turning_contour::CutParallelToContour>(),
    mill_over::<turning_contour::RetractFromParallelCut>(),
    mill_over::<turning_contour::ReturnToParallelCut>(),
    act::<turning_thread::ThreadLine>(),
    act::<turning_thread::ThreadOfContour>(),
    act::<turning_thread::ThreadInfeeds>(),
    mill_over::<turning_thread::ApproachThread>(),
    mill_over::<turning_thread::CutThreadPass>(),
    mill_over::<turning_thread::LiftOffThread>(),
    mill_over::<turning_thread::ReturnAlongThread>(),
    mill_over::<turning_thread::InfeedInThread>(),
    mill_over::<turning_thread::CutThreadAirPasses>(),
    act::<groove_shape::RecessGroove>(),
    act::<groove_shape::RecessGrooveOfContour>(),
    mill_over::<recess::ClearGroove>(),
    mill_over::<recess::MoveOverGroove>(),
    mill_over::<recess::RecessPass>(),
    mill_over::<recess::RecessToLevel>(),
    mill_over::<recess::TurnRecessPass>(),
    mill_over::<recess::LiftAndReturn>(),
    mill_over::<recess::MoveToGrooveFlank>(),
    mill_over::<recess::FollowGrooveWall>(),
    mill_over::<recess::FinishGrooveFloor>(),
    mill_over::<recess::FinishHalfOfGroove>(),
    mill_over::<recess::FinishWholeGroove>(),
    mill_over::<recess::LeaveGroove>(),
    mill_over::<recess::ReturnFromGroove>(),
    act::<tilting::ComputeRotaryPositions>(),
    act::<tilting::PositionRotaryAxes>(),
    act::<tilting::CheckSpindleAcrossRotaryAxis>(),
    act::<setter::ApproachToolSetter>(),
    act::<setter::ApproachToolSetterSide>(),
    act::<setter::MeasureToolLength>(),
    act::<setter::MeasureLengthOfTeeth>(),
    act::<setter::MeasureToolRadius>(),
    act::<setter::MeasureRadiiOfTeeth>(),
    act::<setter::TakeRotatingRadius>(),
    act::<setter::CalibrateToolSetter>(),
    act::<setter::CalibrateToolSetterTurned>(),
    act::<setter::StoreToolSetterCalibration>(),
    act::<spindle::ReverseSpindle>(),
    act::<spindle::RestoreSpindleAndCoolant>(),
    act::<spindle::TurnSpindle>(),
    act::<spindle::ExecuteMFunction>(),
    act::<spindle::KeepOrientationAngle>(),
    act::<program::CallProgram>(),
    act::<program::KeepTolerance>(),
    act::<program::TurningInsert>(),
];

/// The strategy of a name.
pub fn by_name(name: &str) -> Option<&'static Strategy> {
    STRATEGIES.iter().find(|strategy| strategy.name == name)
}

/// What a value measures that a definition keeps by name for a strategy that recalls it.
pub fn recalled(name: &str) -> Option<Quantity> {
    let recalling = STRATEGIES.iter().filter(|strategy| strategy.name.starts_with("recall-"));
    recalling.flat_map(|strategy| strategy.outputs).find(|output| output.name == name).map(|output| output.quantity)
}

/// The most names that are offered for one that nothing has.
const OFFERED: usize = 3;

/// The names that are most like one that nothing has, the nearest first.
pub fn near(name: &str) -> Vec<&'static str> {
    let known = STRATEGIES.iter().map(|strategy| strategy.name);
    let mut found: Vec<(usize, &str)> = known.map(|known| (difference(name, known), known)).collect();
    found.sort_unstable();
    found.into_iter().map(|(_, known)| known).take(OFFERED).collect()
}

/// How many letters must be added, left out or changed for one name to become the other.
fn difference(one: &str, other: &str) -> usize {
    let other: Vec<char> = other.chars().collect();
    let mut row: Vec<usize> = (0..=other.len()).collect();
    for (count, letter) in one.chars().enumerate() {
        let mut corner = std::mem::replace(&mut row[0], count + 1);
        for (at, known) in other.iter().enumerate() {
            let changed = corner + usize::from(letter != *known);
            corner = row[at + 1];
            row[at + 1] = changed.min(row[at] + 1).min(corner + 1);
        }
    }
    row.last().copied().unwrap_or_default()
}
