//! Every strategy that the engine has: one line each.
//!
//! Plans are compiled by this list, and executed through it. Invariant: a name that is not here is a mistake.
use glam::DVec3;

use super::action::{Action, Control};
use super::alignment::{basic_rotation, datum, rotary, tilting};
use super::calculation::Calculation;
use super::contour::{self, contour_train, cylinder, walls};
use super::contour::{Contours, OverContours};
use super::digitizing::{self, contour_lines};
use super::kinematics::{self, memory};
use super::milling::Milling;
use super::pen::{Cutter, Path};
use super::probing::{self, measure, tool_setter};
use super::shape::{engraving, face, plunge, pocket_and_slot, stud, thread};
use super::signature::{Given, Output, Parameter, Results};
use super::{program, spindle, turning};
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
    act::<basic_rotation::ResetBasicRotation>(),
    act::<basic_rotation::WriteBasicRotation>(),
    act::<basic_rotation::TurnBasicRotation>(),
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
    mill::<pocket_and_slot::ClearRectangleLevel>(),
    mill::<pocket_and_slot::ClearCircleLevel>(),
    mill::<pocket_and_slot::ClearSlotLevel>(),
    mill::<pocket_and_slot::ClearCircularSlotLevel>(),
    mill::<pocket_and_slot::FinishRectangleSide>(),
    mill::<pocket_and_slot::FinishCircleSide>(),
    mill::<pocket_and_slot::FinishSlotSide>(),
    mill::<pocket_and_slot::FinishCircularSlotSide>(),
    mill::<pocket_and_slot::FinishRectangleFloor>(),
    mill::<pocket_and_slot::FinishCircleFloor>(),
    mill::<pocket_and_slot::FinishSlotFloor>(),
    mill::<pocket_and_slot::FinishCircularSlotFloor>(),
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
    act::<walls::FindDepthsOfWall>(),
    act::<walls::FindPartialContours>(),
    calculate::<contour::StopDistance>(),
    mill_over::<contour::MoveOverInfeedPoint>(),
    mill_over::<contour::PlungeIntoRegion>(),
    mill_over::<contour::ClearRegionAtLevel>(),
    mill_over::<contour::ApproachRegionFloor>(),
    mill_over::<walls::FollowContourSide>(),
    calculate::<engraving::LayOutText>(),
    mill::<engraving::MoveOverGlyph>(),
    mill::<engraving::EngraveGlyph>(),
    act::<contour_train::FindContourStart>(),
    mill_over::<contour_train::MoveOverContourStart>(),
    mill_over::<contour_train::FollowContour>(),
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
    act::<turning::system::AlignTurningSystem>(),
    act::<turning::system::ReverseTurningTool>(),
    act::<turning::system::ResetTurningSystem>(),
    act::<turning::shoulder::TurnShoulder>(),
    mill_over::<turning::cuts::ClearTurningArea>(),
    mill_over::<turning::cuts::InfeedToTurningLevel>(),
    mill_over::<turning::cuts::RoughTurningLevel>(),
    mill_over::<turning::cuts::FollowTurnedContour>(),
    mill_over::<turning::cuts::LiftOffTurnedContour>(),
    mill_over::<turning::cuts::ReturnToStartOfCut>(),
    mill_over::<turning::cuts::ApproachTurningContour>(),
    mill_over::<turning::cuts::FinishTurnedContour>(),
    mill_over::<turning::cuts::RetractFromTurningContour>(),
    mill_over::<turning::cuts::ReturnToTurningStart>(),
    act::<turning::contour::AreaOfTurningContour>(),
    mill_over::<turning::contour::InfeedToParallelCut>(),
    mill_over::<turning::contour::CutParallelToContour>(),
    mill_over::<turning::contour::RetractFromParallelCut>(),
    mill_over::<turning::contour::ReturnToParallelCut>(),
    act::<turning::thread::ThreadLine>(),
    act::<turning::thread::ThreadOfContour>(),
    act::<turning::thread::ThreadInfeeds>(),
    mill_over::<turning::thread::ApproachThread>(),
    mill_over::<turning::thread::CutThreadPass>(),
    mill_over::<turning::thread::LiftOffThread>(),
    mill_over::<turning::thread::ReturnAlongThread>(),
    mill_over::<turning::thread::InfeedInThread>(),
    mill_over::<turning::thread::CutThreadAirPasses>(),
    act::<turning::groove_shape::RecessGroove>(),
    act::<turning::groove_shape::RecessGrooveOfContour>(),
    mill_over::<turning::recess::ClearGroove>(),
    mill_over::<turning::recess::MoveOverGroove>(),
    mill_over::<turning::recess::RecessPass>(),
    mill_over::<turning::recess::RecessToLevel>(),
    mill_over::<turning::recess::TurnRecessPass>(),
    mill_over::<turning::recess::LiftAndReturn>(),
    mill_over::<turning::recess::MoveToGrooveFlank>(),
    mill_over::<turning::recess::FollowGrooveWall>(),
    mill_over::<turning::recess::FinishGrooveFloor>(),
    mill_over::<turning::recess::FinishHalfOfGroove>(),
    mill_over::<turning::recess::FinishWholeGroove>(),
    mill_over::<turning::recess::LeaveGroove>(),
    mill_over::<turning::recess::ReturnFromGroove>(),
    act::<tilting::ComputeRotaryPositions>(),
    act::<tilting::PositionRotaryAxes>(),
    act::<tilting::CheckSpindleAcrossRotaryAxis>(),
    act::<tool_setter::ApproachToolSetter>(),
    act::<tool_setter::ApproachToolSetterSide>(),
    act::<tool_setter::MeasureToolLength>(),
    act::<tool_setter::MeasureLengthOfTeeth>(),
    act::<tool_setter::MeasureToolRadius>(),
    act::<tool_setter::MeasureRadiiOfTeeth>(),
    act::<tool_setter::TakeRotatingRadius>(),
    act::<tool_setter::CalibrateToolSetter>(),
    act::<tool_setter::CalibrateToolSetterTurned>(),
    act::<tool_setter::StoreToolSetterCalibration>(),
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
