#include "design/readings.hpp"

#include "design/filter_kinds.hpp"
#include "design/kernels/kernel_kinds.hpp"

namespace axisc::design {
namespace {

bool changes(FilterReading reading, FilterSpecification const& wanted) {
  FilterKind const& kind = kind_of(wanted.type);
  switch (reading) {
    case FilterReading::no_prewarping:
    case FilterReading::backward_euler:
    case FilterReading::forward_euler: return true;
    case FilterReading::matched:
    case FilterReading::matched_poles: return !kind.blocks_constant;
    case FilterReading::poles_at_frequency:
      return kind.uses_prototype && !kind.quality && wanted.prototype == Prototype::critical_damping &&
             wanted.order > 1;
    case FilterReading::analogue_quality: return kind.quality.has_value();
    case FilterReading::half_gain_at_frequency:
      return wanted.type == FilterType::lowpass || wanted.type == FilterType::highpass;
    case FilterReading::quality_of_poles:
      return kind.quality && wanted.prototype == Prototype::critical_damping && wanted.order > 1;
    case FilterReading::bessel_delay:
      return (wanted.type == FilterType::lowpass || wanted.type == FilterType::allpass) &&
             wanted.prototype == Prototype::bessel && wanted.order > 1;
    case FilterReading::allpass_phase:  // Butterworth filters do so anyway
      return wanted.type == FilterType::allpass && wanted.prototype != Prototype::butterworth &&
             wanted.order > 1;
    case FilterReading::documented: break;
  }
  return false;
}

bool has_order(KernelType type) {
  return type != KernelType::time_delay && type != KernelType::vibration_guard &&
         !kind_of(type).computes_order;
}

bool is_guard(KernelSpecification const& wanted) {
  return wanted.type == KernelType::vibration_guard;
}

bool is_symmetrical_guard(KernelSpecification const& wanted) {
  return is_guard(wanted) && wanted.order == 4;
}

bool changes(KernelReading reading, KernelSpecification const& wanted) {
  switch (reading) {
    case KernelReading::taps_n:
    case KernelReading::taps_n_plus_1:
    case KernelReading::half_width_rounded_down:
    case KernelReading::order_is_half_width: return has_order(wanted.type);
    case KernelReading::gaussian_width_1:
    case KernelReading::gaussian_width_2:
    case KernelReading::gaussian_width_3: return wanted.type == KernelType::gaussian;
    case KernelReading::sinc_hann:
    case KernelReading::sinc_blackman:
    case KernelReading::sinc_no_window: return wanted.type == KernelType::windowed_sinc;
    case KernelReading::novib_one_box: return wanted.type == KernelType::novib;
    case KernelReading::share_undelayed:
      return wanted.type != KernelType::time_delay && wanted.share_percent != 100;
    case KernelReading::share_ignored: return wanted.share_percent != 100;
    case KernelReading::guard_rounded:
    case KernelReading::guard_rounded_up:
    case KernelReading::guard_zero_placed: return is_guard(wanted);
    case KernelReading::guard_undamped_spacing: return is_guard(wanted) && wanted.quality > 0;
    case KernelReading::guard_quarters: return is_symmetrical_guard(wanted) && wanted.quality > 0;
    case KernelReading::guard_uncentred: return is_symmetrical_guard(wanted);
    case KernelReading::documented: break;
  }
  return false;
}

}  // namespace

FilterReading applied_reading(FilterSpecification const& specification) {
  bool const is_delay = specification.type == FilterType::time_delay;
  return !is_delay && changes(specification.reading, specification) ? specification.reading
                                                                    : FilterReading::documented;
}

KernelReading applied_reading(KernelSpecification const& specification) {
  return changes(specification.reading, specification) ? specification.reading : KernelReading::documented;
}

}  // namespace axisc::design
