#include "analysis/motion/program/block_dwell.hpp"

namespace axisc::motion::says {

constexpr Sentence cannot_simulate_dwell{
    "G04 needs a time in seconds, up to a day: `G04 X1.5`",
    "G04 braucht eine Zeit in Sekunden, höchstens einen Tag: `G04 X1.5`"};

}  // namespace axisc::motion::says

namespace axisc::motion {

void BlockDwell::take(Token const& token, double seconds) {
  constexpr double longest = 86400;
  if (seconds_) return state_.problems.refuse(block_, token, says::cannot_simulate_beside_dwell);
  if (!(seconds >= 0 && seconds <= longest)) {
    return state_.problems.refuse(block_, token, says::cannot_simulate_dwell);
  }
  seconds_ = seconds;
}

void BlockDwell::finish() {
  if (!word_) return;
  if (!seconds_) return state_.problems.refuse(block_, *word_, says::cannot_simulate_dwell);
  state_.listener.stop(*seconds_ / state_.channel.cycle_time.seconds(), word_->line);
}

}  // namespace axisc::motion
