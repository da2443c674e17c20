#include "analysis/motion/contour/ramp_answer.hpp"

namespace axisc::motion {

std::vector<double> ramp_answer(std::span<double const> taps) {
  std::vector<double> ramp{0.0};
  double step = 0;
  for (double const tap : taps) {
    step += tap;
    ramp.push_back(ramp.back() + step);
  }
  ramp.push_back(ramp.back() + step);
  return ramp;
}

}  // namespace axisc::motion
