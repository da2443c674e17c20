#include "validator/rules/fir_order_time.hpp"

namespace axisc::validator::checks {

bool uses_order_time(FirView const& fir) {
  if (!fir.configured() || fir.order.unusable || fir.order_time.unusable) return false;
  return !(fir.order.value.number > 0) && fir.order_time.value.number > 0;
}

bool is_too_short(FirView const& fir, design::CycleTime cycle_time) {
  return cycle_time.cycles({fir.order_time.value.number}) < 1;
}

bool is_too_long(FirView const& fir, design::CycleTime cycle_time) {
  return cycle_time.cycles({fir.order_time.value.number}) > fir.longest_order();
}

}  // namespace axisc::validator::checks
