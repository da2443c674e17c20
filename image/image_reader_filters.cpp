#include "image/image_records.hpp"

namespace axisc::image {
namespace {

design::FilterSpecification specification(codegen::ConstRecord<codegen::records::filter> record) {
  return {.type = static_cast<design::FilterType>(record.get(codegen::fields::filter::type)),
          .prototype = static_cast<design::Prototype>(record.get(codegen::fields::filter::prototype)),
          .order = record.get(codegen::fields::filter::order),
          .frequency = {record.get(codegen::fields::filter::frequency)},
          .quality = record.get(codegen::fields::filter::quality),
          .time_constant = {record.get(codegen::fields::filter::time_constant)},
          .share_percent = record.get(codegen::fields::filter::share_percent),
          .reading = known_reading<design::FilterReading>(record.get(codegen::fields::filter::reading),
                                                          design::filter_reading_words),
          .cycle_time = known_reading<design::CycleReading>(
              record.get(codegen::fields::filter::cycle_reading), design::cycle_reading_words)};
}

std::vector<design::IncrementSection> cascade(ImageRecords const& image, std::uint32_t first,
                                              std::uint32_t count) {
  std::vector<design::IncrementSection> sections;
  sections.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    codegen::ConstRecord<codegen::records::coefficients> const record = image.coefficients[first + i];
    sections.push_back({.p = record.get(codegen::fields::coefficients::p),
                        .q = record.get(codegen::fields::coefficients::q),
                        .k = record.get(codegen::fields::coefficients::k),
                        .b = record.get(codegen::fields::coefficients::b)});
  }
  return sections;
}

design::FilterDesign design_of(ImageRecords const& image,
                               codegen::ConstRecord<codegen::records::filter> record) {
  design::FilterDesign design;
  design.realisation = static_cast<design::Realisation>(record.get(codegen::fields::filter::realisation));
  design.sections = cascade(image, record.get(codegen::fields::filter::first_section),
                            record.get(codegen::fields::filter::section_count));
  design.blocks_constant = record.get(codegen::fields::filter::blocks_constant) != 0;
  design.delay_cycles = record.get(codegen::fields::filter::delay_cycles);
  design.share = {.filtered = record.get(codegen::fields::filter::share),
                  .direct = record.get(codegen::fields::filter::direct),
                  .direct_low = record.get(codegen::fields::filter::direct_low)};
  design.pole_radius = record.get(codegen::fields::filter::pole_radius);
  design.dc_gain = record.get(codegen::fields::filter::dc_gain);
  design.group_delay_cycles = record.get(codegen::fields::filter::group_delay);
  return design;
}

ImageFilter read_filter(ImageRecords const& image, codegen::ConstRecord<codegen::records::filter> record) {
  ImageFilter filter{.index = record.get(codegen::fields::filter::index),
                     .specification = specification(record),
                     .design = design_of(image, record),
                     .peak_gain = record.get(codegen::fields::filter::peak_gain),
                     .overshoot = record.get(codegen::fields::filter::overshoot),
                     .kernel_sum = record.get(codegen::fields::filter::kernel_sum),
                     .self_test_input = {},
                     .self_test_output = {}};
  image.read_samples(record.get(codegen::fields::filter::first_sample),
                     record.get(codegen::fields::filter::sample_count), filter);
  return filter;
}

}  // namespace

std::vector<ImageFilter> read_chain(ImageRecords const& image, std::uint32_t first, std::uint32_t count) {
  std::vector<ImageFilter> filters;
  filters.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) filters.push_back(read_filter(image, image.filters[first + i]));
  return filters;
}

}  // namespace axisc::image
