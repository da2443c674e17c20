// State that all blocks of a program share.
#pragma once

#include "analysis/motion/path_listener.hpp"
#include "analysis/motion/program/channel.hpp"
#include "analysis/motion/program/modal_words.hpp"
#include "analysis/motion/program/problems.hpp"
#include "analysis/motion/program/variables.hpp"

#include <optional>

namespace axisc::motion {

struct ProgramState {
  ProgramChannel channel;
  PathListener& listener;
  ProgramProblems problems;
  ProgramVariables variables{};
  ModalWords modal{};
  bool ended = false;
  /// The control rounds corners of this program, which are followed as they are: by so many mm at most.
  std::optional<double> rounding = std::nullopt;

  void end() {
    ended = true;
    problems.finish();
    listener.end();
  }
};

}  // namespace axisc::motion
