#include "codegen/image_writer.hpp"

#include "codegen/bound_records.hpp"
#include "codegen/control_records.hpp"
#include "codegen/filter_records.hpp"
#include "codegen/image_tables.hpp"
#include "codegen/kernel_records.hpp"
#include "codegen/source_digest.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace axisc::codegen {
namespace {

/// Rounded upwards, unless it is exact.
double product_above(double a, double b) {
  return a == 1 || b == 1 ? a * b : std::nextafter(a * b, HUGE_VAL);
}

class ImageBuilder {
 public:
  ImageBuilder(machine::Machine const& machine, ImageOptions const& options, KnownDesigns& designs)
      : machine_(machine),
        options_(options),
        designs_(designs),
        kernels_(designs, machine.cycle_time),
        filter_records_(tables_, designs, machine.cycle_time, options.strip) {}

  std::vector<std::byte> build() {
    KernelPlan const plan = plan_kernels(machine_, kernels_, [this](std::size_t axis) {
      return chain(machine_.axes[axis].filters).peak_gain;
    });
    for (machine::AxisConfiguration const& axis : machine_.axes) add_axis(axis);
    add_control_records(machine_, filter_records_, tables_);
    add_kernel_records(plan, kernels_, options_.strip, tables_);
    if (!options_.strip) {
      for (machine::MachineList const& list : machine_.lists) add_list(list);
      for (std::uint32_t axis = 0; axis < machine_.axes.size(); ++axis) add_values(axis);
    }
    ImageHeader header{.format_minor = format_minor(plan),
                       .cycle_time_ns = machine_.cycle_time.nanoseconds,
                       .axis_count = static_cast<std::uint32_t>(machine_.axes.size()),
                       .image_version = options_.image_version,
                       .source_digest = source_digest(machine_.lists),
                       .compiler_version = AXISC_VERSION};
    std::vector<std::byte> image = assemble_image(header, tables_.contents(options_.strip, false));
    if (!options_.bounds) return image;
    add_bound_records(image, tables_);
    header.format_minor = axim_minor;
    return assemble_image(header, tables_.contents(options_.strip, true));
  }

 private:
  /// Of an image without bounds, the least one whose readers execute it.
  [[nodiscard]] static std::uint16_t format_minor(KernelPlan const& plan) {
    constexpr std::uint16_t without_guards = 1;
    bool const has_guard = std::any_of(plan.slots.begin(), plan.slots.end(), [](PlannedSlot const& slot) {
      return slot.family == machine::KernelFamily::guard;
    });
    return has_guard ? std::uint16_t{axim_minor} : without_guards;
  }

  void add_axis(machine::AxisConfiguration const& axis) {
    std::uint32_t const axis_index = tables_.axes.count();
    Range const chain = filter_records_.add(axis_index, axim_port_setpoint, axis.filters);
    Range const interface_chain =
        filter_records_.add(axis_index, axim_port_interface, axis.interface_filters);
    ChainProof const proof = as_it_starts(axis);

    Record<records::axis> record = tables_.axes.append();
    if (!options_.strip) {
      TextRange const name = tables_.names.add(axis.name);
      record.set(fields::axis::name_offset, name.offset);
      record.set(fields::axis::name_size, name.size);
    }
    record.set(fields::axis::number, axis.number);
    record.set(fields::axis::type, static_cast<std::uint32_t>(axis.type));
    record.set(fields::axis::position_unit, axis.type == machine::AxisType::translatory ? 0U : 1U);
    record.set(fields::axis::first_filter, chain.first);
    record.set(fields::axis::filter_count, chain.count);
    record.set(fields::axis::first_interface_filter, interface_chain.first);
    record.set(fields::axis::interface_filter_count, interface_chain.count);
    record.set(fields::axis::position_window, axis.position_window);
    record.set(fields::axis::velocity_limit, axis.velocity_limit);
    record.set(fields::axis::acceleration_limit, axis.acceleration_limit);
    record.set(fields::axis::peak_gain, proof.peak_gain);
    record.set(fields::axis::delay_cycles, proof.delay_cycles);
  }

  /// {1, 0} for none.
  [[nodiscard]] ChainProof chain(std::span<machine::ConfiguredFilter const> filters) {
    if (filters.empty()) return {};
    std::vector<design::FilterSpecification> specifications;
    specifications.reserve(filters.size());
    for (machine::ConfiguredFilter const& filter : filters) specifications.push_back(filter.specification);
    return designs_.chain(specifications, machine_.cycle_time);
  }

  /// The standard filters, and the kernel that works from start-up.
  [[nodiscard]] ChainProof as_it_starts(machine::AxisConfiguration const& axis) {
    ChainProof proof = chain(axis.filters);
    if (!axis.kernel || !axis.kernel->on_at_start) return proof;
    std::uint32_t const kernel = kernels_.index_of(axis.kernel->specification);
    if (kernel == no_kernel) return proof;
    proof.peak_gain = product_above(proof.peak_gain, kernels_[kernel].proof.peak_gain);
    proof.delay_cycles += kernels_[kernel].design.group_delay_cycles;
    return proof;
  }

  void add_list(machine::MachineList const& list) {
    TextRange const name = tables_.names.add(list.name);
    Record<records::list> record = tables_.lists.append();
    record.set(fields::list::name_offset, name.offset);
    record.set(fields::list::name_size, name.size);
    record.set(fields::list::role, list.is_program ? 2U : list.is_default_list ? 1U : 0U);
    record.set(fields::list::sha256, sha256(list));
  }

  void add_values(std::uint32_t axis) {
    for (machine::SourcedValue const& value : machine_.axes[axis].values) {
      TextRange const name = tables_.names.add(value.name);
      TextRange const text = tables_.names.add(value.text);
      Record<records::value> record = tables_.values.append();
      record.set(fields::value::axis, axis);
      record.set(fields::value::list, value.list);
      record.set(fields::value::line, value.line);
      record.set(fields::value::name_offset, name.offset);
      record.set(fields::value::name_size, name.size);
      record.set(fields::value::text_offset, text.offset);
      record.set(fields::value::text_size, text.size);
    }
  }

  machine::Machine const& machine_;
  ImageOptions const& options_;
  KnownDesigns& designs_;
  CompiledKernels kernels_;
  ImageTables tables_;
  FilterRecords filter_records_;
};

}  // namespace

std::vector<std::byte> write_image(machine::Machine const& machine, ImageOptions const& options) {
  KnownDesigns designs;
  return write_image(machine, options, designs);
}

std::vector<std::byte> write_image(machine::Machine const& machine, ImageOptions const& options,
                                   KnownDesigns& designs) {
  return ImageBuilder(machine, options, designs).build();
}

}  // namespace axisc::codegen
