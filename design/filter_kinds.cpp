#include "design/filter_kinds.hpp"

namespace axisc::design {

bool is_in_range(FilterSpecification const& specification, CycleTime nc_cycle_time) {
  CycleTime const cycle_time = as_read(nc_cycle_time, specification.cycle_time);
  FilterKind const& kind = kind_of(specification.type);
  double const f = specification.frequency.value;
  bool const is_frequency_good = !kind.uses_frequency || (f > 0 && f < cycle_time.nyquist().value);
  bool const is_quality_good = !kind.quality || kind.quality->fits(specification.quality);
  bool const is_time_good =
      !kind.time_constant || kind.time_constant->fits(cycle_time.cycles(specification.time_constant));
  bool const is_share_good = specification.share_percent >= 0 && specification.share_percent <= 100;
  return kind.order.fits(specification.order) && is_frequency_good && is_quality_good && is_time_good &&
         is_share_good;
}

}  // namespace axisc::design
