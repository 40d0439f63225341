//! The rules, one file each.
mod allowance_left;
mod approach_twice;
mod approach_without_compensation;
mod approach_wrong;
mod arc_direction_missing;
mod arc_direction_wrong;
mod arc_in_unequal_scaling;
mod arc_too_narrow;
mod arc_without_tangent;
mod arc_wrong;
mod axis_twice;
mod back_boring_inside;
mod begin_end_mismatch;
mod blank_wrong;
mod block_numbers;
mod blocks_after_end;
mod branch_runs_on;
mod call_of_def_active_cycle;
mod called_but_not_defined;
mod called_program_in_other_unit;
mod called_program_missing;
mod called_program_wants;
mod centre_in_other_plane;
mod chamfer_wrong_side;
mod choice_not_offered;
mod circle_point_wrong;
mod clearance_height_too_low;
mod comment_contradicts;
mod compensation_at_cycle;
mod compensation_left_on;
mod compensation_missing;
mod compensation_on_arc;
mod compensation_other_side;
mod compensation_switched;
mod contour_at_rapid;
mod contour_crossed;
mod contour_data_missing;
mod contour_def_wrong;
mod contour_depth_missing;
mod contour_depths_differ;
mod contour_not_selected;
mod contour_returns;
mod contour_undeclared;
mod contour_wrong;
mod coolant_forgotten;
mod coordinate_out_of_place;
mod coordinate_out_of_range;
mod core_hole_too_large;
mod core_hole_too_small;
mod corner_wrong;
mod correction_wrong;
mod cutting_speed_unlimited;
mod cutting_speed_unusual;
mod cutting_without_tool;
mod cycle_line_empty;
mod cycle_line_missing;
mod cycle_line_twice;
mod cycle_line_zero_missing;
mod cycle_not_covered;
mod cycle_not_described;
mod cycle_not_on_control;
mod cycle_of_previous_tool;
mod datum_table_late;
mod decimal_comma;
mod defined_but_never_called;
mod definitions_differ;
mod deviation_compared;
mod differs_from_other_control;
mod digitizing_wrong;
mod division_by_zero;
mod doubtful_value;
mod duplicate_parameter;
mod early_cycle_wrong;
mod empty_word;
mod error_branch_entered;
mod feed_missing;
mod feed_negative;
mod feed_unit;
mod feed_zero;
mod field_word_missing;
mod finishing_before_roughing;
mod finishing_tool_too_wide;
mod formula_wrong;
mod free_contour_wrong;
mod function_misspelled;
mod function_not_on_control;
mod functions_contradict;
mod global_def_wrong;
mod guard;
mod helix_too_steep;
mod hole_outside_blank;
mod holes_differ;
mod holes_overlap;
mod incremental_left_on;
mod insert_points_away;
mod iso_incomplete;
mod label_duplicate;
mod label_of_another_language;
mod label_of_another_parameter;
mod label_twice;
mod label_undefined;
mod label_unused;
mod languages_mixed;
mod loop_endless;
mod loop_runs_once;
mod machine_coordinates_compensated;
mod machine_coordinates_missing;
mod machine_limit;
mod machining_outside_blank;
mod main_runs_into_subprogram;
mod meaningless_value;
mod measuring_height_above_surface;
mod measuring_height_below_floor;
mod metric_values_in_inch;
mod milling_deeper_than_edges;
mod mirror_of_tool_axis;
mod misordered_parameter;
mod missing_parameter;
mod modal_call_left_on;
mod mode_wrong;
mod monitored_tool_idle;
mod name_of_another_cycle;
mod no_result;
mod no_table_open;
mod nominal_differs;
mod not_a_program;
mod nothing_left;
mod number_does_not_exist;
mod older_parameter_set;
mod out_of_range;
mod out_of_usual_range;
mod parameter_of_later_software;
mod parameter_unassigned;
mod parameter_unused;
mod path_not_closed;
mod path_twice;
mod pattern_combination;
mod pattern_missing;
mod pattern_not_called;
mod pattern_wrong;
mod pilot_hole_elsewhere;
mod pilot_hole_too_shallow;
mod plane_incomplete;
mod plane_left_on;
mod plane_not_positioned;
mod plane_not_reset;
mod plunge_beside_hole;
mod plunge_too_fast;
mod pole_missing;
mod polygon_incomplete;
mod position_after_contour;
mod position_missing;
mod position_twice;
mod position_without_call;
mod preset_row_wrong;
mod probe_while_turning;
mod probed_axis_missing;
mod probing_direction_wrong;
mod probing_place_wrong;
mod program_begin_missing;
mod program_begin_twice;
mod program_calls_itself;
mod program_empty;
mod program_end_missing;
mod program_not_selected;
mod programs_call_in_circle;
mod radius_missing;
mod rapid_into_blank;
mod reaming_wrong;
mod repeat_count_wrong;
mod repeat_of_later_label;
mod repeat_without_effect;
mod repeated_infeed;
mod reserved_parameter;
mod reset_order_wrong;
mod result_of_other_axis;
mod retract_missing;
mod rotary_axis_jumps;
mod rough_out_tool_other;
mod row_not_in_table;
mod same_datum_twice;
mod selected_table_missing;
mod shift_in_tilted_plane;
mod slot_too_narrow;
mod speed_and_feed_exchanged;
mod speed_missing;
mod speed_out_of_range;
mod spindle_direction;
mod spindle_off;
mod spindle_start_wrong;
mod sql_handle_missing;
mod stepover_too_wide;
mod stud_in_solid;
mod subprogram_end_without_label;
mod subprogram_recursive;
mod subprogram_runs_on;
mod subprogram_without_end;
mod surface_wrong;
mod tap_without_hole;
mod tcpm_left_on;
mod tcpm_missing;
mod text_for_number;
mod text_wrong;
mod thread_pitch_unusual;
mod tilted_work;
mod tool_axis_missing;
mod tool_axis_other;
mod tool_called_twice;
mod tool_cuts_sideways;
mod tool_definition_wrong;
mod tool_feed_missing;
mod tool_missing;
mod tool_not_changed;
mod tool_not_listed;
mod tool_radius_outdated;
mod tool_table_contradicts;
mod tool_unused;
mod tool_zero;
mod transfer_parameter_overwritten;
mod transformation_forbidden;
mod transformation_left_on;
mod transformation_without_effect;
mod turned_contour_wrong;
mod turned_thread_wrong;
mod turning_start_wrong;
mod turning_system_missing;
mod two_signs;
mod uncalculable_contour;
mod unknown_cycle;
mod unknown_parameter;
mod unreachable;
mod value_unlike_others;
mod wall_left;
mod word_missing;
mod word_twice;
mod word_wrong;
mod wrong_tool_type;
mod wrong_value_kind;

use super::{Definition, Facts, Rule};
use crate::base::diag::Diagnostic;

/// All rules, in the order of their codes. The findings of `guard` have the codes of the
/// specifications' guards.
pub const RULES: &[&Rule] = &[
    &allowance_left::RULE,
    &approach_twice::RULE,
    &approach_without_compensation::RULE,
    &approach_wrong::RULE,
    &arc_direction_missing::RULE,
    &arc_direction_wrong::RULE,
    &arc_in_unequal_scaling::RULE,
    &arc_too_narrow::RULE,
    &arc_without_tangent::RULE,
    &arc_wrong::RULE,
    &axis_twice::RULE,
    &back_boring_inside::RULE,
    &begin_end_mismatch::RULE,
    &blank_wrong::RULE,
    &block_numbers::RULE,
    &blocks_after_end::RULE,
    &branch_runs_on::RULE,
    &call_of_def_active_cycle::RULE,
    &called_but_not_defined::RULE,
    &called_program_in_other_unit::RULE,
    &called_program_missing::RULE,
    &called_program_wants::RULE,
    &centre_in_other_plane::RULE,
    &chamfer_wrong_side::RULE,
    &choice_not_offered::RULE,
    &circle_point_wrong::RULE,
    &clearance_height_too_low::RULE,
    &comment_contradicts::RULE,
    &compensation_at_cycle::RULE,
    &compensation_left_on::RULE,
    &compensation_missing::RULE,
    &compensation_on_arc::RULE,
    &compensation_other_side::RULE,
    &compensation_switched::RULE,
    &contour_at_rapid::RULE,
    &contour_crossed::RULE,
    &contour_data_missing::RULE,
    &contour_def_wrong::RULE,
    &contour_depth_missing::RULE,
    &contour_depths_differ::RULE,
    &contour_not_selected::RULE,
    &contour_returns::RULE,
    &contour_undeclared::RULE,
    &contour_wrong::RULE,
    &coolant_forgotten::RULE,
    &coordinate_out_of_place::RULE,
    &coordinate_out_of_range::RULE,
    &core_hole_too_large::RULE,
    &core_hole_too_small::RULE,
    &corner_wrong::RULE,
    &correction_wrong::RULE,
    &cutting_speed_unlimited::RULE,
    &cutting_speed_unusual::RULE,
    &cutting_without_tool::RULE,
    &cycle_line_empty::RULE,
    &cycle_line_missing::RULE,
    &cycle_line_twice::RULE,
    &cycle_line_zero_missing::RULE,
    &cycle_not_covered::RULE,
    &cycle_not_described::RULE,
    &cycle_not_on_control::RULE,
    &cycle_of_previous_tool::RULE,
    &datum_table_late::RULE,
    &decimal_comma::RULE,
    &defined_but_never_called::RULE,
    &definitions_differ::RULE,
    &deviation_compared::RULE,
    &differs_from_other_control::RULE,
    &digitizing_wrong::RULE,
    &division_by_zero::RULE,
    &doubtful_value::RULE,
    &duplicate_parameter::RULE,
    &early_cycle_wrong::RULE,
    &empty_word::RULE,
    &error_branch_entered::RULE,
    &feed_missing::RULE,
    &feed_negative::RULE,
    &feed_unit::RULE,
    &feed_zero::RULE,
    &field_word_missing::RULE,
    &finishing_before_roughing::RULE,
    &finishing_tool_too_wide::RULE,
    &formula_wrong::RULE,
    &free_contour_wrong::RULE,
    &function_misspelled::RULE,
    &function_not_on_control::RULE,
    &functions_contradict::RULE,
    &global_def_wrong::RULE,
    &guard::RULE,
    &helix_too_steep::RULE,
    &hole_outside_blank::RULE,
    &holes_differ::RULE,
    &holes_overlap::RULE,
    &incremental_left_on::RULE,
    &insert_points_away::RULE,
    &iso_incomplete::RULE,
    &label_duplicate::RULE,
    &label_of_another_language::RULE,
    &label_of_another_parameter::RULE,
    &label_twice::RULE,
    &label_undefined::RULE,
    &label_unused::RULE,
    &languages_mixed::RULE,
    &loop_endless::RULE,
    &loop_runs_once::RULE,
    &machine_coordinates_compensated::RULE,
    &machine_coordinates_missing::RULE,
    &machine_limit::RULE,
    &machining_outside_blank::RULE,
    &main_runs_into_subprogram::RULE,
    &meaningless_value::RULE,
    &measuring_height_above_surface::RULE,
    &measuring_height_below_floor::RULE,
    &metric_values_in_inch::RULE,
    &milling_deeper_than_edges::RULE,
    &mirror_of_tool_axis::RULE,
    &misordered_parameter::RULE,
    &missing_parameter::RULE,
    &modal_call_left_on::RULE,
    &mode_wrong::RULE,
    &monitored_tool_idle::RULE,
    &name_of_another_cycle::RULE,
    &no_result::RULE,
    &no_table_open::RULE,
    &nominal_differs::RULE,
    &not_a_program::RULE,
    &nothing_left::RULE,
    &number_does_not_exist::RULE,
    &older_parameter_set::RULE,
    &out_of_range::RULE,
    &out_of_usual_range::RULE,
    &parameter_of_later_software::RULE,
    &parameter_unassigned::RULE,
    &parameter_unused::RULE,
    &path_not_closed::RULE,
    &path_twice::RULE,
    &pattern_combination::RULE,
    &pattern_missing::RULE,
    &pattern_not_called::RULE,
    &pattern_wrong::RULE,
    &pilot_hole_elsewhere::RULE,
    &pilot_hole_too_shallow::RULE,
    &plane_incomplete::RULE,
    &plane_left_on::RULE,
    &plane_not_positioned::RULE,
    &plane_not_reset::RULE,
    &plunge_beside_hole::RULE,
    &plunge_too_fast::RULE,
    &pole_missing::RULE,
    &polygon_incomplete::RULE,
    &position_after_contour::RULE,
    &position_missing::RULE,
    &position_twice::RULE,
    &position_without_call::RULE,
    &preset_row_wrong::RULE,
    &probe_while_turning::RULE,
    &probed_axis_missing::RULE,
    &probing_direction_wrong::RULE,
    &probing_place_wrong::RULE,
    &program_begin_missing::RULE,
    &program_begin_twice::RULE,
    &program_calls_itself::RULE,
    &program_empty::RULE,
    &program_end_missing::RULE,
    &program_not_selected::RULE,
    &programs_call_in_circle::RULE,
    &radius_missing::RULE,
    &rapid_into_blank::RULE,
    &reaming_wrong::RULE,
    &repeat_count_wrong::RULE,
    &repeat_of_later_label::RULE,
    &repeat_without_effect::RULE,
    &repeated_infeed::RULE,
    &reserved_parameter::RULE,
    &reset_order_wrong::RULE,
    &result_of_other_axis::RULE,
    &retract_missing::RULE,
    &rotary_axis_jumps::RULE,
    &rough_out_tool_other::RULE,
    &row_not_in_table::RULE,
    &same_datum_twice::RULE,
    &selected_table_missing::RULE,
    &shift_in_tilted_plane::RULE,
    &slot_too_narrow::RULE,
    &speed_and_feed_exchanged::RULE,
    &speed_missing::RULE,
    &speed_out_of_range::RULE,
    &spindle_direction::RULE,
    &spindle_off::RULE,
    &spindle_start_wrong::RULE,
    &sql_handle_missing::RULE,
    &stepover_too_wide::RULE,
    &stud_in_solid::RULE,
    &subprogram_end_without_label::RULE,
    &subprogram_recursive::RULE,
    &subprogram_runs_on::RULE,
    &subprogram_without_end::RULE,
    &surface_wrong::RULE,
    &tap_without_hole::RULE,
    &tcpm_left_on::RULE,
    &tcpm_missing::RULE,
    &text_for_number::RULE,
    &text_wrong::RULE,
    &thread_pitch_unusual::RULE,
    &tilted_work::RULE,
    &tool_axis_missing::RULE,
    &tool_axis_other::RULE,
    &tool_called_twice::RULE,
    &tool_cuts_sideways::RULE,
    &tool_definition_wrong::RULE,
    &tool_feed_missing::RULE,
    &tool_missing::RULE,
    &tool_not_changed::RULE,
    &tool_not_listed::RULE,
    &tool_radius_outdated::RULE,
    &tool_table_contradicts::RULE,
    &tool_unused::RULE,
    &tool_zero::RULE,
    &transfer_parameter_overwritten::RULE,
    &transformation_forbidden::RULE,
    &transformation_left_on::RULE,
    &transformation_without_effect::RULE,
    &turned_contour_wrong::RULE,
    &turned_thread_wrong::RULE,
    &turning_start_wrong::RULE,
    &turning_system_missing::RULE,
    &two_signs::RULE,
    &uncalculable_contour::RULE,
    &unknown_cycle::RULE,
    &unknown_parameter::RULE,
    &unreachable::RULE,
    &value_unlike_others::RULE,
    &wall_left::RULE,
    &word_missing::RULE,
    &word_twice::RULE,
    &word_wrong::RULE,
    &wrong_tool_type::RULE,
    &wrong_value_kind::RULE,
];

/// Looks at one definition.
pub(super) type Each = fn(&Rule, &Facts<'_>, &Definition<'_>, &mut Vec<Diagnostic>);

/// The rules that look at one definition after the other, with what they do: each definition is read once for all.
pub(super) const OF_DEFINITIONS: &[(&Rule, Each)] = &[
    (&choice_not_offered::RULE, choice_not_offered::each),
    (&clearance_height_too_low::RULE, clearance_height_too_low::each),
    (&cycle_line_empty::RULE, cycle_line_empty::each),
    (&duplicate_parameter::RULE, duplicate_parameter::each),
    (&field_word_missing::RULE, field_word_missing::each),
    (&guard::RULE, guard::each),
    (&label_of_another_language::RULE, label_of_another_language::each),
    (&label_of_another_parameter::RULE, label_of_another_parameter::each),
    (&misordered_parameter::RULE, misordered_parameter::each),
    (&missing_parameter::RULE, missing_parameter::each),
    (&older_parameter_set::RULE, older_parameter_set::each),
    (&out_of_range::RULE, out_of_range::each),
    (&out_of_usual_range::RULE, out_of_usual_range::each),
    (&parameter_of_later_software::RULE, parameter_of_later_software::each),
    (&text_wrong::RULE, text_wrong::each),
    (&label_twice::RULE, label_twice::each),
    (&unknown_parameter::RULE, unknown_parameter::each),
    (&wrong_value_kind::RULE, wrong_value_kind::each),
    // What is worse at the same place is reported before.
    (&doubtful_value::RULE, doubtful_value::each),
];

/// What those rules do by themselves: nothing.
fn together(_: &Rule, _: &Facts<'_>, _: &mut Vec<Diagnostic>) {}

/// The code of the rule whose findings have codes of their own.
pub(super) const GUARD: &str = guard::RULE.code;

pub(super) use not_a_program::whole as not_a_program;
