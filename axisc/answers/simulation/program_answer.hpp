// What `simulate --program` says of a program: its blocks and passes.
#pragma once

#include "axisc/answers/simulation/cycle_table.hpp"
#include "axisc/answers/simulation/followed_program.hpp"
#include "presentation/document.hpp"

#include <vector>

namespace axisc {

/// Blocks and passes as they end. The first of them are kept, the others only counted: memory does not grow
/// with the program.
class ProgramSummary {
 public:
  /// The path outlives this.
  explicit ProgramSummary(SimulatedPath const& path);

  void block(motion::BlockSummary const& summary);
  void pass(motion::PassSummary const& summary);

  [[nodiscard]] presentation::Table const& passes() const { return passes_; }
  /// Takes what is kept.
  [[nodiscard]] presentation::Document answer(FollowedProgram const& followed) &&;

  static constexpr std::size_t most_rows = 10'000;  ///< of blocks, and of passes

 private:
  /// A row that begins so and ends with `rest`.
  void add(presentation::Table& table, presentation::Row row, motion::PathSummary const& summary,
           presentation::Row const& rest);

  SimulatedPath const& path_;
  presentation::Table blocks_, passes_;
};

struct SimulatedProgram {
  presentation::Document answer;
  std::vector<motion::PassSummary> exceeded;  ///< passes that do not keep their tolerance
};

/// Follows a program that survey_program() accepted; `rows` get every cycle. Failure where the runtime
/// refuses a step or a command.
[[nodiscard]] SimulatedProgram simulate_answer(ProgramLines& program, ProgramRequest const& request,
                                               machine::Machine const& machine, std::size_t group,
                                               SimulatedPath const& path,
                                               std::vector<CycleWriter*> const& rows);

}  // namespace axisc
