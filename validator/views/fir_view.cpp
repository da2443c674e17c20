#include "validator/views/fir_view.hpp"

#include "design/kernels/kernel_kinds.hpp"

#include <array>
#include <cstddef>

namespace axisc::validator {
namespace {

constexpr std::array kernels{
    design::KernelType::moving_average,
    design::KernelType::gaussian,
    design::KernelType::windowed_sinc,
    design::KernelType::time_delay,
};

/// Views are made by the thousand; the names are looked up once.
struct FirSlots {
  schema::Slot enable = row_at("filter_fir.enable").first_slot;
  schema::Slot type = row_at("filter_fir.type").first_slot;
  schema::Slot order = row_at("filter_fir.order").first_slot;
  schema::Slot order_time = row_at("filter_fir.order_time").first_slot;
  schema::Slot share = row_at("filter_fir.share").first_slot;
  schema::Slot frequency = row_at("filter_fir.fcut").first_slot;
  schema::Slot quality = row_at("filter_fir.quality").first_slot;
};

FirSlots const& fir_slots() {
  static FirSlots const known;
  return known;
}

}  // namespace

FirView::FirView(EffectiveValues const& values)
    : enable(values[fir_slots().enable]),
      type(values[fir_slots().type]),
      order(values[fir_slots().order]),
      order_time(values[fir_slots().order_time]),
      share(values[fir_slots().share]),
      frequency(values[fir_slots().frequency]),
      quality(values[fir_slots().quality]),
      readings(values.readings()) {}

bool FirView::has_unknown_type() const {
  double const number = type.value.number;
  return !type.unusable && (number < 0 || number > static_cast<double>(kernels.size()));
}

FirType FirView::configured_type() const {
  double const number = type.value.number;
  if (type.unusable || has_unknown_type() || number < 1) return FirType::none;
  return static_cast<FirType>(static_cast<int>(number));
}

std::uint32_t FirView::longest_order() const {
  FirType const kind = configured_type();
  if (kind == FirType::none) return design::longest_kernel_order;
  return design::longest_order(kernels[static_cast<std::size_t>(kind) - 1], readings.kernels);
}

double FirView::resulting_order(design::CycleTime cycle_time) const {
  if (order.value.number > 0) return order.value.number;
  return design::order_of_time({order_time.value.number}, cycle_time).value_or(0);
}

std::optional<design::KernelSpecification> FirView::specification(design::CycleTime cycle_time) const {
  if (!configured() || enable.unusable || order.unusable || order_time.unusable || share.unusable) {
    return std::nullopt;
  }
  design::KernelKind const& kind = design::kind_of(kernels[static_cast<std::size_t>(configured_type()) - 1]);
  double const resulting = resulting_order(cycle_time);
  design::KernelSpecification specification;
  specification.type = kind.type;
  specification.share_percent = share.value.number;
  specification.reading = readings.kernels;
  specification.cycle_time = readings.cycle_time;
  bool const in_range = resulting <= longest_order() && share.value.number >= 0 && share.value.number <= 100;
  if (!in_range) return std::nullopt;
  specification.order = static_cast<std::uint32_t>(resulting);
  if (kind.uses_frequency) {
    specification.frequency = {frequency.value.number};
    bool const fits = frequency.value.number > 0 &&
                      specification.frequency < design::as_read(cycle_time, readings.cycle_time).nyquist();
    if (frequency.unusable || !fits) return std::nullopt;
  }
  if (kind.uses_quality) {
    specification.quality = quality.value.number;
    bool const fits = quality.value.number > 0 && quality.value.number <= 1;
    if (quality.unusable || !fits) return std::nullopt;
  }
  return specification;
}

EffectiveValue const& FirView::anchor(EffectiveValue const& wanted) const {
  if (wanted.set()) return wanted;
  if (enable.set()) return enable;
  if (type.set()) return type;
  for (EffectiveValue const* const value : {&order, &order_time, &share, &frequency, &quality}) {
    if (value->set()) return *value;
  }
  return type;
}

}  // namespace axisc::validator
