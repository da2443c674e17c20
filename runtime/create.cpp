#include "axisrt.h"
#include "runtime/building.hpp"
#include "runtime/self_test.hpp"

namespace axisc::runtime {
namespace {

bool is_known(axisrt_config const* config) {
  return config != nullptr && config->size == sizeof(axisrt_config);
}

/// Parts of the memory from which filters take their own, one after the other.
struct FilterParts {
  Section const* sections;
  SectionState* states;
  uint32_t* ring_positions;
  Signal* ring_signals;
};

FilterKind kind_of(Record<record::filter> record) {
  switch (record[field::filter::realisation]) {
    case axim_realisation_sections:
      return record[field::filter::blocks_constant] != 0 ? FilterKind::blocking_sections
                                                         : FilterKind::passing_sections;
    case axim_realisation_delay:
      return record[field::filter::delay_cycles] > 0 ? FilterKind::delay : FilterKind::pass_through;
    default:
      return FilterKind::pass_through;
  }
}

void copy_sections(ImageView const& view, Section* sections) {
  for (uint32_t i = 0; i < view.coefficients.count; ++i) {
    Record<record::coefficients> const record = view.coefficients[i];
    sections[i] = {.p = record[field::coefficients::p],
                   .g = record[field::coefficients::p] + record[field::coefficients::q],
                   .k = record[field::coefficients::k],
                   .b = record[field::coefficients::b]};
  }
}

void make_filters(ImageView const& view, FilterParts parts, Filter* filters) {
  for (uint32_t i = 0; i < view.filters.count; ++i) {
    Record<record::filter> const record = view.filters[i];
    filters[i] = {.kind = kind_of(record),
                  .section_count = record[field::filter::section_count],
                  .delay_cycles = record[field::filter::delay_cycles],
                  .reserved = 0,
                  .sections = parts.sections + record[field::filter::first_section],
                  .states = parts.states,
                  .ring = parts.ring_signals,
                  .oldest = parts.ring_positions,
                  .share = record[field::filter::share],
                  .direct = record[field::filter::direct],
                  .direct_low = record[field::filter::direct_low]};
    parts.states += filters[i].section_count;
    parts.ring_signals += filters[i].delay_cycles;
    parts.ring_positions += 1;
  }
}

/// Chains claim the filters in order (verify has checked that), setpoint before additional interface.
void make_axes(ImageView const& view, Filter const* filters, Axis* axes, Chain* setpoint,
               Chain* additional_interface) {
  for (uint32_t i = 0; i < view.axes.count; ++i) {
    Record<record::axis> const record = view.axes[i];
    axes[i] = {.name_offset = record[field::axis::name_offset],
               .name_size = record[field::axis::name_size],
               .position_window = record[field::axis::position_window]};
    setpoint[i] = {.filters = filters,
                   .before = nullptr,
                   .behind = nullptr,
                   .filter_count = record[field::axis::filter_count],
                   .reserved = 0};
    filters += setpoint[i].filter_count;
    additional_interface[i] = {.filters = filters,
                               .before = nullptr,
                               .behind = nullptr,
                               .filter_count = record[field::axis::interface_filter_count],
                               .reserved = 0};
    filters += additional_interface[i].filter_count;
  }
}

/// An axis without a filter on its additional interface has nothing to reset there.
void make_states(ImageView const& view, Chain const* interface_chains, ChainState* setpoint,
                 ChainState* additional_interface) {
  for (uint32_t i = 0; i < view.axes.count; ++i) {
    setpoint[i] = ChainState{};
    additional_interface[i] = ChainState{};
    additional_interface[i].reset_done = interface_chains[i].filter_count == 0 ? all_set : 0;
  }
}

axisrt* build(ImageView const& view, Layout const& layout, Memory memory) {
  auto* const sections = memory.part<Section>(layout.sections);
  auto* const filters = memory.part<Filter>(layout.filters);
  auto* const axes = memory.part<Axis>(layout.axes);
  auto* const setpoint_chains = memory.part<Chain>(layout.setpoint_chains);
  auto* const interface_chains = memory.part<Chain>(layout.interface_chains);
  auto* const setpoint_states = memory.part<ChainState>(layout.setpoint_states);
  auto* const interface_states = memory.part<ChainState>(layout.interface_states);

  copy_sections(view, sections);
  make_filters(view,
               {.sections = sections,
                .states = memory.part<SectionState>(layout.section_states),
                .ring_positions = memory.part<uint32_t>(layout.ring_positions),
                .ring_signals = memory.part<Signal>(layout.ring_signals)},
               filters);
  make_axes(view, filters, axes, setpoint_chains, interface_chains);
  make_states(view, interface_chains, setpoint_states, interface_states);
  build_kernels(view, layout, memory);
  build_slots(view, layout, memory);
  build_groups(view, layout, memory);
  build_controls(view, layout, memory);

  auto* const runtime = memory.part<axisrt>(layout.object);
  *runtime = {.axis_count = view.axes.count,
              .filter_count = view.filters.count,
              .cycle_time_ns = view.header()[field::header::cycle_time_ns],
              .kernel_count = view.kernels.count,
              .slot_count = view.slots.count,
              .group_count = view.groups.count,
              .control_count = view.controls.count,
              .reserved = 0,
              .names = view.names.first,
              .axes = axes,
              .filters = filters,
              .setpoint = {.chains = setpoint_chains, .states = setpoint_states},
              .additional_interface = {.chains = interface_chains, .states = interface_states},
              .kernels = memory.part<Kernel>(layout.kernels),
              .slots = memory.part<Slot>(layout.slots),
              .groups = memory.part<Group>(layout.groups),
              .controls = memory.part<Control>(layout.controls),
              .additive_velocities = memory.part<double>(layout.additive_velocities)};
  return runtime;
}

axisrt_status check_memory(axisrt_config const& config, Layout const& layout) {
  if (config.memory == nullptr) return AXISRT_BAD_ARGUMENT;
  if (reinterpret_cast<uintptr_t>(config.memory) % AXISRT_ALIGNMENT != 0) return AXISRT_MISALIGNED;
  return config.memory_size < layout.size ? AXISRT_MEMORY_TOO_SMALL : AXISRT_OK;
}

axisrt_status create(axisrt_config const& config, axisrt*& runtime) {
  ImageView view;
  axisrt_status status = verify_image(config.image, config.image_size, view);
  if (status != AXISRT_OK) return status;
  if (view.header()[field::header::cycle_time_ns] != config.cycle_time_ns) return AXISRT_OTHER_CYCLE_TIME;
  Layout const layout = lay_out(count_amounts(view));
  status = check_memory(config, layout);
  if (status != AXISRT_OK) return status;
  axisrt* const built = build(view, layout, {.bytes = static_cast<uint8_t*>(config.memory)});
  status = run_self_tests(view, *built);
  if (status == AXISRT_OK) runtime = built;
  return status;
}

}  // namespace
}  // namespace axisc::runtime

axisrt_status axisrt_memory_size(axisrt_config const* config, size_t* bytes, size_t* alignment) {
  using namespace axisc::runtime;
  if (!is_known(config) || bytes == nullptr || alignment == nullptr) return AXISRT_BAD_ARGUMENT;
  ImageView view;
  axisrt_status const status = verify_image(config->image, config->image_size, view);
  if (status != AXISRT_OK) return status;
  uint64_t const size = lay_out(count_amounts(view)).size;
  if (size > SIZE_MAX) return AXISRT_MEMORY_TOO_SMALL;  // more than this processor can address
  *bytes = static_cast<size_t>(size);
  *alignment = AXISRT_ALIGNMENT;
  return AXISRT_OK;
}

axisrt_status axisrt_create(axisrt_config const* config, axisrt** runtime) {
  if (runtime == nullptr) return AXISRT_BAD_ARGUMENT;
  *runtime = nullptr;
  if (!axisc::runtime::is_known(config)) return AXISRT_BAD_ARGUMENT;
  return axisc::runtime::create(*config, *runtime);
}
