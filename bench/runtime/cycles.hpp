// Single cycles instead of averages: how far they scatter, what standing still costs, what cold caches cost.
#pragma once

#include "bench/runtime/cases.hpp"

namespace axisc::bench {

/// Prints the distribution of a million cycles of the runtime and of the plain loop, standstill against
/// motion, cycles after the caches were emptied, and what a recorder adds.
void report_cycles(Contender& contender, std::size_t axes);

}  // namespace axisc::bench
