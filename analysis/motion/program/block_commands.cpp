#include "analysis/motion/program/block_commands.hpp"

#include "analysis/motion/program/dynamics/motion_commands.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

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

}  // namespace

void take_other_command(std::size_t at, NcBlock const& block, ProgramState& state) {
  Token const& token = block.tokens[at];
  auto const kind = block.commands[*token.command].kind;
  if (kind == grammar::CommandKind::axis_exchange) return state.problems.refuse(block, token);
  if (auto const* const word = motion_command_at(at, block)) {
    return take_motion_command(*word, at, block, state);
  }
  auto const command = written(at, block);
  if (is_geometric(command)) {
    state.problems.refuse(block, token);
  } else {
    state.problems.ignore(block, token, command, says::not_simulated);
  }
}

}  // namespace axisc::motion
