#include "configuration/list_kind.hpp"

#include "diagnostics/ascii.hpp"
#include "grammar/axis_list.hpp"
#include "schema/catalogue.hpp"

#include <algorithm>

namespace axisc::configuration {
namespace {

struct KindRow {
  ListKind kind{};
  std::string_view family;    ///< of its parameters' numbers: CHAN in P-CHAN-00035
  std::string_view segments;  ///< with which names of no other kind begin
};

constexpr KindRow rows[] = {
    {.kind = ListKind::axis, .family = "AXIS", .segments = ""},
    {.kind = ListKind::startup,
     .family = "STUP",
     .segments =
         "achs_kw achs_kw_log_ax_nr achs_mds ads_32_bit_comp_mode at_tslot_type average_time_window "
         "cam_table_loader cam_table_storage_size common_d_t_request contour_visu_ifc_version ctm_ddl ctm_nr "
         "default_achs_mds default_sda_mds digital_driver digital_driver_adr digital_driver_irq enable_scene "
         "error_ao_name error_log_file_max_size error_log_file_name error_message_texts "
         "error_plc_wait_cycles "
         "error_protocol_mode error_text_cycles_of_id error_text_of_id error_text_user_of_id ext_var_max "
         "ext_var_struct_member_alignment fb_storage_size gui_mode hand_mds history_filename hmi "
         "hw_configuration_list kanal_anzahl konf_path konfiguration listen local_hardware local_hardware_id "
         "local_hardware_name m_behavior mds_time_slots no_error_message_at_reset nullp_data number_device "
         "optical_intensity osaca_ao pfad plc_mode plcio_map plcopen_unit pzv_data remote_hardware "
         "rtconf_lis "
         "scene_mds scheduling_position_controller sda_mds sercos_hochlauf sercos_lwl_baudrate "
         "sercos_phase_switch_wait_cycles sercos_ring_anzahl single_protocol_fifo str_data techno_mds "
         "trace_axes_number trace_buffer_size trace_function use_tdp_interface ve_var vol_comp werkz_data "
         "zahl_ctm zahl_kw zahl_mds"},
    {.kind = ListKind::channel,
     .family = "CHAN",
     .segments =
         "absolute_orientation_kin_trafo_man_mode acs_section_add_tool_length aep auto_align_tracking_axis "
         "auto_disable_kin_trafo auto_enable_kin_trafo ax_default_config_after_reset "
         "ax_exchange_with_implicit_flush ax_offsets_with_active_kin backward_compatibility "
         "block_filter_tolerance block_search_restart_mode boolean_true_from_05 calc_average_feed_ahead "
         "cax_face_id caxtrack_dyn_improved channel_id channel_init_actpos_exclusive channel_name "
         "channel_number channel_type check_jerk_on_poly_path consider_rot_tracking_offset "
         "contour_processing_memory contouring_consider_inch conveyor_sync coordinate_system "
         "corr_v_trans_jerk "
         "create_cont_mask_warnings create_cycle_param_on_read curve_dynamic_weighting "
         "curve_dynamic_weighting_active cycle_changes_modal cycle_stack_add_var_count cycle_stack_memory "
         "d_clear_to_wzv d_prog_file dcc dec_max_ahead_protected default_ax_name_of_spindle "
         "default_id_of_kin_step dev_surface_5ax disable_chamfers_roundings disable_feed_factor "
         "display_diameter_pos display_pcs_limits display_top_coord_sys dist_ctrl dpl_tol_limit_change "
         "drive_cmd_use_physical_axis_number dyn_calc_axis_poly dynamic_calculation_kin_trafo_man_mode "
         "dynamic_weighting_active edge_machining einrechnen_mit_t einzelschrittmodus "
         "enable_mod_axis_always_shortest_way enable_time_based_lift enable_unit_feet_cut_speed "
         "encryption_extension err_outp_manual_mode_move esa eta exact_stop_after_g00 ext_wzv_vorhanden "
         "fast_tracking_transition feed_override_weight_dwell_time feed_to_weakest_axis filter_tracking_axis "
         "final_prog_file final_prog_file_mode forward_backward g00_override_mode g800_prog_file "
         "g80_prog_file "
         "g81_prog_file g82_prog_file g83_prog_file g84_prog_file g85_prog_file g86_prog_file g87_prog_file "
         "g88_prog_file g89_prog_file gap_in_trafo_axis_sequence geo_feed_adapt grp_anzahl gruppe "
         "h_default_outp_ax_name h_pre_outp h_prozess_zeit h_synch hli_input_disable_condition hsc hscs "
         "implicit_contour_masking in_position_ignored_movement independent_axis_error_stop "
         "ipo_start_wait_cycles jog_of_path_only kasto_multi_block kasto_prog_meas_trigger "
         "kasto_reject_rest_block kasto_relate_to_prog_contour kasto_remain_active kasto_residual_path "
         "kasto_suppress_path_check kasto_techno_output_with_signal kasto_warning_no_signal "
         "kasto_warning_residual_path kin_trafo_display kin_trafo_display_curr_pos "
         "kin_trafo_enable_cs_coord_display kind_of_2nd_ecs_ax kinematik_id lift_min_dist "
         "limit_no_path_reject_man_mode lin_aufloes log_number_tracking_axis m6_prog_file "
         "m_default_outp_ax_name m_h_pre_outp_calc_value_to_go m_h_pre_outp_nbr_block "
         "m_h_pre_outp_time_calc_mode m_pre_outp m_prozess_zeit m_synch mach_plane_of_2nd_ecs_ax "
         "main_spindle_ax_nr main_spindle_gear_change main_spindle_name makro_def man_mode mass_einh "
         "max_motion_blocks_ahead max_nc_blocks_ahead max_nck_plc_var max_plc_nck_var "
         "max_proz_radius_diff_circle max_radius_diff_circle max_time_ahead max_vb_override mdi_log_file "
         "mdi_log_file_max_size meas_all_axes meas_allow_actuated_probe meas_deceleration_mode "
         "meas_dont_allow_suspend_axis_output meas_error_no_move_path meas_error_no_signal "
         "meas_fixed_stop_no_error meas_pcs_value_no_probe_radius meas_soft_limit_move_path "
         "meas_trafo_with_cmd_pos meas_use_std_dynamic mirror_display_positions mirror_tool_offsets "
         "mittelpkt_diff mittelpkt_faktor modal_i_j_k_for_circle mode_exact_stop_indp_axis mode_feed_display "
         "mode_implicite_sync_indp_asyn_axis mode_trans_jerk move_tool_offsets_directly multi_axes_in_block "
         "multi_dimension_in_block multi_path_configuration no_init_prog_start no_init_prog_start_spdl "
         "opt_5ax_feed opt_contour_mode opt_insert_flush_continue opt_path_speed_tracking_axis ori "
         "ori_interpolation_mode ori_prog ori_rotation_angle ori_wcs output_block_length_zero override_delay "
         "override_v_handwheel override_weight_acc override_weight_prog_feed p_param_haltend "
         "parameter_change_during_execution path path_iteration_all_poly path_reject_std_manual_mode "
         "pattern_processing_memory permitted_trafo_deviation_limit plc_command_rapid_feed plcopen_std_unit "
         "position_lookahead_contour_path position_lookahead_distance post_segmentation_length "
         "pre_output_tolerance prog_start provide_channel_interface range_check_prog_soft_limits "
         "rel_offset_limits_std_manual_mode release_non_channel_axis remain_block_number_sub_prog_call "
         "remain_tool_length_in_ax reset_no_axis_to_axv resolution_factor retain_last_ax_config "
         "rot_axpair_exclusive rot_table_ax rpf_prozess_zeit rund_aufloes rund_mass_einh "
         "simu_ignore_internal_stop_cond simu_output_wcs soft_limit_tolerance soft_limit_warning_axes "
         "spdl_anzahl speed_limit_look_ahead spind_aufloes spindel spindle_m_fct_free start_init_prog_file "
         "start_init_prog_file_mode streaming_prog_file suppress_ax_group_in_pos_check "
         "suppress_cs_tracking_offset suppress_cycle_logging suppress_offsets_without_rotation "
         "suppress_prg_display_level suppress_soft_limit_monitoring_axes suppress_tracking_vec_limit "
         "suppress_trafo_curr_pos suppress_trafo_in_g0_blocks suppress_workspace_monitoring_manual_mode "
         "swe_limits_additive_manual_mode syn_chk synchro_data t_info_to_wzv t_with_implicit_flush "
         "t_with_tool_data_provide tapping thread_cutting time_override_weight_dwell_time "
         "tool_life_capture_all_movements tool_life_to_wzv tool_life_to_wzv_suppress_zero tool_life_with_d "
         "tool_ori_cs tracking_axis_rot_wc trafo_mode trafo_stack trafo_stack_name_active_prog_start "
         "trans_limit_with_curvature trc_circular_kerf_masking trc_inverse_display_pcs_pos tube_profile "
         "use_alias_name_in_ax_list use_drive_curr_limit vector versch_im_durchm wrk_im_kanal_vorhanden"},
    {.kind = ListKind::real_time,
     .family = "RTCF",
     .segments =
         "cycle_time external_object_name external_thread interrupt_source thread time_slice windows_time"},
    {.kind = ListKind::manual,
     .family = "MANU",
     .segments = "feedhold hr_anzahl hr_data move_limit_warning tasten_anzahl tasten_data"},
    {.kind = ListKind::tool, .family = "TOOL", .segments = "tool_data_with_id wz"},
    {.kind = ListKind::zero_offset, .family = "ZERO", .segments = "default_index g53_verfuegbar np_grp"},
    {.kind = ListKind::clamp_offset, .family = "CLMP", .segments = "pzv_grp"},
    {.kind = ListKind::compensation, .family = "COMP", .segments = "frict_comp kw"},
    {.kind = ListKind::external_variables,
     .family = "EXTV",
     .segments =
         "anzahl_belegt auto_memory_mode check_overlapping_variables name_rd_channel name_rd_channel_array "
         "name_rd_global name_rd_global_array name_wr_channel name_wr_channel_array name_wr_global "
         "name_wr_global_array use_extended_string_var var"},
    {.kind = ListKind::hardware, .family = "HWCF", .segments = ""},
    {.kind = ListKind::setting_control,
     .family = "SECO",
     .segments = "cnc_channel coll_log_file collision_def collision_pair gobject time_stamp"},
    {.kind = ListKind::volumetric_compensation,
     .family = "VOLC",
     .segments =
         "alternative_model associate_to_channel chain diagnosis_file enable_splicing file_format "
         "filter_steps "
         "manual_activation max_iterations negate set_to_zero trace_file use_axis_offsets workpiece_axes"},
    {.kind = ListKind::cycle_module, .family = "CMLD", .segments = "ddl"},
};
static_assert(std::size(rows) == list_kinds);

struct Segment {
  std::string_view text;
  ListKind kind{};
};

template <typename Visit>
constexpr void for_each_segment(Visit visit) {
  for (KindRow const& row : rows) {
    for (std::string_view rest = row.segments; !rest.empty();) {
      std::size_t const end = std::min(rest.find(' '), rest.size());
      visit(Segment{.text = rest.substr(0, end), .kind = row.kind});
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
}

constexpr std::size_t segment_count = [] {
  std::size_t count = 0;
  for_each_segment([&count](Segment const&) { ++count; });
  return count;
}();

constexpr bool comes_before(Segment const& a, Segment const& b) {
  return a.text < b.text;
}

/// In the order of their texts.
constexpr auto segment_table = [] {
  std::array<Segment, segment_count> table;
  std::size_t next = 0;
  for_each_segment([&](Segment const& segment) { table.at(next++) = segment; });
  std::sort(table.begin(), table.end(), comes_before);
  return table;
}();

std::string_view first_segment(std::string_view name) {
  return name.substr(0, name.find_first_of(".["));
}

/// Families that lists of other kinds have too.
bool is_shared(std::string_view segment) {
  constexpr std::array<std::string_view, 4> shared = {"customer", "dynamic_weighting", "error_filter",
                                                      "trafo"};
  return std::find(shared.begin(), shared.end(), segment) != shared.end();
}

std::optional<ListKind> kind_named_by(std::string_view name) {
  Segment const wanted{.text = first_segment(name)};
  auto const* const found =
      std::lower_bound(segment_table.begin(), segment_table.end(), wanted, comes_before);
  if (found == segment_table.end() || found->text != wanted.text) return std::nullopt;
  return found->kind;
}

}  // namespace

std::string number_prefix(ListKind kind) {
  return "P-" + std::string(rows[static_cast<std::size_t>(kind)].family);
}

std::optional<ListKind> kind_numbered_in(std::string_view comment) {
  constexpr std::string_view prefix = "P-";
  constexpr std::size_t family_size = 4;
  for (std::size_t at = comment.find(prefix); at != std::string_view::npos;
       at = comment.find(prefix, at + 1)) {
    std::string_view const family = comment.substr(at + prefix.size(), family_size);
    std::string_view const number =
        comment.substr(std::min(at + prefix.size() + family_size, comment.size()));
    if (number.size() < 2 || number[0] != '-' || !ascii::is_digit(number[1])) continue;
    auto const* const row = std::find_if(std::begin(rows), std::end(rows),
                                         [family](KindRow const& each) { return each.family == family; });
    if (row != std::end(rows)) return row->kind;
  }
  return std::nullopt;
}

void KindVote::known(std::string_view name) {
  std::string_view const segment = first_segment(name);
  if (segment == "kopf") {
    ++heads_;
  } else if (!is_shared(segment)) {
    ++votes_.front();
  }
}

void KindVote::unknown(std::string_view name, std::string_view comment) {
  auto kind = kind_numbered_in(comment);
  if (!kind) kind = kind_named_by(name);
  if (!kind) return;
  ++votes_.at(static_cast<std::size_t>(*kind));
  foreign_ += *kind == ListKind::axis ? 0 : 1;
}

bool KindVote::is_open() const {
  return std::all_of(votes_.begin(), votes_.end(), [](std::size_t votes) { return votes == 0; });
}

ListKind KindVote::winner() const {
  auto const* const most = std::max_element(votes_.begin(), votes_.end());
  auto const kind = static_cast<ListKind>(most - votes_.begin());
  bool const has_heads = kind == ListKind::compensation;
  return *most > votes_.front() + (has_heads ? 0 : heads_) ? kind : ListKind::axis;
}

std::optional<ListKind> decided_kind(SourceText const& list) {
  KindVote vote;
  for (grammar::Assignment const& line : grammar::parse_axis_list(list).assignments) {
    std::string_view const name = list.slice(line.name);
    if (schema::find_exact(name)) {
      vote.known(name);
    } else {
      vote.unknown(name, list.slice(line.trailer));
    }
  }
  if (vote.is_open()) return std::nullopt;
  return vote.winner();
}

}  // namespace axisc::configuration
