#include "codegen/runtime_host.hpp"

#include "codegen/image_fields.hpp"
#include "codegen/record.hpp"

#include <algorithm>
#include <utility>

namespace axisc::codegen {

RuntimeHost::RuntimeHost(AlignedBytes image, AlignedBytes memory, axisrt* runtime)
    : image_(std::move(image)), memory_(std::move(memory)), runtime_(runtime) {}

std::variant<RuntimeHost, axisrt_status> RuntimeHost::create(std::span<std::byte const> image,
                                                             std::optional<design::CycleTime> cycle_time) {
  AlignedBytes owned_image(image);
  axisrt_config config{};
  config.size = sizeof(axisrt_config);
  config.image = owned_image.data();
  config.image_size = owned_image.size();

  // Asks for the size first: it verifies the image, and only then the header may be read.
  std::size_t memory_size = 0;
  std::size_t alignment = 0;
  if (axisrt_status const status = axisrt_memory_size(&config, &memory_size, &alignment);
      status != AXISRT_OK) {
    return status;
  }
  config.cycle_time_ns =
      cycle_time ? cycle_time->nanoseconds
                 : ConstRecord<records::header>(owned_image.bytes()).get(fields::header::cycle_time_ns);

  AlignedBytes memory(memory_size);
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
    worst = std::max({worst, reset(axis, position), reset_interface(axis, position)});
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

std::variant<axisrt_axis_state, axisrt_status> RuntimeHost::axis_state(std::uint32_t axis) const {
  axisrt_axis_state state{};
  if (axisrt_status const status = axisrt_get_axis_state(runtime_, axis, &state); status != AXISRT_OK) {
    return status;
  }
  return state;
}

}  // namespace axisc::codegen
