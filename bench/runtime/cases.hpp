// The machines that are measured, as images for the runtime and as axes for the plain loops.
#pragma once

#include "bench/runtime/plain_loops.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace axisc::bench {

struct Case {
  char const* name;
  char const* text;
};

/// (a) to (f) of the benchmarks; d and e share one kernel, d_own has one for each axis.
[[nodiscard]] std::vector<Case> const& cases();

struct Contender {
  std::vector<std::byte> image;
  std::vector<PlainAxis> plain;
};

[[nodiscard]] Contender make_case(std::string const& name, std::size_t axes);

}  // namespace axisc::bench
