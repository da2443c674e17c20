#include "runtime/bounds/change_bound.hpp"

#include "runtime/bounds/bound_record.hpp"
#include "runtime/bounds/outward.hpp"
#include "runtime/verification/verify_checks.hpp"

namespace axisc::runtime::bounds {
namespace {

/// Which kernels a bank concerns.
uint32_t family_of(uint32_t keywords) {
  if ((keywords & axim_keyword_guard) != 0) return axim_family_guard;
  return (keywords & axim_keyword_hsc) != 0 ? axim_family_hsc : axim_family_fir;
}

/// Factor for the roundings of a sum of up to 960 terms: less than largest_change allows for.
constexpr double sum_rounding = 1 + 0x1p-40;

double tail_distance(KernelPart const& a, KernelPart const& b) {
  double sum = 0;
  uint32_t const count = a.count > b.count ? a.count : b.count;
  for (uint32_t j = 0; j < count; ++j) sum += magnitude(a.tail(j) - b.tail(j));
  return sum * sum_rounding;
}

class Changes {
 public:
  Changes(ImageView const& view, uint32_t axis, double gain) : view_(view), axis_(axis), gain_(gain) {
    double const T = view.header()[field::header::cycle_time_ns] * 1e-9;
    velocity_ = limit_of_axis(view, axis);
    acceleration_ = view.axes[axis][field::axis::acceleration_limit] * 1e4 * T * T;
  }

  void add_kernel(uint32_t to, uint32_t cycles) {
    if (cycles == 0 || !(velocity_ > 0) || !(acceleration_ > 0)) return;
    BoundKeys keys(view_, axis_);
    BoundKey from{};
    KernelPart const target = read_kernel(view_, to, false);
    while (keys.next(from) && from.axis == axis_ && from.port == axim_port_setpoint) {
      add_distance(tail_distance(read_kernel(view_, from.kernel, false), target), cycles);
    }
  }

  [[nodiscard]] ChangeBound const& largest() const { return largest_; }

 private:
  void add_distance(double distance, uint32_t cycles) {
    constexpr double ten_over_root_3 = 5.773502691896258;
    double const F = cycles;
    double const L = gain_ * distance;
    double const velocity = 15 / (8 * F) * L;
    double const acceleration =
        ten_over_root_3 / (F * F) * L * (velocity_ / acceleration_) + 15 / (4 * F) * L;
    if (acceleration > largest_.acceleration) largest_.cycles = cycles;
    largest_.velocity = larger(largest_.velocity, velocity);
    largest_.acceleration = larger(largest_.acceleration, acceleration);
  }

  ImageView const& view_;
  uint32_t axis_;
  double gain_, velocity_ = 0, acceleration_ = 0;
  ChangeBound largest_{};
};

}  // namespace

ChangeBound bound_changes(ImageView const& view, uint32_t axis, double gain) {
  Changes changes(view, axis, gain);
  uint32_t const number = find_axis(view.slots, field::slot::axis, axis);
  if (number == view.slots.count) return {};
  Record<record::slot> const slot = view.slots[number];
  if (slot[field::slot::group] == AXIM_NONE) return {};
  Record<record::group> const group = view.groups[slot[field::slot::group]];
  changes.add_kernel(AXIM_NONE, group[field::group::off_fade_cycles]);
  uint32_t const place = slot[field::slot::member] - group[field::group::first_member];
  for (uint32_t i = 0; i < group[field::group::bank_count]; ++i) {
    Record<record::bank> const bank = view.banks[group[field::group::first_bank] + i];
    if (family_of(bank[field::bank::keywords]) != slot[field::slot::family]) continue;
    uint32_t const choice = bank[field::bank::first_choice] + place;
    changes.add_kernel(view.choices[choice][field::choice::kernel], bank[field::bank::fade_cycles]);
  }
  return changes.largest();
}

}  // namespace axisc::runtime::bounds
