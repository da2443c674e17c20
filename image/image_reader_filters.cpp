#include "image/image_records.hpp"

namespace axisc::image {
namespace {

design::FilterSpecification specification(ConstRecord<records::filter> record) {
  return {.type = static_cast<design::FilterType>(record.get(fields::filter::type)),
          .prototype = static_cast<design::Prototype>(record.get(fields::filter::prototype)),
          .order = record.get(fields::filter::order),
          .frequency = {record.get(fields::filter::frequency)},
          .quality = record.get(fields::filter::quality),
          .time_constant = {record.get(fields::filter::time_constant)},
          .share_percent = record.get(fields::filter::share_percent)};
}

std::vector<design::IncrementSection> cascade(ImageRecords const& image, std::uint32_t first,
                                              std::uint32_t count) {
  std::vector<design::IncrementSection> sections;
  sections.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    ConstRecord<records::coefficients> const record = image.coefficients[first + i];
    sections.push_back({.p = record.get(fields::coefficients::p),
                        .q = record.get(fields::coefficients::q),
                        .k = record.get(fields::coefficients::k),
                        .b = record.get(fields::coefficients::b)});
  }
  return sections;
}

design::FilterDesign design_of(ImageRecords const& image, ConstRecord<records::filter> record) {
  design::FilterDesign design;
  design.realisation = static_cast<design::Realisation>(record.get(fields::filter::realisation));
  design.sections =
      cascade(image, record.get(fields::filter::first_section), record.get(fields::filter::section_count));
  design.blocks_constant = record.get(fields::filter::blocks_constant) != 0;
  design.delay_cycles = record.get(fields::filter::delay_cycles);
  design.share = {.filtered = record.get(fields::filter::share),
                  .direct = record.get(fields::filter::direct),
                  .direct_low = record.get(fields::filter::direct_low)};
  design.pole_radius = record.get(fields::filter::pole_radius);
  design.dc_gain = record.get(fields::filter::dc_gain);
  design.group_delay_cycles = record.get(fields::filter::group_delay);
  return design;
}

ImageFilter read_filter(ImageRecords const& image, ConstRecord<records::filter> record) {
  ImageFilter filter{.index = record.get(fields::filter::index),
                     .specification = specification(record),
                     .design = design_of(image, record),
                     .peak_gain = record.get(fields::filter::peak_gain),
                     .overshoot = record.get(fields::filter::overshoot),
                     .kernel_sum = record.get(fields::filter::kernel_sum),
                     .self_test_input = {},
                     .self_test_output = {}};
  image.read_samples(record.get(fields::filter::first_sample), record.get(fields::filter::sample_count),
                     filter);
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
