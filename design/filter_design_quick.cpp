#include "design/filter_design_def.hpp"
#include "design/filter_design_instances.hpp"
#include "design/oscillator_def.hpp"

namespace axisc::design {

FilterDesign design_quick(FilterSpecification const& specification, CycleTime cycle_time) {
  return design_in<double>(specification, cycle_time);
}

FilterDesign design_quick(OscillatorSpecification const& specification, CycleTime cycle_time) {
  return oscillator_in<double>(specification, cycle_time);
}

}  // namespace axisc::design
