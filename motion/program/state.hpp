// What all blocks of a program share.
#pragma once

#include "motion/path_listener.hpp"
#include "motion/program/channel.hpp"
#include "motion/program/modal_words.hpp"
#include "motion/program/problems.hpp"
#include "motion/program/variables.hpp"

namespace axisc::motion {

struct ProgramState {
  ProgramChannel channel;
  PathListener& listener;
  ProgramProblems problems;
  ProgramVariables variables{};
  ModalWords modal{};
  bool ended = false;

  void end() {
    ended = true;
    problems.finish();
    listener.end();
  }
};

}  // namespace axisc::motion
