# One file per rule, named after it.

# Text, parameters and files: AX1, AX2, AX4020, AX9.
set(axisc_rules_text_and_parameter
  rules/table.cpp
  rules/helpers.cpp
  rules/axis_type_mismatch.cpp
  rules/comment_in_string.cpp
  rules/comment_names_other_parameter.cpp
  rules/decimal_comma.cpp
  rules/duplicate_parameter.cpp
  rules/index_out_of_range.cpp
  rules/letter_case.cpp
  rules/limit_by_parameter.cpp
  rules/malformed_number.cpp
  rules/newer_than_build.cpp
  rules/out_of_data_range.cpp
  rules/out_of_range.cpp
  rules/references.cpp
  rules/string_too_long.cpp
  rules/suspicious_trailer.cpp
  rules/syntax_problems.cpp
  rules/unknown_parameter.cpp
  rules/unknown_symbol.cpp
  rules/wrong_type.cpp
)

# Filters and what was designed from them: AX3, AX6.
set(axisc_rules_filter
  filter_designs.cpp
  filter_view.cpp
  rules/allpass_prototype.cpp
  rules/bandstop_overshoot.cpp
  rules/blocks_constant_part.cpp
  rules/characteristic_frequency.cpp
  rules/delay_too_long.cpp
  rules/enabled_without_order.cpp
  rules/filter_order_for_type.cpp
  rules/filter_words.cpp
  rules/frequency_above_nyquist.cpp
  rules/frequency_zero.cpp
  rules/interface_disabled.cpp
  rules/interface_filter_invalid_default.cpp
  rules/long_settling.cpp
  rules/order_without_enable.cpp
  rules/overshooting_prototype.cpp
  rules/peak_gain.cpp
  rules/share_zero.cpp
  rules/stability_reserve.cpp
  rules/step_overshoot.cpp
  rules/time_constant_below_cycle.cpp
  rules/undocumented_type.cpp
  rules/unused_parameter.cpp
)

# Linear-phase filters: HSC and FIR.
set(axisc_rules_kernel
  fir_view.cpp
  hsc_view.cpp
  rules/delay_not_last.cpp
  rules/fir_activation.cpp
  rules/fir_conflicts.cpp
  rules/fir_delay_share.cpp
  rules/fir_order_time.cpp
  rules/hsc_enabled_permanently.cpp
  rules/hsc_order.cpp
  rules/hsc_place.cpp
  rules/hsc_prototype_and_type.cpp
  rules/novib_frequency_too_low.cpp
)

# Improved Position Control.
set(axisc_rules_position_control
  position_control_view.cpp
  rules/position_control_damping.cpp
  rules/position_control_drive.cpp
  rules/position_control_effect.cpp
  rules/position_control_frequencies.cpp
  rules/position_control_missing.cpp
  rules/position_control_spelling.cpp
)

# Several axes together: AX4.
set(axisc_rules_machine
  axis_delay.cpp
  rules/axis_number.cpp
  rules/gantry_broken.cpp
  rules/gantry_position_control.cpp
  rules/group_delay.cpp
)

# NC programs and their commands: AX5.
set(axisc_rules_program
  rules/acc_fact_needs_weight.cpp
  rules/axis_exchange_disables.cpp
  rules/command_mistakes.cpp
  rules/commands_newer_than_build.cpp
  rules/filter_and_vibration_guard.cpp
  rules/filter_keyword.cpp
  rules/filter_syntax.cpp
  rules/filter_with_guard_in_list.cpp
  rules/filter_without_order.cpp
  rules/filter_without_type.cpp
  rules/guard_with_fir_in_list.cpp
  rules/hsc_without_preconfiguration.cpp
  rules/program_helpers.cpp
)
