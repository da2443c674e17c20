#include "codegen/kernel_records.hpp"

namespace axisc::codegen {
namespace {

void add_kernel(design::KernelSpecification const& specification, CompiledKernel const& kernel, bool strip,
                ImageTables& tables) {
  std::uint32_t const first_tail = tables.tails.count();
  for (double const tail : kernel.design.tail_sums) tables.tails.append().set(fields::tail::value, tail);
  Range const samples = strip ? Range{} : tables.place_samples(kernel.self_test());
  Record<records::kernel> record = tables.kernels.append();
  record.set(fields::kernel::type, static_cast<std::uint32_t>(specification.type));
  record.set(fields::kernel::order, specification.order);
  record.set(fields::kernel::half_width, kernel.design.half_width);
  record.set(fields::kernel::delay_cycles, kernel.design.delay_cycles);
  record.set(fields::kernel::first_tail, first_tail);
  record.set(fields::kernel::tail_count, static_cast<std::uint32_t>(kernel.design.tail_sums.size()));
  record.set(fields::kernel::first_sample, samples.first);
  record.set(fields::kernel::sample_count, samples.count);
  record.set(fields::kernel::share_percent, specification.share_percent);
  record.set(fields::kernel::frequency, specification.frequency.value);
  record.set(fields::kernel::quality, specification.quality);
  record.set(fields::kernel::group_delay, kernel.design.group_delay_cycles);
  record.set(fields::kernel::kernel_sum, kernel.design.kernel_sum);
  record.set(fields::kernel::peak_gain, kernel.proof.peak_gain);
  record.set(fields::kernel::overshoot, kernel.proof.overshoot);
  record.set(fields::kernel::tail_gain, kernel.proof.tail_gain);
  record.set(fields::kernel::reading, static_cast<std::uint32_t>(specification.reading));
  record.set(fields::kernel::cycle_reading, static_cast<std::uint32_t>(specification.cycle_time));
}

void add_slot(PlannedSlot const& slot, std::uint32_t first_member, ImageTables& tables) {
  Record<records::slot> record = tables.slots.append();
  record.set(fields::slot::axis, static_cast<std::uint32_t>(slot.axis));
  record.set(fields::slot::family, static_cast<std::uint32_t>(slot.family));
  record.set(fields::slot::index, slot.index);
  record.set(fields::slot::kernel, slot.kernel);
  record.set(fields::slot::on_at_start, slot.on_at_start ? 1U : 0U);
  record.set(fields::slot::history, slot.history);
  record.set(fields::slot::group, slot.group ? static_cast<std::uint32_t>(*slot.group) : AXIM_NONE);
  record.set(fields::slot::member,
             slot.group ? first_member + static_cast<std::uint32_t>(slot.member) : AXIM_NONE);
}

std::uint32_t keywords(PlannedBank const& bank) {
  std::uint32_t keywords = 0;
  if (bank.parameters.order) keywords |= axim_keyword_order;
  if (bank.parameters.share_percent) keywords |= axim_keyword_share;
  if (bank.parameters.frequency) keywords |= axim_keyword_fcut;
  if (bank.parameters.quality) keywords |= axim_keyword_quality;
  if (bank.hsc) keywords |= axim_keyword_hsc;
  if (bank.parameters.guard) keywords |= axim_keyword_guard;
  return keywords;
}

void add_bank(PlannedBank const& bank, ImageTables& tables) {
  std::uint32_t const first_choice = tables.choices.count();
  for (std::uint32_t const kernel : bank.choices) tables.choices.append().set(fields::choice::kernel, kernel);
  Record<records::bank> record = tables.banks.append();
  record.set(fields::bank::keywords, keywords(bank));
  record.set(fields::bank::order, bank.parameters.order.value_or(0));
  record.set(fields::bank::share, bank.parameters.share_percent.value_or(0));
  record.set(fields::bank::frequency, bank.parameters.frequency.value_or(design::Hertz{0}).value);
  record.set(fields::bank::quality, bank.parameters.quality.value_or(0));
  record.set(fields::bank::first_choice, first_choice);
  record.set(fields::bank::fade_cycles, bank.fade_cycles);
}

/// Returns the first member's record.
std::uint32_t add_group(PlannedGroup const& group, bool strip, ImageTables& tables) {
  std::uint32_t const first_member = tables.members.count();
  std::uint32_t const first_bank = tables.banks.count();
  for (std::size_t const axis : group.members) {
    tables.members.append().set(fields::member::axis, static_cast<std::uint32_t>(axis));
  }
  for (PlannedBank const& bank : group.banks) add_bank(bank, tables);
  Record<records::group> record = tables.groups.append();
  if (!strip) {
    TextRange const name = tables.names.add(group.name);
    record.set(fields::group::name_offset, name.offset);
    record.set(fields::group::name_size, name.size);
  }
  record.set(fields::group::first_member, first_member);
  record.set(fields::group::member_count, static_cast<std::uint32_t>(group.members.size()));
  record.set(fields::group::first_bank, first_bank);
  record.set(fields::group::bank_count, static_cast<std::uint32_t>(group.banks.size()));
  record.set(fields::group::off_fade_cycles, group.off_fade_cycles);
  return first_member;
}

}  // namespace

void add_kernel_records(KernelPlan const& plan, CompiledKernels const& kernels, bool strip,
                        ImageTables& tables) {
  for (MachineKernel const& kernel : kernels.all()) {
    add_kernel(kernel.specification, *kernel.compiled, strip, tables);
  }
  std::vector<std::uint32_t> first_members;
  for (PlannedGroup const& group : plan.groups) first_members.push_back(add_group(group, strip, tables));
  for (PlannedSlot const& slot : plan.slots) {
    add_slot(slot, slot.group ? first_members[*slot.group] : 0, tables);
  }
}

}  // namespace axisc::codegen
