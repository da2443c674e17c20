// A chain as lines of an axis list.
#pragma once

#include "analysis/tuning/suggestion/task.hpp"
#include "diagnostics/message.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc::tuning {

struct ListLine {
  std::string name;   ///< `filter_fir.order`
  std::string value;  ///< as a list writes it

  friend bool operator==(ListLine const&, ListLine const&) = default;
};

/// The parameters that the chain uses, in the order of the chain. A kernel is `filter_fir` or `vib_guard`, on
/// from start-up, or the HSC filter in `filter[0]`, which the NC program switches on; standard filters are
/// low-passes and band-stops. `family`: that of linear-phase kernels.
[[nodiscard]] std::vector<ListLine> list_lines(Chain const& chain, machine::KernelFamily family);

/// "#FILTER ON [AX_DEV=0.01]", "#VIB GUARD ON [AX_DEV=0.01]": what an NC program writes to keep the
/// tolerance, in its own unit, at corners; "#FILTER ON [HSC]" for the HSC filter, which monitors none. None
/// for a chain without a kernel, which no command acts on.
[[nodiscard]] std::optional<std::string> filter_command(Chain const& chain, machine::KernelFamily family,
                                                        double tolerance);

/// "LOWPASS order 2, 30 Hz + Gaussian order 40"; "-" for an empty chain.
[[nodiscard]] std::string short_name(Chain const& chain, Language language);

}  // namespace axisc::tuning
