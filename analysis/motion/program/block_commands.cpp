#include "analysis/motion/program/block_commands.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace axisc::motion::says {

constexpr Sentence cannot_simulate_slope{
    "`{word}`: the simulation plans with TYPE=STEP, TYPE=TRAPEZ or TYPE=SIN2 alone",
    "`{word}`: die Simulation plant nur mit TYPE=STEP, TYPE=TRAPEZ oder TYPE=SIN2"};

}  // namespace axisc::motion::says

namespace axisc::motion {
namespace {

/// The beginnings of commands that change where the path lies or how it is planned.
constexpr std::array<std::string_view, 21> geometric_commands = {
    "#ACS",   "#AKIMA", "#BCS",      "#CS",     "#ECS",    "#HSC",    "#KIN",
    "#MCS",   "#PTP",   "#ROTATION", "#RTCP",   "#SCALE",  "#SPLINE", "#TLC",
    "#TRAFO", "#CYL",   "#FACE",     "#MIRROR", "#GANTRY", "#DIST",   "#TURN"};

bool is_geometric(std::string_view command) {
  return std::any_of(geometric_commands.begin(), geometric_commands.end(),
                     [command](std::string_view name) { return command.starts_with(name); });
}

/// Only the name of other commands was read: the rest of the block belongs to them. Without blanks.
std::string written(std::size_t at, NcBlock const& block) {
  std::string command;
  for (; at < block.tokens.size(); ++at) command += block.text(block.tokens[at]);
  return command;
}

void begin_slope(machine::Slope slope, ModalWords& modal) {
  BlockDynamics changed = modal.dynamics ? *modal.dynamics : BlockDynamics{};
  changed.slope = slope;
  modal.dynamics = std::make_shared<BlockDynamics const>(changed);
}

}  // namespace

void take_other_command(std::size_t at, NcBlock const& block, ProgramState& state) {
  Token const& token = block.tokens[at];
  auto const kind = block.commands[*token.command].kind;
  if (kind == grammar::CommandKind::vibration_guard || kind == grammar::CommandKind::axis_exchange) {
    return state.problems.refuse(block, token);
  }
  auto const command = written(at, block);
  if (command == "#SLOPE[TYPE=TRAPEZ]") {
    begin_slope(machine::Slope::trapez, state.modal);
  } else if (command == "#SLOPE[TYPE=STEP]") {
    begin_slope(machine::Slope::step, state.modal);
  } else if (command == "#SLOPE[TYPE=SIN2]") {
    begin_slope(machine::Slope::sin2, state.modal);
  } else if (command == "#SLOPE[TYPE=HSC]") {
    begin_slope(machine::Slope::hsc, state.modal);
  } else if (command.starts_with("#SLOPE")) {
    state.problems.refuse(block, token, says::cannot_simulate_slope);
  } else if (is_geometric(command)) {
    state.problems.refuse(block, token);
  } else if (command.starts_with("#CONTOURMODEON")) {
    state.problems.refuse(block, token, says::cannot_simulate_rounding);
  } else {
    state.problems.ignore(block, token, command, says::not_simulated);
  }
}

}  // namespace axisc::motion
