#include "image/image_records.hpp"

namespace axisc::image {
namespace {

ImageStage read_stage(ImageRecords const& image, ConstRecord<records::stage> record) {
  std::uint32_t const first_filter = record.get(fields::stage::first_filter);
  return {.index = record.get(fields::stage::index),
          .mode = static_cast<machine::StageMode>(record.get(fields::stage::mode)),
          .has_oscillator = image.filters[first_filter].get(fields::filter::type) == 0,
          .weight = record.get(fields::stage::weight),
          .weight_numerator = record.get(fields::stage::weight_numerator),
          .weight_denominator = record.get(fields::stage::weight_denominator),
          .filters = read_chain(image, first_filter, record.get(fields::stage::filter_count))};
}

}  // namespace

ImageControl read_control(ImageRecords const& image, ConstRecord<records::control> record) {
  ImageControl control{.source = record.get(fields::control::source),
                       .stages = {},
                       .scaling = {.controller = static_cast<machine::PositionController>(
                                       record.get(fields::control::controller)),
                                   .v_reso_num = record.get(fields::control::v_reso_num),
                                   .v_reso_denom = record.get(fields::control::v_reso_denom),
                                   .time_base = record.get(fields::control::time_base),
                                   .multi_gain_z = record.get(fields::control::multi_gain_z),
                                   .multi_gain_n = record.get(fields::control::multi_gain_n)},
                       .limit = record.get(fields::control::limit),
                       .limit_factor = record.get(fields::control::limit_factor),
                       .increments_per_velocity = record.get(fields::control::scale)};
  for (std::uint32_t i = 0; i < record.get(fields::control::stage_count); ++i) {
    control.stages.push_back(read_stage(image, image.stages[record.get(fields::control::first_stage) + i]));
  }
  return control;
}

}  // namespace axisc::image
