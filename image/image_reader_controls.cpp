#include "image/image_records.hpp"

namespace axisc::image {
namespace {

ImageStage read_stage(ImageRecords const& image, codegen::ConstRecord<codegen::records::stage> record) {
  std::uint32_t const first_filter = record.get(codegen::fields::stage::first_filter);
  return {.index = record.get(codegen::fields::stage::index),
          .mode = static_cast<machine::StageMode>(record.get(codegen::fields::stage::mode)),
          .has_oscillator = image.filters[first_filter].get(codegen::fields::filter::type) == 0,
          .weight = record.get(codegen::fields::stage::weight),
          .weight_numerator = record.get(codegen::fields::stage::weight_numerator),
          .weight_denominator = record.get(codegen::fields::stage::weight_denominator),
          .filters = read_chain(image, first_filter, record.get(codegen::fields::stage::filter_count))};
}

}  // namespace

ImageControl read_control(ImageRecords const& image, codegen::ConstRecord<codegen::records::control> record) {
  ImageControl control{.source = record.get(codegen::fields::control::source),
                       .stages = {},
                       .scaling = {.controller = static_cast<machine::PositionController>(
                                       record.get(codegen::fields::control::controller)),
                                   .v_reso_num = record.get(codegen::fields::control::v_reso_num),
                                   .v_reso_denom = record.get(codegen::fields::control::v_reso_denom),
                                   .time_base = record.get(codegen::fields::control::time_base),
                                   .multi_gain_z = record.get(codegen::fields::control::multi_gain_z),
                                   .multi_gain_n = record.get(codegen::fields::control::multi_gain_n)},
                       .limit = record.get(codegen::fields::control::limit),
                       .limit_factor = record.get(codegen::fields::control::limit_factor),
                       .increments_per_velocity = record.get(codegen::fields::control::scale)};
  for (std::uint32_t i = 0; i < record.get(codegen::fields::control::stage_count); ++i) {
    control.stages.push_back(
        read_stage(image, image.stages[record.get(codegen::fields::control::first_stage) + i]));
  }
  return control;
}

}  // namespace axisc::image
