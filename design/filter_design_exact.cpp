#include "design/filter_design_def.hpp"
#include "design/filter_design_instances.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace axisc::design {

FilterDesign design_exact(FilterSpecification const& specification, CycleTime cycle_time) {
  namespace multiprecision = boost::multiprecision;
  using Exact = multiprecision::number<multiprecision::cpp_bin_float<50>, multiprecision::et_off>;
  return design_in<Exact>(specification, cycle_time);
}

}  // namespace axisc::design
