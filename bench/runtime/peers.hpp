// Libraries that can do a case: rtfilter (double, one set of coefficients for all channels) and liquid-dsp
// (single precision: fast enough to compare with, too coarse for positions).
#pragma once

#include "bench/runtime/plain_loops.hpp"

#include <functional>
#include <string>
#include <vector>

namespace axisc::bench {

struct Peer {
  std::string name;
  std::function<void(double const* in, double* out)> step;
};

[[nodiscard]] std::vector<Peer> make_peers(std::string const& case_name, std::vector<PlainAxis> const& axes);

}  // namespace axisc::bench
