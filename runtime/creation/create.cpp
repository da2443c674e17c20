#include "axisrt.h"
#include "runtime/configuration.hpp"
#include "runtime/control_word.hpp"
#include "runtime/creation/building.hpp"
#include "runtime/self_test.hpp"
#include "runtime/verification/signature.hpp"

namespace axisc::runtime {
namespace {

/// The caller's own function is called with the caller's control word.
axisrt_status open_configured(axisrt_config const& config, ImageView& view) {
  axisrt_status const status = check_signature(config);
  return status == AXISRT_OK ? verify_image(config.image, config.image_size, view) : status;
}

/// FNV-1a. Names may overlap, so that only this much of each is read.
uint64_t digest_of(uint8_t const* text, uint32_t size) {
  constexpr uint32_t most = 1024;
  uint64_t digest = 0xCBF2'9CE4'8422'2325U;
  for (uint32_t i = 0; i < size && i < most; ++i) digest = (digest ^ text[i]) * 0x100'0000'01B3U;
  return digest;
}

/// Limits per second, in um or 1e-3 degree and in mm or degree, become limits per cycle in units of 0.1 um or
/// 1e-4 degree.
void build_axes(ImageView const& view, Axis* axes) {
  double const T = view.header()[field::header::cycle_time_ns] * 1e-9;
  bool const has_bounds = view.bounds.first != nullptr;
  uint32_t next_bound = 0;
  for (uint32_t i = 0; i < view.axes.count; ++i) {
    Record<record::axis> const record = view.axes[i];
    uint32_t const name_offset = record[field::axis::name_offset];
    uint32_t const name_size = record[field::axis::name_size];
    axes[i] = {.name_offset = name_offset,
               .name_size = name_size,
               .name_digest = name_size > 0 ? digest_of(view.names.first + name_offset, name_size) : 0,
               .number = record[field::axis::number],
               .type = record[field::axis::type],
               .position_window = record[field::axis::position_window],
               .velocity_limit = record[field::axis::velocity_limit] * 10 * T,
               .acceleration_limit = record[field::axis::acceleration_limit] * 1e4 * T * T,
               .distance = has_bounds ? largest_bound(view, i, field::bound::distance_high, next_bound) : -1};
  }
}

axisrt* build(ImageView const& view, Instructions const& instructions, Layout const& layout, Memory memory) {
  build_axes(view, memory.part<Axis>(layout.axes));
  auto* const change = memory.part<Change>(layout.change);
  *change = {};
  change->shadow = memory.part<double>(layout.shadow);
  change->outputs = memory.part<double>(layout.changing_outputs);
  build_kernels(view, layout, memory);
  auto* const runtime = memory.part<axisrt>(layout.object);
  *runtime = {.memory_size = layout.size,
              .axis_count = view.axes.count,
              .cycle_time_ns = view.header()[field::header::cycle_time_ns],
              .kernel_count = view.kernels.count,
              .slot_count = view.slots.count,
              .channel_count = view.groups.count,
              .stage_count = view.stages.count,
              .control_count = view.controls.count,
              .image_version = view.header()[field::header::image_version],
              .payload_checksum = view.header()[field::header::payload_checksum],
              .header_checksum = view.header()[field::header::header_checksum],
              .instructions = &instructions,
              .names = view.names.first,
              .axes = memory.part<Axis>(layout.axes),
              .filters = memory.part<Filter>(layout.filters),
              .setpoint = build_port(view, PortKind::setpoint, instructions.lanes, layout, memory),
              .additional_interface =
                  build_port(view, PortKind::additional_interface, instructions.lanes, layout, memory),
              .velocity = build_port(view, PortKind::velocity, instructions.lanes, layout, memory),
              .kernels = memory.part<Kernel>(layout.kernels),
              .slots = memory.part<Slot>(layout.slots),
              .channels = memory.part<Channel>(layout.channels),
              .stages = memory.part<Stage>(layout.stages),
              .controls = memory.part<Control>(layout.controls),
              .stage_signals = {.in = memory.part<double>(layout.stage_in),
                                .out = memory.part<double>(layout.stage_out),
                                .status = memory.part<uint8_t>(layout.stage_status)},
              .additive_velocities = memory.part<double>(layout.additive_velocities),
              .change = change,
              .recorder = nullptr};
  limit_increments(view, *runtime);
  build_channels(view, layout, memory);
  build_controls(view, layout, memory);
  return runtime;
}

axisrt_status create(axisrt_config const& config, ImageView const& view, Block const& used,
                     Block const& used_too, axisrt*& runtime) {
  if (view.header()[field::header::cycle_time_ns] != config.cycle_time_ns) return AXISRT_OTHER_CYCLE_TIME;
  Instructions const* const instructions = find_instructions(config.level);
  if (instructions == nullptr) return AXISRT_NO_LEVEL;
  Layout const layout = lay_out(count_amounts(view, instructions->lanes));
  axisrt_status status = check_memory(config, layout.size);
  if (status != AXISRT_OK) return status;
  Block const memory{.first = config.memory, .size = layout.size};
  if (overlap(memory, used) || overlap(memory, used_too)) return AXISRT_BAD_ARGUMENT;
  axisrt* const built = build(view, *instructions, layout, {.bytes = static_cast<uint8_t*>(config.memory)});
  status = run_self_tests(view, *built);
  if (status == AXISRT_OK) runtime = built;
  return status;
}

}  // namespace

axisrt_status create_beside(axisrt_config const& config, Block const& used, Block const& used_too,
                            axisrt*& runtime) {
  ImageView view;
  axisrt_status const status = open_configured(config, view);
  if (status != AXISRT_OK) return status;
  return in_plain_arithmetic([&] { return create(config, view, used, used_too, runtime); });
}

}  // namespace axisc::runtime

axisrt_status axisrt_memory_size(axisrt_config const* config, size_t* bytes, size_t* alignment) {
  using namespace axisc::runtime;
  if (!is_known(config) || bytes == nullptr || alignment == nullptr) return AXISRT_BAD_ARGUMENT;
  ImageView view;
  axisrt_status const status = open_configured(*config, view);
  if (status != AXISRT_OK) return status;
  uint32_t const lanes = lanes_of_level(config->level);
  if (lanes == 0) return AXISRT_NO_LEVEL;
  uint64_t const size = in_plain_arithmetic([&] { return lay_out(count_amounts(view, lanes)).size; });
  if (size > SIZE_MAX) return AXISRT_MEMORY_TOO_SMALL;  // more than this processor can address
  *bytes = static_cast<size_t>(size);
  *alignment = AXISRT_ALIGNMENT;
  return AXISRT_OK;
}

axisrt_status axisrt_create(axisrt_config const* config, axisrt** runtime) {
  if (runtime == nullptr) return AXISRT_BAD_ARGUMENT;
  *runtime = nullptr;
  if (!axisc::runtime::is_known(config)) return AXISRT_BAD_ARGUMENT;
  return axisc::runtime::create_beside(*config, {}, {}, *runtime);
}
