#include "codegen/filter_records.hpp"

namespace axisc::codegen {
namespace {

void set_specification(Record<records::filter>& record, design::FilterSpecification const& specification) {
  record.set(fields::filter::type, static_cast<std::uint32_t>(specification.type));
  record.set(fields::filter::prototype, static_cast<std::uint32_t>(specification.prototype));
  record.set(fields::filter::order, specification.order);
  record.set(fields::filter::frequency, specification.frequency.value);
  record.set(fields::filter::quality, specification.quality);
  record.set(fields::filter::time_constant, specification.time_constant.value);
  record.set(fields::filter::share_percent, specification.share_percent);
  record.set(fields::filter::reading, static_cast<std::uint32_t>(specification.reading));
  record.set(fields::filter::cycle_reading, static_cast<std::uint32_t>(specification.cycle_time));
}

void set_proof(Record<records::filter>& record, FilterProof const& proof) {
  record.set(fields::filter::pole_radius, proof.pole_radius);
  record.set(fields::filter::dc_gain, proof.dc_gain);
  record.set(fields::filter::group_delay, proof.group_delay);
  record.set(fields::filter::kernel_sum, proof.kernel_sum);
  record.set(fields::filter::peak_gain, proof.peak_gain);
  record.set(fields::filter::overshoot, proof.overshoot);
}

}  // namespace

Range FilterRecords::add(std::uint32_t axis, std::uint32_t port,
                         std::span<machine::ConfiguredFilter const> configured) {
  if (configured.empty()) return {};
  Range const range{.first = tables_.filters.count(), .count = static_cast<std::uint32_t>(configured.size())};
  for (machine::ConfiguredFilter const& filter : configured) {
    auto const compiled = designs_.filter(filter.specification, cycle_time_);
    Record<records::filter> record = append({.axis = axis, .port = port, .index = filter.index}, *compiled);
    set_specification(record, filter.specification);
  }
  return range;
}

void FilterRecords::add(std::uint32_t axis, design::OscillatorSpecification const& oscillator) {
  auto const compiled = designs_.oscillator(oscillator, cycle_time_);
  Record<records::filter> record = append({.axis = axis, .port = axim_port_velocity, .index = 0}, *compiled);
  record.set(fields::filter::prototype, std::uint32_t{1});
  record.set(fields::filter::order, std::uint32_t{2});
  record.set(fields::filter::frequency, oscillator.frequency.value);
  record.set(fields::filter::quality, oscillator.damping);
  record.set(fields::filter::share_percent, 100.0);
}

Record<records::filter> FilterRecords::append(Place place, CompiledFilter const& compiled) {
  design::FilterDesign const& design = compiled.design;
  Range const sections = place_sections(design.sections);
  Range const samples = strip_ ? Range{} : tables_.place_samples(compiled.self_test());
  Record<records::filter> record = tables_.filters.append();
  record.set(fields::filter::axis, place.axis);
  record.set(fields::filter::port, place.port);
  record.set(fields::filter::index, place.index);
  record.set(fields::filter::realisation, static_cast<std::uint32_t>(design.realisation));
  record.set(fields::filter::blocks_constant, design.blocks_constant ? 1U : 0U);
  record.set(fields::filter::first_section, sections.first);
  record.set(fields::filter::section_count, sections.count);
  record.set(fields::filter::delay_cycles, design.delay_cycles);
  record.set(fields::filter::share, design.share.filtered);
  record.set(fields::filter::direct, design.share.direct);
  record.set(fields::filter::direct_low, design.share.direct_low);
  set_proof(record, compiled.proof);
  record.set(fields::filter::first_sample, samples.first);
  record.set(fields::filter::sample_count, samples.count);
  return record;
}

Range FilterRecords::place_sections(std::vector<design::IncrementSection> const& sections) {
  return section_runs_.place(sections, static_cast<std::uint32_t>(sections.size()),
                             tables_.coefficients.count(), [&](std::uint32_t i) {
                               Record<records::coefficients> record = tables_.coefficients.append();
                               record.set(fields::coefficients::p, sections[i].p);
                               record.set(fields::coefficients::q, sections[i].q);
                               record.set(fields::coefficients::k, sections[i].k);
                               record.set(fields::coefficients::b, sections[i].b);
                             });
}

}  // namespace axisc::codegen
