#include "validator/views/axis_delay.hpp"

#include "design/filter_design.hpp"
#include "validator/views/fir_view.hpp"
#include "validator/views/guard_view.hpp"
#include "validator/views/hsc_view.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axisc::validator {
namespace {

class Sum {
 public:
  Sum(EffectiveValues const& values, design::CycleTime cycle_time)
      : values_(values), cycle_time_(cycle_time) {}

  std::optional<AxisDelay> take() {
    if (!add_filters() || !add_hsc() || !add_fir() || !add_guard()) return std::nullopt;
    return result_;
  }

 private:
  static std::string name_of(FilterView const& filter) {
    return "filter[" + std::to_string(filter.index) + "]";
  }

  void add(std::string filter, double cycles, EffectiveValue const& cause) {
    result_.cycles += cycles;
    result_.shares.push_back({.filter = std::move(filter), .cycles = cycles, .cause = &cause});
    if (result_.cause != nullptr && std::abs(cycles) <= largest_) return;
    largest_ = std::abs(cycles);
    result_.cause = &cause;
  }

  /// False if something cannot be designed.
  bool add_filters() {
    for (FilterView const& filter : touched_filters(values_)) {
      if (filter.port != FilterPort::setpoint || is_configured_hsc(filter)) continue;
      if (filter.unusable()) return false;
      if (!filter.active()) continue;
      auto const specification = filter.specification(cycle_time_);
      if (!specification) return false;
      auto const design = design::design_filter(*specification, cycle_time_, design::Precision::quick);
      add(name_of(filter), design.group_delay_cycles, filter.anchor(filter.enable));
      result_.filters.push_back(*specification);
    }
    return true;
  }

  bool add_hsc() {
    for (FilterView const& filter : configured_hsc(values_)) {
      if (hsc_type(filter) == HscType::novib && !(filter.order.value.number > 0)) continue;
      auto const kernel = hsc_kernel(filter, cycle_time_);
      if (!kernel || filter.index != 0) return false;
      result_.kernel = machine::ConfiguredKernel{
          .family = machine::KernelFamily::hsc, .index = 0, .specification = *kernel, .on_at_start = false};
      EffectiveValue const& cause = filter.order.value.number > 0 ? filter.order : filter.time_constant;
      add(name_of(filter), design::kernel_delay_cycles(*kernel, cycle_time_),
          cause.set() ? cause : filter.prototype);
    }
    return true;
  }

  bool add_fir() {
    FirView const fir(values_);
    if (!fir.configured()) return !fir.type.unusable;
    auto const kernel = fir.specification(cycle_time_);
    if (!kernel) return false;
    result_.kernel = machine::ConfiguredKernel{.family = machine::KernelFamily::fir,
                                               .index = 0,
                                               .specification = *kernel,
                                               .on_at_start = fir.enable.value.flag()};
    EffectiveValue const& cause = fir.order.value.number > 0 ? fir.order : fir.order_time;
    add("filter_fir", design::kernel_delay_cycles(*kernel, cycle_time_), cause.set() ? cause : fir.type);
    return true;
  }

  /// One beside a FIR or HSC filter is switched off by the control.
  bool add_guard() {
    GuardView const guard(values_);
    if (!guard.is_active()) return !guard.active.unusable;
    if (result_.kernel) return true;
    auto const kernel = guard.specification(cycle_time_);
    if (!kernel || !can_be_compiled(*kernel, cycle_time_)) return false;
    result_.kernel = machine::ConfiguredKernel{
        .family = machine::KernelFamily::guard, .index = 0, .specification = *kernel, .on_at_start = true};
    add("vib_guard", design::kernel_delay_cycles(*kernel, cycle_time_), guard.anchor(guard.frequency));
    return true;
  }

  EffectiveValues const& values_;
  design::CycleTime cycle_time_;
  AxisDelay result_;
  double largest_ = 0;
};

}  // namespace

std::optional<AxisDelay> axis_delay(EffectiveValues const& values, design::CycleTime cycle_time) {
  return Sum(values, cycle_time).take();
}

AxisDelay at_start(AxisDelay delay) {
  if (!delay.kernel || delay.kernel->on_at_start) return delay;
  // It is the last in the chain.
  delay.cycles -= delay.shares.back().cycles;
  delay.shares.pop_back();
  delay.kernel.reset();
  auto const less = [](DelayShare const& left, DelayShare const& right) {
    return std::abs(left.cycles) < std::abs(right.cycles);
  };
  auto const most = std::max_element(delay.shares.begin(), delay.shares.end(), less);
  delay.cause = most == delay.shares.end() ? nullptr : most->cause;
  return delay;
}

}  // namespace axisc::validator
