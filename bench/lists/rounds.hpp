// Contenders measured in interleaved rounds: each once per round, the ratio within the round, the median over
// the rounds. A machine whose pace changes between minutes then changes all of them alike.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace axisc::bench {

struct Contender {
  char const* name;
  std::size_t bytes = 0;  ///< of the text that one run reads, 0 where that says nothing
  std::size_t items = 0;  ///< what one run gets through: pairs, machines, mistakes
  std::function<void()> run;
  std::function<void()> prepare = {};  ///< before each run and not measured; may be empty
};

/// Runs and prints: medians of time, bytes and items per second, and how many items the contender gets
/// through in the time in which `reference` gets through one.
void measure(std::vector<Contender> const& contenders, std::size_t reference, std::size_t rounds,
             char const* items);

}  // namespace axisc::bench
