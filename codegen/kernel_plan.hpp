// Which axis gets which kernel in which bank, and how long each change takes.
#pragma once

#include "codegen/compiled_kernels.hpp"
#include "configuration/machine/machine.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace axisc::codegen {

/// The kernel of an axis.
struct PlannedSlot {
  std::size_t axis = 0;
  machine::KernelFamily family = machine::KernelFamily::fir;
  std::uint32_t index = 0;           ///< i of filter[i] for HSC
  std::uint32_t kernel = no_kernel;  ///< of the lists' values
  bool on_at_start = false;
  std::uint32_t history = 0;         ///< tail sums of the longest kernel it may execute
  std::optional<std::size_t> group;  ///< none: no command reaches it
  std::size_t member = 0;            ///< place in its group
};

/// A set of parameters of #FILTER or #VIB GUARD.
struct PlannedBank {
  machine::FilterParameters parameters;
  bool hsc = false;
  std::vector<std::uint32_t> choices;  ///< kernel of each member
  std::uint32_t fade_cycles = 0;       ///< 0: at standstill only
};

struct PlannedGroup {
  std::string name;
  std::vector<std::size_t> members;  ///< axes
  std::vector<PlannedBank> banks;    ///< the first holds the lists' values of #FILTER
  std::uint32_t off_fade_cycles = 0;
};

struct KernelPlan {
  std::vector<PlannedSlot> slots;    ///< by rising axis
  std::vector<PlannedGroup> groups;  ///< those of which an axis has a slot
};

/// `peak_gain(axis)` is that of the axis' other filters. Designs every kernel that a command can call for. An
/// axis that several groups name belongs to the first of them.
[[nodiscard]] KernelPlan plan_kernels(machine::Machine const& machine, CompiledKernels& kernels,
                                      std::function<double(std::size_t axis)> const& peak_gain);

}  // namespace axisc::codegen
