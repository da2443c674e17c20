#include "codegen/control_records.hpp"

#include "codegen/velocity_scaling.hpp"

#include <optional>

namespace axisc::codegen {
namespace {

using machine::AxisConfiguration;

/// The stages' filters first: a record of a stage names them.
Range add_stages(std::uint32_t axis, machine::PositionControl const& control, FilterRecords& filters,
                 ImageTables& tables) {
  Range const range{.first = tables.stages.count(),
                    .count = static_cast<std::uint32_t>(control.stages.size())};
  for (machine::PositionControlStage const& stage : control.stages) {
    std::uint32_t const first_filter = tables.filters.count();
    if (stage.oscillator) filters.add(axis, *stage.oscillator);
    std::vector<machine::ConfiguredFilter> configured;
    for (design::FilterSpecification const& filter : stage.filters) {
      auto const place = static_cast<std::uint32_t>(configured.size() + (stage.oscillator ? 1 : 0));
      configured.push_back({.index = place, .specification = filter});
    }
    filters.add(axis, axim_port_velocity, configured);
    Record<records::stage> record = tables.stages.append();
    record.set(fields::stage::index, stage.index);
    record.set(fields::stage::mode, static_cast<std::uint32_t>(stage.mode));
    record.set(fields::stage::first_filter, first_filter);
    record.set(fields::stage::filter_count, tables.filters.count() - first_filter);
    record.set(fields::stage::weight, stage_weight(stage));
    record.set(fields::stage::weight_numerator, stage.weight_numerator);
    record.set(fields::stage::weight_denominator, stage.weight_denominator);
  }
  return range;
}

/// The axis whose stages give this axis' additive velocity; none where there is no Improved Position Control.
std::optional<std::size_t> source_of(machine::Machine const& machine, std::size_t axis) {
  auto const master = machine.axes[axis].gantry_master;
  std::size_t const source = master.value_or(axis);
  if (!machine.axes[source].position_control) return std::nullopt;
  return source;
}

void add_control(machine::Machine const& machine, std::uint32_t axis, std::size_t source,
                 FilterRecords& filters, ImageTables& tables) {
  AxisConfiguration const& configuration = machine.axes[axis];
  machine::PositionControl const& control = *machine.axes[source].position_control;
  Range const stages = source == axis ? add_stages(axis, control, filters, tables) : Range{};
  machine::DriveScaling const& scaling = configuration.drive_scaling;
  Record<records::control> record = tables.controls.append();
  record.set(fields::control::axis, axis);
  record.set(fields::control::source, static_cast<std::uint32_t>(source));
  record.set(fields::control::first_stage, stages.first);
  record.set(fields::control::stage_count, stages.count);
  record.set(fields::control::controller, static_cast<std::uint32_t>(scaling.controller));
  record.set(fields::control::time_base, scaling.time_base);
  record.set(fields::control::limit, velocity_limit(control, machine.axes[source].velocity_limit));
  record.set(fields::control::scale, increments_per_velocity(scaling, machine.cycle_time));
  record.set(fields::control::limit_factor, control.limit_factor);
  record.set(fields::control::v_reso_num, scaling.v_reso_num);
  record.set(fields::control::v_reso_denom, scaling.v_reso_denom);
  record.set(fields::control::multi_gain_z, scaling.multi_gain_z);
  record.set(fields::control::multi_gain_n, scaling.multi_gain_n);
}

}  // namespace

void add_control_records(machine::Machine const& machine, FilterRecords& filters, ImageTables& tables) {
  for (std::uint32_t axis = 0; axis < machine.axes.size(); ++axis) {
    auto const source = source_of(machine, axis);
    if (source) add_control(machine, axis, *source, filters, tables);
  }
}

}  // namespace axisc::codegen
