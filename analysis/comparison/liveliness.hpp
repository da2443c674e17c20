// Where an axis changes its velocity most.
#pragma once

#include "analysis/recordings/signal.hpp"

namespace axisc::comparison {

using recordings::Signal;

/// The first cycle of the part of `length` cycles with the most changes of velocity; 0 where the signal is
/// not longer.
[[nodiscard]] std::size_t liveliest_part(Signal const& signal, std::size_t length);

}  // namespace axisc::comparison
