#include "runtime/section_writer.hpp"

namespace axisc::test {
namespace {

void append_kernel(Sections& to, KernelRecord const& kernel, bool strip) {
  bool const tested = !strip && !kernel.samples.empty();
  ByteWriter& out = to.kernels.out();
  out.u32(kernel.type);
  out.u32(kernel.delay_cycles);  // order
  out.u32(kernel.half_width);
  out.u32(kernel.delay_cycles);
  out.u32(to.tails.count());
  out.u32(static_cast<std::uint32_t>(kernel.tails.size()));
  out.u32(tested ? to.samples.count() : 0);
  out.u32(tested ? static_cast<std::uint32_t>(kernel.samples.size()) : 0);
  for (double const parameter : {100.0, 30.0, 1.0}) out.f64(parameter);
  for (double const proof : {2.0, 1.0, kernel.peak_gain, 0.0, 3.0}) out.f64(proof);
  out.zeros(32);
  to.kernels.end_record();
  for (double const tail : kernel.tails) {
    to.tails.out().f64(tail);
    to.tails.end_record();
  }
  if (!tested) return;
  for (SampleRecord const& sample : kernel.samples) append_sample(to.samples, sample);
}

/// Place of the axis' slot in the members section.
std::uint32_t member_of(ImageRecord const& image, SlotRecord const& slot) {
  if (slot.group == none) return none;
  std::uint32_t member = 0;
  for (std::uint32_t group = 0; group < image.groups.size(); ++group) {
    for (std::uint32_t const axis : image.groups[group].members) {
      if (group == slot.group && axis == slot.axis) return member;
      ++member;
    }
  }
  return none;
}

void append_slot(Sections& to, ImageRecord const& image, SlotRecord const& slot) {
  ByteWriter& out = to.slots.out();
  out.u32(slot.axis);
  out.u32(slot.family);
  out.u32(slot.index);
  out.u32(slot.kernel);
  out.u32(slot.on_at_start);
  out.u32(slot.history);
  out.u32(slot.group);
  out.u32(member_of(image, slot));
  to.slots.end_record();
}

void append_bank(Sections& to, BankRecord const& bank) {
  ByteWriter& out = to.banks.out();
  out.u32(bank.keywords);
  out.u32(bank.order);
  out.f64(bank.share);
  out.f64(bank.frequency);
  out.f64(bank.quality);
  out.u32(to.choices.count());
  out.u32(bank.fade_cycles);
  out.zeros(24);
  to.banks.end_record();
  for (std::uint32_t const kernel : bank.choices) {
    to.choices.out().u32(kernel);
    to.choices.end_record();
  }
}

void append_group(Sections& to, GroupRecord const& group, bool strip) {
  auto const [name_offset, name_size] = strip ? std::pair{0U, 0U} : append_text(to.names, group.name);
  ByteWriter& out = to.groups.out();
  out.u32(name_offset);
  out.u32(name_size);
  out.u32(to.members.count());
  out.u32(static_cast<std::uint32_t>(group.members.size()));
  out.u32(to.banks.count());
  out.u32(static_cast<std::uint32_t>(group.banks.size()));
  out.u32(group.off_fade_cycles);
  out.u32(0);
  to.groups.end_record();
  for (std::uint32_t const axis : group.members) {
    to.members.out().u32(axis);
    to.members.end_record();
  }
  for (BankRecord const& bank : group.banks) append_bank(to, bank);
}

void append_stage(Sections& to, StageRecord const& stage, std::uint32_t axis, bool strip) {
  ByteWriter& out = to.stages.out();
  out.u32(stage.index);
  out.u32(stage.mode);
  out.u32(to.filters.count());
  out.u32(static_cast<std::uint32_t>(stage.filters.size()));
  out.f64(stage.weight);
  out.f64(stage.weight * 100);
  out.f64(100);
  out.zeros(24);
  to.stages.end_record();
  for (std::uint32_t i = 0; i < stage.filters.size(); ++i) {
    FilterRecord filter = stage.filters[i];
    filter.index = i;
    append_filter(to, filter, axis, 2, strip);
  }
}

void append_control(Sections& to, ControlRecord const& control, bool strip) {
  ByteWriter& out = to.controls.out();
  out.u32(control.axis);
  out.u32(control.source);
  out.u32(to.stages.count());
  out.u32(static_cast<std::uint32_t>(control.stages.size()));
  out.u32(control.controller);
  out.u32(control.time_base);
  out.f64(control.limit);
  out.f64(control.scale);
  for (double const configured : {1000.0, 2.0, 1.0, 4.0, 3.0}) out.f64(configured);
  out.zeros(48);
  to.controls.end_record();
  for (StageRecord const& stage : control.stages) append_stage(to, stage, control.axis, strip);
}

}  // namespace

void append_kernels_and_controls(Sections& to, ImageRecord const& image) {
  for (ControlRecord const& control : image.controls) append_control(to, control, image.strip);
  for (KernelRecord const& kernel : image.kernels) append_kernel(to, kernel, image.strip);
  for (SlotRecord const& slot : image.slots) append_slot(to, image, slot);
  for (GroupRecord const& group : image.groups) append_group(to, group, image.strip);
}

KernelRecord symmetric_kernel(std::vector<double> const& half) {
  auto const h = static_cast<std::uint32_t>(half.size()) - 1;
  KernelRecord kernel{.type = 1, .half_width = h, .delay_cycles = h, .tails = {}, .samples = {}};
  double sum = half[0];
  for (std::uint32_t k = 1; k <= h; ++k) sum += 2 * half[k];
  double rest = 1;
  for (std::uint32_t j = 0; j < 2 * h; ++j) {
    rest -= half[j < h ? h - j : j - h] / sum;
    kernel.tails.push_back(rest);
  }
  return kernel;
}

KernelRecord moving_average(std::uint32_t half_width) {
  KernelRecord kernel = symmetric_kernel(std::vector<double>(half_width + 1, 1));
  kernel.type = 0;
  return kernel;
}

KernelRecord delay_kernel(std::uint32_t cycles, double share) {
  return {.type = 3,
          .half_width = 0,
          .delay_cycles = cycles,
          .tails = std::vector<double>(cycles, share),
          .samples = {}};
}

}  // namespace axisc::test
