//! The rules, one file each.
mod call_of_def_active_cycle;
mod called_but_not_defined;
mod choice_not_offered;
mod clearance_height_too_low;
mod cycle_not_described;
mod cycle_not_on_control;
mod defined_but_never_called;
mod duplicate_parameter;
mod guard;
mod label_of_another_language;
mod label_of_another_parameter;
mod misordered_parameter;
mod missing_parameter;
mod out_of_range;
mod spindle_off;
mod tool_missing;
mod unknown_cycle;
mod unknown_parameter;
mod wrong_value_kind;

use super::Rule;

/// All rules, in the order of their codes. The findings of `guard` have the codes of the
/// specifications' guards.
pub const RULES: &[&Rule] = &[
    &call_of_def_active_cycle::RULE,
    &called_but_not_defined::RULE,
    &choice_not_offered::RULE,
    &clearance_height_too_low::RULE,
    &cycle_not_described::RULE,
    &cycle_not_on_control::RULE,
    &defined_but_never_called::RULE,
    &duplicate_parameter::RULE,
    &guard::RULE,
    &label_of_another_language::RULE,
    &label_of_another_parameter::RULE,
    &misordered_parameter::RULE,
    &missing_parameter::RULE,
    &out_of_range::RULE,
    &spindle_off::RULE,
    &tool_missing::RULE,
    &unknown_cycle::RULE,
    &unknown_parameter::RULE,
    &wrong_value_kind::RULE,
];
