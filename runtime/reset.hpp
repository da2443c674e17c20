// Steady states.
#pragma once

#include "runtime/filter_kernel.hpp"

namespace axisc::runtime {

/// Puts a filter into the steady state for a signal that has always been `in`, with in.d = 0; returns what
/// comes out.
Signal reset_filter(Filter const& filter, Signal const& in);

}  // namespace axisc::runtime
