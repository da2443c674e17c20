#include "codegen/image_writer.hpp"

#include "codegen/compiled_filters.hpp"
#include "codegen/image_fields.hpp"
#include "codegen/image_layout.hpp"
#include "codegen/source_digest.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace axisc::codegen {
namespace {

/// Consecutive records of a section; an empty range begins at 0.
struct Range {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// Runs of records of which equal ones are stored once.
template <class Run>
class SharedRuns {
 public:
  /// The place of `run`; calls `append` for each record of a run that is not stored yet and gets place
  /// `next`.
  template <class Append>
  Range place(Run const& run, std::uint32_t count, std::uint32_t next, Append append) {
    if (count == 0) return {};
    auto const known =
        std::find_if(runs_.begin(), runs_.end(), [&](Entry const& entry) { return entry.run == run; });
    if (known != runs_.end()) return {.first = known->first, .count = count};
    runs_.push_back({.run = run, .first = next});
    for (std::uint32_t i = 0; i < count; ++i) append(i);
    return {.first = next, .count = count};
  }

 private:
  struct Entry {
    Run run;
    std::uint32_t first = 0;
  };
  std::vector<Entry> runs_;
};

class ImageBuilder {
 public:
  ImageBuilder(validator::Machine const& machine, ImageOptions const& options)
      : machine_(machine), options_(options), compiled_(machine.cycle_time) {}

  std::vector<std::byte> build() {
    for (validator::AxisConfiguration const& axis : machine_.axes) add_axis(axis);
    if (!options_.strip) {
      for (validator::MachineList const& list : machine_.lists) add_list(list);
      for (std::uint32_t axis = 0; axis < machine_.axes.size(); ++axis) add_values(axis);
    }

    std::vector<SectionContent const*> sections = {&axes_.content(), &filters_.content(),
                                                   &coefficients_.content()};
    if (!options_.strip) {
      sections.insert(sections.end(),
                      {&names_.content(), &self_tests_.content(), &lists_.content(), &values_.content()});
    }
    return assemble_image({.cycle_time_ns = machine_.cycle_time.nanoseconds,
                           .axis_count = static_cast<std::uint32_t>(machine_.axes.size()),
                           .image_version = options_.image_version,
                           .source_digest = source_digest(machine_.lists),
                           .compiler_version = AXISC_VERSION},
                          sections);
  }

 private:
  void add_axis(validator::AxisConfiguration const& axis) {
    std::uint32_t const axis_index = axes_.count();
    Range const chain = add_filters(axis_index, validator::FilterPort::setpoint, axis.filters);
    Range const interface_chain =
        add_filters(axis_index, validator::FilterPort::additional_interface, axis.interface_filters);
    ChainProof const proof = compiled_.chain(axis.filters);

    Record<records::axis> record = axes_.append();
    if (!options_.strip) {
      TextRange const name = names_.add(axis.name);
      record.set(fields::axis::name_offset, name.offset);
      record.set(fields::axis::name_size, name.size);
    }
    record.set(fields::axis::number, axis.number);
    record.set(fields::axis::type, static_cast<std::uint32_t>(axis.type));
    record.set(fields::axis::position_unit, axis.type == validator::AxisType::translatory ? 0U : 1U);
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

  Range add_filters(std::uint32_t axis, validator::FilterPort port,
                    std::span<validator::ConfiguredFilter const> configured) {
    if (configured.empty()) return {};
    Range const range{.first = filters_.count(), .count = static_cast<std::uint32_t>(configured.size())};
    for (validator::ConfiguredFilter const& filter : configured) add_filter(axis, port, filter);
    return range;
  }

  void add_filter(std::uint32_t axis, validator::FilterPort port,
                  validator::ConfiguredFilter const& configured) {
    CompiledFilter const& compiled = compiled_.filter(configured.specification);
    design::FilterDesign const& design = compiled.design;
    Range const sections = place_sections(design.sections);
    Range const samples = options_.strip ? Range{} : place_samples(compiled.self_test);

    Record<records::filter> record = filters_.append();
    record.set(fields::filter::axis, axis);
    record.set(fields::filter::port, static_cast<std::uint32_t>(port));
    record.set(fields::filter::index, configured.index);
    record.set(fields::filter::realisation, static_cast<std::uint32_t>(design.realisation));
    record.set(fields::filter::blocks_constant, design.blocks_constant ? 1U : 0U);
    record.set(fields::filter::first_section, sections.first);
    record.set(fields::filter::section_count, sections.count);
    record.set(fields::filter::delay_cycles, design.delay_cycles);
    record.set(fields::filter::share, design.share.filtered);
    record.set(fields::filter::direct, design.share.direct);
    record.set(fields::filter::direct_low, design.share.direct_low);
    set_specification(record, configured.specification);
    set_proof(record, compiled.proof);
    record.set(fields::filter::first_sample, samples.first);
    record.set(fields::filter::sample_count, samples.count);
  }

  static void set_specification(Record<records::filter>& record,
                                design::FilterSpecification const& specification) {
    record.set(fields::filter::type, static_cast<std::uint32_t>(specification.type));
    record.set(fields::filter::prototype, static_cast<std::uint32_t>(specification.prototype));
    record.set(fields::filter::order, specification.order);
    record.set(fields::filter::frequency, specification.frequency.value);
    record.set(fields::filter::quality, specification.quality);
    record.set(fields::filter::time_constant, specification.time_constant.value);
    record.set(fields::filter::share_percent, specification.share_percent);
  }

  static void set_proof(Record<records::filter>& record, FilterProof const& proof) {
    record.set(fields::filter::pole_radius, proof.pole_radius);
    record.set(fields::filter::dc_gain, proof.dc_gain);
    record.set(fields::filter::group_delay, proof.group_delay);
    record.set(fields::filter::kernel_sum, proof.kernel_sum);
    record.set(fields::filter::peak_gain, proof.peak_gain);
    record.set(fields::filter::overshoot, proof.overshoot);
  }

  Range place_sections(std::vector<design::IncrementSection> const& sections) {
    return section_runs_.place(sections, static_cast<std::uint32_t>(sections.size()), coefficients_.count(),
                               [&](std::uint32_t i) {
                                 Record<records::coefficients> record = coefficients_.append();
                                 record.set(fields::coefficients::p, sections[i].p);
                                 record.set(fields::coefficients::q, sections[i].q);
                                 record.set(fields::coefficients::k, sections[i].k);
                                 record.set(fields::coefficients::b, sections[i].b);
                               });
  }

  Range place_samples(SelfTest const& test) {
    return sample_runs_.place(test, static_cast<std::uint32_t>(test.input.size()), self_tests_.count(),
                              [&](std::uint32_t i) {
                                Record<records::sample> record = self_tests_.append();
                                record.set(fields::sample::input, test.input[i]);
                                record.set(fields::sample::output, test.output[i]);
                              });
  }

  void add_list(validator::MachineList const& list) {
    TextRange const name = names_.add(list.name);
    Record<records::list> record = lists_.append();
    record.set(fields::list::name_offset, name.offset);
    record.set(fields::list::name_size, name.size);
    record.set(fields::list::role, list.is_default_list ? 1U : 0U);
    record.set(fields::list::sha256, sha256(list.content));
  }

  void add_values(std::uint32_t axis) {
    for (validator::SourcedValue const& value : machine_.axes[axis].values) {
      TextRange const name = names_.add(value.name);
      TextRange const text = names_.add(value.text);
      Record<records::value> record = values_.append();
      record.set(fields::value::axis, axis);
      record.set(fields::value::list, value.list);
      record.set(fields::value::line, value.line);
      record.set(fields::value::name_offset, name.offset);
      record.set(fields::value::name_size, name.size);
      record.set(fields::value::text_offset, text.offset);
      record.set(fields::value::text_size, text.size);
    }
  }

  validator::Machine const& machine_;
  ImageOptions const& options_;
  CompiledFilters compiled_;
  SectionTable<records::axis> axes_{sections::axes};
  SectionTable<records::filter> filters_{sections::filters};
  SectionTable<records::coefficients> coefficients_{sections::coefficients};
  TextPool names_;
  SectionTable<records::sample> self_tests_{sections::self_tests};
  SectionTable<records::list> lists_{sections::lists};
  SectionTable<records::value> values_{sections::values};
  SharedRuns<std::vector<design::IncrementSection>> section_runs_;
  SharedRuns<SelfTest> sample_runs_;
};

}  // namespace

std::vector<std::byte> write_image(validator::Machine const& machine, ImageOptions const& options) {
  return ImageBuilder(machine, options).build();
}

}  // namespace axisc::codegen
