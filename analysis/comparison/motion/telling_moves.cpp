#include "analysis/comparison/motion/telling_moves.hpp"

#include "analysis/comparison/motion/move_candidates.hpp"
#include "analysis/comparison/motion/planned_move.hpp"
#include "analysis/comparison/motion/recorded_path.hpp"
#include "analysis/motion/program/interpreter.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace axisc::comparison {

namespace {

/// Steps of a recording, position units. Rounded to one, plans that differ by more than two are told apart
/// whatever the constant.
constexpr double hidden_steps = 3;
/// A move that takes longer is no telling one.
constexpr double longest_move_s = 30;

using Plan = std::vector<motion::Point>;

/// The plan as a recording between two rests.
struct Played {
  RecordedPath path;
  Stretch moving, whole;
};

Played played(Plan const& plan, std::size_t axes, std::size_t rest) {
  Played found;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    std::vector<double> values(rest, plan.front()[axis]);
    for (auto const& point : plan) values.push_back(point[axis]);
    values.resize(values.size() + rest, plan.back()[axis]);
    found.path.positions.push_back(recorded_position(axis, std::move(values), hidden_steps));
  }
  found.moving = {.begin = rest, .end = rest + plan.size() - 1};
  found.whole = {.begin = 0, .end = found.path.size() - 1};
  return found;
}

/// Plans that a recording of this one cannot be told from, directly or by others between them, have the same
/// number.
std::vector<std::size_t> classes_of(std::vector<Plan> const& plans, std::size_t axes) {
  std::vector<std::size_t> classes(plans.size());
  std::iota(classes.begin(), classes.end(), 0);
  std::size_t longest = 0;
  for (auto const& plan : plans) longest = std::max(longest, plan.size());
  for (std::size_t i = 0; i < plans.size(); ++i) {
    auto const recording = played(plans[i], axes, longest);
    for (std::size_t k = i + 1; k < plans.size(); ++k) {
      if (classes[i] == classes[k]) continue;
      if (!deviation_of(plans[k], recording.path, recording.moving, recording.whole).fits()) continue;
      std::replace(classes.begin(), classes.end(), std::size_t(classes[k]), std::size_t(classes[i]));
    }
  }
  return classes;
}

/// Which readings of the keys that act in a move plan it alike.
struct MoveClasses {
  MotionKeys keys;
  std::map<Combination, std::size_t> classes;
};

std::optional<MoveClasses> move_classes(Move const& move, motion::PathDynamics const& dynamics) {
  MoveClasses found{.keys = acting_keys(move, dynamics), .classes = {}};
  std::vector<Plan> plans;
  auto const most = static_cast<std::size_t>(longest_move_s / dynamics.cycle_time.seconds());
  for (auto const& combination : all_combinations()) {
    auto const readings = only(combination, found.keys);
    if (found.classes.contains(readings)) continue;
    auto plan = planned_setpoints(move, dynamics, readings, most);
    if (!plan) return std::nullopt;
    auto const known = std::find(plans.begin(), plans.end(), *plan);
    found.classes[readings] = static_cast<std::size_t>(known - plans.begin());
    if (known == plans.end()) plans.push_back(*std::move(plan));
  }
  auto const classes = classes_of(plans, dynamics.axes.size());
  for (auto& [readings, number] : found.classes) number = classes[number];
  return found;
}

/// What the moves chosen so far say of each combination.
class Told {
 public:
  Told() : combinations_(all_combinations()), said_(combinations_.size()) {}

  void add(MoveClasses const& move) {
    for (std::size_t i = 0; i < combinations_.size(); ++i) {
      said_[i].push_back(move.classes.at(only(combinations_[i], move.keys)));
    }
  }
  /// Words of the key too many: those of combinations that look the same, less one each.
  [[nodiscard]] std::size_t confusion(MotionKey key) const {
    std::map<std::vector<std::size_t>, std::set<std::uint8_t>> words;
    for (std::size_t i = 0; i < combinations_.size(); ++i) {
      words[said_[i]].insert(combinations_[i].at(index_of(key)));
    }
    std::size_t sum = 0;
    for (auto const& [said, alike] : words) sum += alike.size() - 1;
    return sum;
  }
  /// Two readings of the key alone are told apart, with any readings of the others.
  [[nodiscard]] bool tells_some(MotionKey key) const {
    std::map<Combination, std::set<std::vector<std::size_t>>> said;
    for (std::size_t i = 0; i < combinations_.size(); ++i) {
      auto others = combinations_[i];
      others.at(index_of(key)) = 0;
      said[others].insert(said_[i]);
    }
    return std::any_of(said.begin(), said.end(), [](auto const& each) { return each.second.size() > 1; });
  }

 private:
  std::vector<Combination> combinations_;
  std::vector<std::vector<std::size_t>> said_;
};

NcLines opening_lines() {
  return {"G71 G91 G94 G359 G900 G117", "G131=100 G133=100 G134=100", pause_line()};
}

/// Of the lines after the opening; none where our own interpreter refuses one.
std::optional<std::vector<Move>> moves_of(NcLines const& lines, motion::ProgramChannel const& channel) {
  ProgramMoves moves(channel.cycle_time);
  bool is_refused = false;
  motion::ProgramInterpreter interpreter(channel, moves,
                                         [&is_refused](motion::ProgramProblem const&) { is_refused = true; });
  std::uint32_t offset = 0;
  for (auto const& part : {opening_lines(), lines}) {
    for (auto const& line : part) {
      interpreter.line(line, offset);
      offset += static_cast<std::uint32_t>(line.size()) + 1;
    }
  }
  interpreter.finish();
  if (is_refused || moves.problem() || moves.moves().empty()) return std::nullopt;
  return moves.moves();
}

/// Tries the candidates of a key until nothing more is to be told about it.
void choose(MotionKey key, motion::ProgramChannel const& channel, motion::PathDynamics const& dynamics,
            Told& told, TellingProgram& program) {
  auto confusion = told.confusion(key);
  for (auto& lines : move_candidates(key, channel, dynamics)) {
    if (confusion == 0) return;
    auto moves = moves_of(lines, channel);
    bool const may_tell = moves && std::any_of(moves->begin(), moves->end(), [&](Move const& move) {
                            return acting_keys(move, dynamics).test(index_of(key));
                          });
    if (!may_tell) continue;
    Told more = told;
    bool is_complete = true;
    for (auto const& move : *moves) {
      auto const classes = move_classes(move, dynamics);
      is_complete = is_complete && classes;
      if (classes) more.add(*classes);
    }
    auto const left = more.confusion(key);
    if (!is_complete || left >= confusion) continue;
    confusion = left;
    told = std::move(more);
    program.parts.push_back({.key = key, .lines = std::move(lines), .moves = *std::move(moves)});
  }
}

}  // namespace

TellingProgram telling_program(motion::ProgramChannel const& channel, motion::PathDynamics const& dynamics) {
  TellingProgram program{.opening = opening_lines(), .parts = {}, .outlook = {}};
  Told told;
  // One block alone first: what acts on every move.
  constexpr std::array order{MotionKey::cycles, MotionKey::sine,    MotionKey::projection, MotionKey::circle,
                             MotionKey::hsc,    MotionKey::borders, MotionKey::weights,    MotionKey::corner};
  for (auto const key : order) choose(key, channel, dynamics, told, program);
  for (auto const key : order) {
    auto const rest = told.confusion(key) == 0 ? Outlook::told : Outlook::partly;
    program.outlook.at(index_of(key)) = told.tells_some(key) ? rest : Outlook::not_told;
  }
  return program;
}

}  // namespace axisc::comparison
