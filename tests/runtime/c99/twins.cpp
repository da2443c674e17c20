#include "tests/runtime/c99/twins.hpp"

#include <algorithm>
#include <bit>

namespace axisc::test {

CRuntime::CRuntime(Bytes const& image) {
  // Exactly as long as the image, at an address that is a multiple of nothing.
  AlignedMemory bytes(image.size() + 1);
  std::copy(image.begin(), image.end(), bytes.data() + 1);
  std::size_t size = 0;
  status = axisrt_c_memory_size(bytes.data() + 1, image.size(), &size);
  if (status != AXISRT_C_OK) return;
  memory_ = std::make_unique<AlignedMemory>(size);
  status = axisrt_c_create(bytes.data() + 1, image.size(), memory_->data(), size, &runtime);
}

std::vector<std::uint8_t> CRuntime::block() const {
  return {memory_->data(), memory_->data() + memory_->size()};
}

void CRuntime::restore(std::vector<std::uint8_t> const& block) {
  std::copy(block.begin(), block.end(), memory_->data());
}

Twins::Twins(Bytes const& image)
    : cxx(image, static_cast<std::uint32_t>(peek(image, 32, 4)), AXISRT_LEVEL_PORTABLE), c(image) {
  compare("status of create", std::uint64_t{cxx.status}, std::uint64_t{c.status});
  if (!difference.empty() || c.runtime == nullptr) return;
  std::uint32_t const axes = axisrt_axis_count(cxx.runtime);
  compare("axes", std::uint64_t{axes}, std::uint64_t{axisrt_c_axis_count(c.runtime)});
  compare("groups", std::uint64_t{axisrt_group_count(cxx.runtime)}, std::uint64_t{groups()});
  for (std::uint32_t i = 0; i < axes; ++i) {
    compare("has interface", static_cast<std::uint64_t>(axisrt_has_interface(cxx.runtime, i)),
            static_cast<std::uint64_t>(axisrt_c_has_interface(c.runtime, i)));
    compare("has position control", static_cast<std::uint64_t>(axisrt_has_position_control(cxx.runtime, i)),
            static_cast<std::uint64_t>(axisrt_c_has_position_control(c.runtime, i)));
  }
  for (auto* one : {&out_, &out_c_, &increments_, &increments_c_}) one->resize(axes);
  for (auto* one : {&status_, &status_c_}) one->resize(axes);
  bank_.resize(groups());
}

void Twins::compare(char const* what, double cxx_value, double c_value) {
  compare(what, std::bit_cast<std::uint64_t>(cxx_value), std::bit_cast<std::uint64_t>(c_value));
}

void Twins::compare(char const* what, std::uint64_t cxx_value, std::uint64_t c_value) {
  values += 1;
  if (cxx_value == c_value || !difference.empty()) return;
  difference = std::string(what) + ": " + std::to_string(cxx_value) + " in axisrt, " +
               std::to_string(c_value) + " in axisrt_c";
}

void Twins::compare_ports(char const* what, axisrt_status cxx_status, axisrt_c_status c_status) {
  compare(what, std::uint64_t{cxx_status}, std::uint64_t{c_status});
  for (std::uint32_t i = 0; i < axes(); ++i) {
    compare(what, out_[i], out_c_[i]);
    compare(what, std::uint64_t{status_[i]}, std::uint64_t{status_c_[i]});
  }
}

void Twins::reset(std::uint32_t axis, double position) {
  compare("reset", std::uint64_t{axisrt_reset(cxx.runtime, axis, position)},
          std::uint64_t{axisrt_c_reset(c.runtime, axis, position)});
}

void Twins::reset_interface(std::uint32_t axis, double value) {
  compare("reset_interface", std::uint64_t{axisrt_reset_interface(cxx.runtime, axis, value)},
          std::uint64_t{axisrt_c_reset_interface(c.runtime, axis, value)});
}

void Twins::reset_velocity(std::uint32_t axis, double v_set, double v_motor, double v_direct) {
  compare("reset_velocity", std::uint64_t{axisrt_reset_velocity(cxx.runtime, axis, v_set, v_motor, v_direct)},
          std::uint64_t{axisrt_c_reset_velocity(c.runtime, axis, v_set, v_motor, v_direct)});
}

void Twins::rebase(std::uint32_t axis, double offset) {
  compare("rebase", std::uint64_t{axisrt_rebase(cxx.runtime, axis, offset)},
          std::uint64_t{axisrt_c_rebase(c.runtime, axis, offset)});
}

void Twins::step_velocity(std::vector<double> const& in) {
  std::vector<double> const motor(in.rbegin(), in.rend());
  axisrt_velocities velocities{};
  velocities.size = sizeof velocities;
  velocities.v_set = in.data();
  velocities.v_motor = motor.data();
  bool const has_direct = values % 2 == 0;
  velocities.v_direct = has_direct ? in.data() : nullptr;
  axisrt_status const status =
      axisrt_step_velocity(cxx.runtime, &velocities, out_.data(), increments_.data(), status_.data());
  compare_ports("velocity", status,
                axisrt_c_step_velocity(c.runtime, in.data(), motor.data(), has_direct ? in.data() : nullptr,
                                       out_c_.data(), increments_c_.data(), status_c_.data()));
  for (std::uint32_t i = 0; i < axes(); ++i) compare("increments", increments_[i], increments_c_[i]);
}

void Twins::step(std::vector<double> const& in) {
  axisrt_status status = axisrt_step(cxx.runtime, in.data(), out_.data(), status_.data());
  compare_ports("setpoint", status, axisrt_c_step(c.runtime, in.data(), out_c_.data(), status_c_.data()));
  status = axisrt_step_interface(cxx.runtime, in.data(), out_.data(), status_.data());
  compare_ports("interface", status,
                axisrt_c_step_interface(c.runtime, in.data(), out_c_.data(), status_c_.data()));
  step_velocity(in);
  for (std::uint32_t i = 0; i < groups(); ++i) {
    compare("busy cycles", std::uint64_t{axisrt_busy_cycles(cxx.runtime, i)},
            std::uint64_t{axisrt_c_busy_cycles(c.runtime, i)});
  }
  for (std::uint32_t i = 0; i < axes(); ++i) {
    axisrt_axis_state const state = cxx.state(i);
    axisrt_c_axis_state state_c{};
    axisrt_c_get_axis_state(c.runtime, i, &state_c);
    compare("unfiltered", state.unfiltered, state_c.unfiltered);
    compare("filtered", state.filtered, state_c.filtered);
    compare("kernel", std::uint64_t{state.kernel}, std::uint64_t{state_c.kernel});
    compare("fading", std::uint64_t{state.fading}, std::uint64_t{state_c.fading});
    compare("settled", std::uint64_t{state.settled}, std::uint64_t{state_c.settled});
    compare("reset done", std::uint64_t{state.reset_done}, std::uint64_t{state_c.reset_done});
  }
}

/// The command of axisrt names the parameters of the bank whose number axisrt_c gets.
void Twins::command(std::uint32_t group, axisrt_c_action action, std::uint32_t bank) {
  axisrt_c_bank_parameters parameters{};
  axisrt_c_get_bank(c.runtime, group, bank, &parameters);
  axisrt_filter_command command{
      .size = sizeof command,
      .action = static_cast<std::uint32_t>(action == AXISRT_C_GUARD_OFF ? AXISRT_C_OFF : action),
      .keywords = parameters.keywords,
      .order = parameters.order,
      .share = parameters.share,
      .fcut = parameters.frequency,
      .quality = parameters.quality};
  if (action == AXISRT_C_GUARD_OFF) command.keywords = AXISRT_KEYWORD_GUARD;
  if (action == AXISRT_C_OFF) command.keywords = 0;
  // SET adds to the keywords of the bank before: here they all are among those of the new one, or none
  // counts.
  axisrt_c_bank_parameters before{};
  axisrt_c_get_bank(c.runtime, group, bank_[group], &before);
  bool const hsc = (parameters.keywords & AXISRT_KEYWORD_HSC) != 0;
  bool const other_command = ((parameters.keywords ^ before.keywords) & AXISRT_KEYWORD_GUARD) != 0;
  bool const adds = action == AXISRT_C_SET && !hsc && !other_command;
  if (adds && (before.keywords & ~parameters.keywords) != 0) return;
  axisrt_status const status = axisrt_command(cxx.runtime, group, &command);
  compare("command", std::uint64_t{status}, std::uint64_t{axisrt_c_command(c.runtime, group, action, bank)});
  commands_done += 1;
  if (status != AXISRT_OK) return;
  if (action == AXISRT_C_PROGRAM_END) bank_[group] = 0;
  if ((action == AXISRT_C_ON || action == AXISRT_C_SET) && !hsc) bank_[group] = bank;
}

}  // namespace axisc::test
