// What delays each axis of a machine, on the way of its position and on that of feedforward.
#pragma once

#include "axisc/checking/path_machine.hpp"
#include "presentation/document.hpp"
#include "validator/loading/loading.hpp"

#include <optional>

namespace axisc {

struct DelayBudgetQuestion {
  MachineRequest machine;
  /// mm/min; none: the lowest velocity limit (P-AXIS-00212) of each channel.
  std::optional<double> feed = {};
};

/// The budget of every axis of a machine with a cycle time, and the largest difference of each channel. An
/// axis of which a filter cannot be designed has no budget. `feed` as in DelayBudgetQuestion.
[[nodiscard]] presentation::Section delay_budget_section(validator::LoadedMachine const& machine,
                                                         SourceSet const& sources,
                                                         std::optional<double> feed);

/// None after errors. Failure for what checked_machine() refuses.
[[nodiscard]] std::optional<presentation::Document> delay_budget_answer(Workspace& workspace,
                                                                        DelayBudgetQuestion const& question,
                                                                        ErrorSink const& errors);

}  // namespace axisc
