#include "image/image_records.hpp"

namespace axisc::image {
namespace {

std::optional<std::size_t> optional_index(std::uint32_t index) {
  return index == AXIM_NONE ? std::nullopt : std::optional<std::size_t>(index);
}

ImageBank read_bank(ImageRecords const& image, codegen::ConstRecord<codegen::records::bank> record,
                    std::uint32_t members) {
  std::uint32_t const keywords = record.get(codegen::fields::bank::keywords);
  ImageBank bank;
  if ((keywords & axim_keyword_order) != 0) bank.parameters.order = record.get(codegen::fields::bank::order);
  if ((keywords & axim_keyword_share) != 0) {
    bank.parameters.share_percent = record.get(codegen::fields::bank::share);
  }
  if ((keywords & axim_keyword_fcut) != 0) {
    bank.parameters.frequency = design::Hertz{record.get(codegen::fields::bank::frequency)};
  }
  if ((keywords & axim_keyword_quality) != 0) {
    bank.parameters.quality = record.get(codegen::fields::bank::quality);
  }
  bank.hsc = (keywords & axim_keyword_hsc) != 0;
  bank.parameters.guard = (keywords & axim_keyword_guard) != 0;
  bank.fade_cycles = record.get(codegen::fields::bank::fade_cycles);
  for (std::uint32_t i = 0; i < members; ++i) {
    bank.kernels.push_back(
        optional_index(image.choices[record.get(codegen::fields::bank::first_choice) + i].get(
            codegen::fields::choice::kernel)));
  }
  return bank;
}

}  // namespace

ImageKernel read_kernel(ImageRecords const& image, codegen::ConstRecord<codegen::records::kernel> record) {
  ImageKernel kernel{
      .specification = {.type = static_cast<design::KernelType>(record.get(codegen::fields::kernel::type)),
                        .order = record.get(codegen::fields::kernel::order),
                        .frequency = {record.get(codegen::fields::kernel::frequency)},
                        .quality = record.get(codegen::fields::kernel::quality),
                        .share_percent = record.get(codegen::fields::kernel::share_percent),
                        .reading = known_reading<design::KernelReading>(
                            record.get(codegen::fields::kernel::reading), design::kernel_reading_words),
                        .cycle_time = known_reading<design::CycleReading>(
                            record.get(codegen::fields::kernel::cycle_reading), design::cycle_reading_words)},
      .design = {},
      .peak_gain = record.get(codegen::fields::kernel::peak_gain),
      .overshoot = record.get(codegen::fields::kernel::overshoot),
      .tail_gain = record.get(codegen::fields::kernel::tail_gain),
      .self_test_input = {},
      .self_test_output = {}};
  kernel.design.half_width = record.get(codegen::fields::kernel::half_width);
  kernel.design.delay_cycles = record.get(codegen::fields::kernel::delay_cycles);
  kernel.design.group_delay_cycles = record.get(codegen::fields::kernel::group_delay);
  kernel.design.kernel_sum = record.get(codegen::fields::kernel::kernel_sum);
  double before = 1;
  kernel.design.taps.clear();
  for (std::uint32_t i = 0; i < record.get(codegen::fields::kernel::tail_count); ++i) {
    double const tail =
        image.tails[record.get(codegen::fields::kernel::first_tail) + i].get(codegen::fields::tail::value);
    kernel.design.tail_sums.push_back(tail);
    kernel.design.taps.push_back(before - tail);
    before = tail;
  }
  kernel.design.taps.push_back(before);
  image.read_samples(record.get(codegen::fields::kernel::first_sample),
                     record.get(codegen::fields::kernel::sample_count), kernel);
  return kernel;
}

ImageSlot read_slot(codegen::ConstRecord<codegen::records::slot> record) {
  return {.family = static_cast<machine::KernelFamily>(record.get(codegen::fields::slot::family)),
          .index = record.get(codegen::fields::slot::index),
          .kernel = optional_index(record.get(codegen::fields::slot::kernel)),
          .on_at_start = record.get(codegen::fields::slot::on_at_start) != 0,
          .group = optional_index(record.get(codegen::fields::slot::group))};
}

ImageGroup read_group(ImageRecords const& image, codegen::ConstRecord<codegen::records::group> record) {
  ImageGroup group{
      .name = image.text(record, codegen::fields::group::name_offset, codegen::fields::group::name_size),
      .members = {},
      .banks = {},
      .off_fade_cycles = record.get(codegen::fields::group::off_fade_cycles)};
  std::uint32_t const members = record.get(codegen::fields::group::member_count);
  for (std::uint32_t i = 0; i < members; ++i) {
    group.members.push_back(image.members[record.get(codegen::fields::group::first_member) + i].get(
        codegen::fields::member::axis));
  }
  for (std::uint32_t i = 0; i < record.get(codegen::fields::group::bank_count); ++i) {
    group.banks.push_back(
        read_bank(image, image.banks[record.get(codegen::fields::group::first_bank) + i], members));
  }
  return group;
}

}  // namespace axisc::image
