#include "validator/fir_view.hpp"

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

}  // namespace

FirView::FirView(EffectiveValues const& values)
    : enable(values.at("filter_fir.enable")),
      type(values.at("filter_fir.type")),
      order(values.at("filter_fir.order")),
      order_time(values.at("filter_fir.order_time")),
      share(values.at("filter_fir.share")),
      frequency(values.at("filter_fir.fcut")),
      quality(values.at("filter_fir.quality")) {}

FirType FirView::configured_type() const {
  double const number = type.value.number;
  if (type.unusable || number < 1 || number > 4) return FirType::none;
  return static_cast<FirType>(static_cast<int>(number));
}

std::uint32_t FirView::longest_order() const {
  return configured_type() == FirType::time_delay ? design::longest_kernel_delay
                                                  : design::longest_kernel_order;
}

double FirView::resulting_order(design::CycleTime cycle_time) const {
  if (order.value.number > 0) return order.value.number;
  return design::order_of_time({order_time.value.number}, cycle_time).value_or(0);
}

std::optional<design::KernelSpecification> FirView::specification(design::CycleTime cycle_time) const {
  if (!configured() || enable.unusable || order.unusable || order_time.unusable || share.unusable) {
    return std::nullopt;
  }
  FirType const kind = configured_type();
  double const resulting = resulting_order(cycle_time);
  design::KernelSpecification specification;
  specification.type = kernels[static_cast<std::size_t>(kind) - 1];
  specification.share_percent = share.value.number;
  bool const in_range = resulting <= longest_order() && share.value.number >= 0 && share.value.number <= 100;
  if (!in_range) return std::nullopt;
  specification.order = static_cast<std::uint32_t>(resulting);
  if (kind == FirType::windowed_sinc) {
    specification.frequency = {frequency.value.number};
    bool const fits =
        frequency.value.number > 0 && specification.frequency.value < cycle_time.nyquist().value;
    if (frequency.unusable || !fits) return std::nullopt;
  }
  if (kind == FirType::gaussian) {
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
