#include "image/runtime_host.hpp"

#include "codegen/image_fields.hpp"
#include "codegen/record.hpp"

#include <algorithm>
#include <utility>

namespace axisc::image {

std::size_t runtime_memory(std::span<std::byte const> image, std::uint32_t level) {
  codegen::AlignedBytes const aligned(image);
  axisrt_config config{};
  config.size = sizeof config;
  config.level = level;
  config.image = aligned.data();
  config.image_size = aligned.size();
  std::size_t size = 0;
  std::size_t alignment = 0;
  return axisrt_memory_size(&config, &size, &alignment) == AXISRT_OK ? size : 0;
}

RuntimeHost::RuntimeHost(codegen::AlignedBytes image, codegen::AlignedBytes memory, axisrt* runtime)
    : image_(std::move(image)), memory_(std::move(memory)), runtime_(runtime) {}

std::variant<RuntimeHost, axisrt_status> RuntimeHost::create(std::span<std::byte const> image,
                                                             std::optional<design::CycleTime> cycle_time,
                                                             std::uint32_t level) {
  codegen::AlignedBytes owned_image(image);
  axisrt_config config{};
  config.size = sizeof(axisrt_config);
  config.level = level;
  config.image = owned_image.data();
  config.image_size = owned_image.size();

  // Asks for the size first: it verifies the image, and only then the header may be read.
  std::size_t memory_size = 0;
  std::size_t alignment = 0;
  if (axisrt_status const status = axisrt_memory_size(&config, &memory_size, &alignment);
      status != AXISRT_OK) {
    return status;
  }
  config.cycle_time_ns = cycle_time ? cycle_time->nanoseconds
                                    : codegen::ConstRecord<codegen::records::header>(owned_image.bytes())
                                          .get(codegen::fields::header::cycle_time_ns);

  codegen::AlignedBytes memory(memory_size);
  config.memory = memory.data();
  config.memory_size = memory.size();
  axisrt* runtime = nullptr;
  if (axisrt_status const status = axisrt_create(&config, &runtime); status != AXISRT_OK) return status;
  return RuntimeHost(std::move(owned_image), std::move(memory), runtime);
}

std::string_view RuntimeHost::axis_name(std::uint32_t axis) const {
  std::size_t length = 0;
  char const* const name = axisrt_axis_name(runtime_, axis, &length);
  return {name, length};
}

axisrt_status RuntimeHost::reset_all(double position) {
  axisrt_status worst = AXISRT_OK;
  for (std::uint32_t axis = 0; axis < axis_count(); ++axis) {
    worst = std::max({worst, reset(axis, position), reset_interface(axis, position),
                      reset_velocity(axis, position, position, position)});
  }
  return worst;
}

bool RuntimeHost::fits(std::span<double const> in, std::span<double> out,
                       std::span<std::uint8_t> status) const {
  std::size_t const axes = axis_count();
  return in.size() == axes && out.size() == axes && (status.empty() || status.size() == axes);
}

axisrt_status RuntimeHost::step(std::span<double const> in, std::span<double> out,
                                std::span<std::uint8_t> status) {
  if (!fits(in, out, status)) return AXISRT_BAD_ARGUMENT;
  return axisrt_step(runtime_, in.data(), out.data(), status.empty() ? nullptr : status.data());
}

axisrt_status RuntimeHost::step_interface(std::span<double const> in, std::span<double> out,
                                          std::span<std::uint8_t> status) {
  if (!fits(in, out, status)) return AXISRT_BAD_ARGUMENT;
  return axisrt_step_interface(runtime_, in.data(), out.data(), status.empty() ? nullptr : status.data());
}

axisrt_status RuntimeHost::step_velocity(Velocities const& in, std::span<double> v_add,
                                         std::span<double> increments, std::span<std::uint8_t> status) {
  std::size_t const axes = axis_count();
  if (!fits(in.set, v_add, status) || in.motor.size() != axes || increments.size() != axes) {
    return AXISRT_BAD_ARGUMENT;
  }
  if (!in.direct.empty() && in.direct.size() != axes) return AXISRT_BAD_ARGUMENT;
  axisrt_velocities velocities{};
  velocities.size = sizeof velocities;
  velocities.v_set = in.set.data();
  velocities.v_motor = in.motor.data();
  velocities.v_direct = in.direct.empty() ? nullptr : in.direct.data();
  return axisrt_step_velocity(runtime_, &velocities, v_add.data(), increments.data(),
                              status.empty() ? nullptr : status.data());
}

axisrt_status RuntimeHost::command(std::uint32_t group, machine::FilterCommand const& command) {
  axisrt_filter_command words{};
  words.size = sizeof words;
  switch (command.filter_switch) {
    case machine::FilterSwitch::unchanged: words.action = AXISRT_ACTION_SET; break;
    case machine::FilterSwitch::on: words.action = AXISRT_ACTION_ON; break;
    case machine::FilterSwitch::off: words.action = AXISRT_ACTION_OFF; break;
  }
  machine::FilterParameters const& parameters = command.parameters;
  if (command.hsc) words.keywords |= AXISRT_KEYWORD_HSC;
  if (parameters.guard) words.keywords |= AXISRT_KEYWORD_GUARD;
  if (parameters.order) words.keywords |= AXISRT_KEYWORD_ORDER;
  if (parameters.share_percent) words.keywords |= AXISRT_KEYWORD_SHARE;
  if (parameters.frequency) words.keywords |= AXISRT_KEYWORD_FCUT;
  if (parameters.quality) words.keywords |= AXISRT_KEYWORD_QUALITY;
  words.order = parameters.order.value_or(0);
  words.share = parameters.share_percent.value_or(0);
  words.fcut = parameters.frequency.value_or(design::Hertz{0}).value;
  words.quality = parameters.quality.value_or(0);
  return axisrt_command(runtime_, group, &words);
}

axisrt_status RuntimeHost::end_program(std::uint32_t group) {
  axisrt_filter_command words{};
  words.size = sizeof words;
  words.action = AXISRT_ACTION_PROGRAM_END;
  return axisrt_command(runtime_, group, &words);
}

std::variant<axisrt_axis_state, axisrt_status> RuntimeHost::axis_state(std::uint32_t axis) const {
  axisrt_axis_state state{};
  if (axisrt_status const status = axisrt_get_axis_state(runtime_, axis, &state); status != AXISRT_OK) {
    return status;
  }
  return state;
}

axisrt_config RuntimeHost::configuration() const {
  axisrt_config config{};
  config.size = sizeof config;
  config.cycle_time_ns = axisrt_cycle_time_ns(runtime_);
  config.image = image_.data();
  config.image_size = image_.size();
  config.level = axisrt_level_of(runtime_);
  return config;
}

axisrt_status RuntimeHost::record(std::uint32_t cycles) {
  axisrt_recorder_stop(recorder_);
  axisrt_config config = configuration();
  std::size_t size = 0;
  axisrt_status const status = axisrt_recorder_size(runtime_, &config, cycles, &size);
  if (status != AXISRT_OK) return status;
  recorder_memory_ = codegen::AlignedBytes(size);
  config.memory = recorder_memory_.data();
  config.memory_size = recorder_memory_.size();
  return axisrt_recorder_start(runtime_, &config, cycles, &recorder_);
}

std::vector<std::byte> RuntimeHost::recording() const {
  std::size_t size = 0;
  static_cast<void>(axisrt_recorder_dump(recorder_, nullptr, 0, &size));
  std::vector<std::byte> bytes(size);
  static_cast<void>(axisrt_recorder_dump(recorder_, bytes.data(), bytes.size(), &size));
  return bytes;
}

}  // namespace axisc::image
