#include "design/filter_design_def.hpp"
#include "design/filter_design_instances.hpp"

namespace axisc::design {

FilterDesign design_quick(FilterSpecification const& specification, CycleTime cycle_time) {
  return design_in<double>(specification, cycle_time);
}

}  // namespace axisc::design
