#include "runtime/limits.hpp"
#include "runtime/verification/verify_checks.hpp"

namespace axisc::runtime {
namespace {

constexpr uint32_t kernel_types = 6;
constexpr uint32_t all_keywords = 63;
constexpr uint32_t no_keywords_of_guards = axim_keyword_share | axim_keyword_hsc;

axisrt_status check_tail(Record<record::tail> tail) {
  double const value = tail[field::tail::value];
  axisrt_status const status = check_finite(value);
  return status == AXISRT_OK ? check_bounds(is_within(value, largest_tail)) : status;
}

/// 2h tails and a delay of h cycles; as many tails as cycles for the time delay.
bool fits_its_tails(Record<record::kernel> kernel, uint32_t tails) {
  uint32_t const h = kernel[field::kernel::half_width];
  uint32_t const delay = kernel[field::kernel::delay_cycles];
  return h == 0 ? delay == tails : h <= tails && 2 * h == tails && delay == h;
}

/// Checks everything in the proof that can be judged without computing it again.
axisrt_status check_proof(Record<record::kernel> kernel) {
  double const sum = kernel[field::kernel::kernel_sum];
  double const peak_gain = kernel[field::kernel::peak_gain];
  double const overshoot = kernel[field::kernel::overshoot];
  double const tail_gain = kernel[field::kernel::tail_gain];
  axisrt_status const status =
      check_finite(kernel[field::kernel::group_delay], sum, peak_gain, overshoot, tail_gain);
  if (status != AXISRT_OK) return status;
  return check_bounds(sum == 1, is_possible_gain(peak_gain, 1), overshoot >= 0, tail_gain >= 0);
}

axisrt_status check_kernel(ImageView const& view, Record<record::kernel> kernel) {
  uint32_t const type = kernel[field::kernel::type];
  if (type >= kernel_types) return AXISRT_UNKNOWN_KIND;
  uint32_t const tails = kernel[field::kernel::tail_count];
  if (tails > (type == axim_kernel_guard ? axim_most_guard_tails : axim_most_tails))
    return AXISRT_KERNEL_TOO_LONG;
  return first_failure(
      [&] {
        return check_bounds(tails >= 1, view.tails.holds(kernel[field::kernel::first_tail], tails),
                            fits_its_tails(kernel, tails));
      },
      [&] {
        return check_samples(view, kernel[field::kernel::first_sample], kernel[field::kernel::sample_count]);
      },
      [&] {
        return check_finite(kernel[field::kernel::share_percent], kernel[field::kernel::frequency],
                            kernel[field::kernel::quality]);
      },
      [&] { return check_proof(kernel); });
}

/// None, or a kernel that fits into the slot's history.
bool is_executable(ImageView const& view, uint32_t kernel, uint32_t history) {
  if (kernel == AXIM_NONE) return true;
  return kernel < view.kernels.count && view.kernels[kernel][field::kernel::tail_count] <= history;
}

axisrt_status check_slot(ImageView const& view, Record<record::slot> slot, uint32_t index) {
  uint32_t const family = slot[field::slot::family];
  if (family < axim_family_hsc || family > axim_family_guard) return AXISRT_UNKNOWN_KIND;
  uint32_t const history = slot[field::slot::history];
  if (history > (family == axim_family_guard ? axim_most_guard_tails : axim_most_tails))
    return AXISRT_KERNEL_TOO_LONG;
  uint32_t const axis = slot[field::slot::axis];
  bool const ascends = index == 0 || axis > view.slots[index - 1][field::slot::axis];
  uint32_t const member = slot[field::slot::member];
  bool const belongs = slot[field::slot::group] == AXIM_NONE
                           ? member == AXIM_NONE
                           : member < view.members.count &&
                                 view.members[member][field::member::axis] == axis &&
                                 slot[field::slot::group] < view.groups.count;
  return check_bounds(axis < view.axes.count, ascends, belongs, slot[field::slot::index] < axim_most_filters,
                      slot[field::slot::on_at_start] <= 1,
                      is_executable(view, slot[field::slot::kernel], history));
}

uint32_t find_slot(ImageView const& view, uint32_t axis) {
  return find_axis(view.slots, field::slot::axis, axis);
}

/// Member and slot name each other, so that commands of two groups never reach one slot.
axisrt_status check_member(ImageView const& view, uint32_t group, uint32_t member) {
  uint32_t const axis = view.members[member][field::member::axis];
  if (axis >= view.axes.count) return AXISRT_OUT_OF_BOUNDS;
  uint32_t const slot = find_slot(view, axis);
  if (slot == view.slots.count) return AXISRT_OK;
  return check_bounds(view.slots[slot][field::slot::group] == group,
                      view.slots[slot][field::slot::member] == member);
}

axisrt_status check_choice(ImageView const& view, uint32_t member, uint32_t choice) {
  uint32_t const kernel = view.choices[choice][field::choice::kernel];
  uint32_t const slot = find_slot(view, view.members[member][field::member::axis]);
  if (slot == view.slots.count) return check_bounds(kernel == AXIM_NONE);
  return check_bounds(is_executable(view, kernel, view.slots[slot][field::slot::history]));
}

/// The parts of shared sections that earlier groups have claimed.
struct Claimed {
  uint32_t members = 0;
  uint32_t banks = 0;
  uint32_t choices = 0;
};

axisrt_status check_bank(ImageView const& view, uint32_t first_member, uint32_t members,
                         Record<record::bank> bank, uint32_t& next_choice) {
  uint32_t const keywords = bank[field::bank::keywords];
  if (keywords > all_keywords) return AXISRT_UNKNOWN_KIND;
  bool const guard = (keywords & axim_keyword_guard) != 0;
  if (guard && (keywords & no_keywords_of_guards) != 0) return AXISRT_UNKNOWN_KIND;
  axisrt_status status =
      check_finite(bank[field::bank::share], bank[field::bank::frequency], bank[field::bank::quality]);
  if (status != AXISRT_OK) return status;
  status =
      check_bounds(bank[field::bank::first_choice] == next_choice, view.choices.holds(next_choice, members),
                   bank[field::bank::fade_cycles] <= axim_most_fade_cycles);
  for (uint32_t i = 0; i < members && status == AXISRT_OK; ++i) {
    status = check_choice(view, first_member + i, next_choice + i);
  }
  next_choice += members;
  return status;
}

axisrt_status check_group(ImageView const& view, uint32_t index, Claimed& claimed) {
  Record<record::group> const group = view.groups[index];
  uint32_t const members = group[field::group::member_count];
  uint32_t const banks = group[field::group::bank_count];
  axisrt_status status = check_bounds(
      view.names.holds(group[field::group::name_offset], group[field::group::name_size]),
      group[field::group::first_member] == claimed.members, view.members.holds(claimed.members, members),
      banks >= 1, group[field::group::first_bank] == claimed.banks, view.banks.holds(claimed.banks, banks),
      group[field::group::off_fade_cycles] <= axim_most_fade_cycles);
  for (uint32_t i = 0; i < members && status == AXISRT_OK; ++i) {
    status = check_member(view, index, claimed.members + i);
  }
  for (uint32_t i = 0; i < banks && status == AXISRT_OK; ++i) {
    status = check_bank(view, claimed.members, members, view.banks[claimed.banks + i], claimed.choices);
  }
  claimed.members += members;
  claimed.banks += banks;
  return status;
}

axisrt_status check_groups(ImageView const& view) {
  Claimed claimed;
  for (uint32_t i = 0; i < view.groups.count; ++i) {
    axisrt_status const status = check_group(view, i, claimed);
    if (status != AXISRT_OK) return status;
  }
  return check_bounds(claimed.members == view.members.count, claimed.banks == view.banks.count,
                      claimed.choices == view.choices.count);
}

}  // namespace

axisrt_status check_kernels(ImageView const& view) {
  return first_failure(
      [&] { return check_each(view.tails, [](auto tail, uint32_t) { return check_tail(tail); }); },
      [&] {
        return check_each(view.kernels, [&](auto kernel, uint32_t) { return check_kernel(view, kernel); });
      },
      [&] {
        return check_each(view.slots,
                          [&](auto slot, uint32_t index) { return check_slot(view, slot, index); });
      },
      [&] { return check_groups(view); });
}

}  // namespace axisc::runtime
