// Designs in 50 digits, in one source: the arithmetic costs the compiler more than the formulas.
#include "design/filter_design_def.hpp"
#include "design/filter_design_instances.hpp"
#include "design/kernels/kernel_design_def.hpp"
#include "design/oscillator_def.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace axisc::design {
namespace {

namespace multiprecision = boost::multiprecision;
using Exact = multiprecision::number<multiprecision::cpp_bin_float<50>, multiprecision::et_off>;

}  // namespace

FilterDesign design_exact(FilterSpecification const& specification, CycleTime cycle_time) {
  return design_in<Exact>(specification, cycle_time);
}

FilterDesign design_exact(OscillatorSpecification const& specification, CycleTime cycle_time) {
  return oscillator_in<Exact>(specification, cycle_time);
}

KernelDesign design_kernel(KernelSpecification const& specification, CycleTime cycle_time) {
  return design_kernel_in<Exact>(specification, cycle_time);
}

}  // namespace axisc::design
