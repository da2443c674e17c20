#include "axisc/answers/dynamics/channel_values.hpp"

#include "axisc/answers/dynamics/driven_axis.hpp"
#include "diagnostics/format_number.hpp"

namespace axisc {

std::vector<ChannelValue> channel_values(machine::ChannelDynamics const& channel) {
  auto const flag = [](bool value) { return std::string(value ? "1" : "0"); };
  auto const& vector = channel.vector;
  return {{"P-CHAN-00071", "prog_start.slope.profile", std::string(slope_word(channel.slope))},
          {"P-CHAN-00349", "prog_start.slope.mode_ramp_time", flag(channel.constant_ramp_times)},
          {"P-CHAN-00001", "prog_start.slope.acceleration", std::to_string(channel.weighted_acceleration)},
          {"P-CHAN-00073", "prog_start.slope.ramp_time", std::to_string(channel.weighted_ramp)},
          {"P-CHAN-00009", "corr_v_trans_jerk", flag(channel.limits_curvature_steps)},
          {"P-CHAN-00117", "mode_trans_jerk", std::to_string(channel.transition_mode)},
          {"P-CHAN-00653", "configuration.interpolator.number_blocks_lah",
           std::to_string(channel.look_ahead_blocks)},
          {"P-CHAN-00235", "exact_stop_after_g00", flag(channel.stops_after_rapid)},
          {"P-CHAN-00090", "vector.velocity", format_exact(vector.velocity)},
          {"P-CHAN-00002", "vector.acceleration", format_exact(vector.acceleration)},
          {"P-CHAN-00208", "vector.deceleration", format_exact(vector.deceleration)},
          {"P-CHAN-00361", "vector.radial_acceleration", format_exact(vector.radial_acceleration)},
          {"P-CHAN-00350", "vector.cir_radial_acc_limit", flag(vector.limits_circles)},
          {"P-CHAN-00351", "vector.acc_dec_unit", vector.per_minute ? "MM_M2" : "MM_S2"}};
}

}  // namespace axisc
