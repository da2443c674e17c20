#include "analysis/motion/program/dynamics/motion_commands.hpp"

#include "analysis/motion/program/dynamics/block_weights.hpp"
#include "analysis/motion/program/dynamics/command_reader.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace axisc::motion::says {

constexpr Sentence unknown_slope{
    "`{word}`: expected is [TYPE=STEP], [TYPE=TRAPEZ], [TYPE=SIN2], [TYPE=HSC] or DEFAULT (the control: "
    "120020)",
    "`{word}`: erwartet wird [TYPE=STEP], [TYPE=TRAPEZ], [TYPE=SIN2], [TYPE=HSC] oder DEFAULT (die "
    "Steuerung: 120020)"};
constexpr Sentence unknown_slope_number{
    "`{word}`: expected is #SET SLOPE PROFIL[0] to [3] (the control: 120178)",
    "`{word}`: erwartet wird #SET SLOPE PROFIL[0] bis [3] (die Steuerung: 120178)"};
constexpr Sentence unknown_vector_limit{
    "`{word}`: expected is ON or OFF with VEL, ACC, DEC and RADIAL_ACC, each without value or with one above "
    "0; other limits are not simulated",
    "`{word}`: erwartet wird ON oder OFF mit VEL, ACC, DEC und RADIAL_ACC, jeweils ohne Wert oder mit einem "
    "über 0; andere Grenzen werden nicht simuliert"};
constexpr Sentence unknown_corner_velocity{
    "`{word}`: expected is ON, ON [velocity] with a velocity of at least 0 in mm/min, or OFF",
    "`{word}`: erwartet wird ON, ON [Geschwindigkeit] mit mindestens 0 in mm/min, oder OFF"};

}  // namespace axisc::motion::says

namespace axisc::motion {

using schema::find_motion_word;
using schema::MotionEffect;
using schema::MotionWord;
using schema::WordUse;

namespace {

constexpr double seconds_per_minute = 60;

/// A keyword of #VECTOR LIMIT.
struct Limit {
  std::string_view keyword;
  double VectorLimit::*member;
  double machine::VectorLimits::*listed;
  bool is_velocity = false;
};
constexpr std::array limits{
    Limit{"VEL", &VectorLimit::velocity, &machine::VectorLimits::velocity, true},
    Limit{"ACC", &VectorLimit::acceleration, &machine::VectorLimits::acceleration},
    Limit{"DEC", &VectorLimit::deceleration, &machine::VectorLimits::deceleration},
    Limit{"RADIAL_ACC", &VectorLimit::radial_acceleration, &machine::VectorLimits::radial_acceleration}};

class MotionCommand {
 public:
  MotionCommand(MotionWord const& word, std::size_t at, NcBlock const& block, ProgramState& state)
      : reader_(at, length_of(word), block, state), state_(state) {}

  void slope() {
    if (reader_.take("DEFAULT") && reader_.at_end()) {
      auto const& channel = state_.channel.dynamics;
      set_slope(channel.slope);
      state_.modal.weighted_acceleration = channel.weighted_acceleration;
      state_.modal.weighted_ramp = channel.weighted_ramp;
      return;
    }
    std::optional<machine::Slope> type;
    if (!reader_.take("[")) return reader_.refuse(says::unknown_slope);
    while (!reader_.take("]")) {
      std::string_view const key = reader_.take();
      if ((key != "TYPE" && key != "NO_OPT") || !reader_.take("=")) {
        return reader_.refuse(says::unknown_slope);
      }
      if (key == "TYPE") {
        type = machine::slope_named(reader_.take());
        if (!type) return reader_.refuse(says::unknown_slope);
      } else if (!reader_.take_number()) {
        return;
      }
    }
    if (!reader_.at_end()) return reader_.refuse(says::unknown_slope);
    if (type) set_slope(*type);
    state_.modal.weighted_acceleration = 0;
    state_.modal.weighted_ramp = 0;
  }

  void slope_number() {
    if (!reader_.take("[")) return reader_.refuse(says::unknown_slope_number);
    auto const number = reader_.take_number();
    if (!number) return;
    bool const is_slope = *number == 0 || *number == 1 || *number == 2 || *number == 3;
    if (!is_slope || !reader_.take("]") || !reader_.at_end()) {
      return reader_.refuse(says::unknown_slope_number);
    }
    set_slope(static_cast<machine::Slope>(static_cast<int>(*number)));
  }

  void vector_limit() {
    bool const is_on = reader_.take("ON");
    if (!is_on && !reader_.take("OFF")) return reader_.refuse(says::unknown_vector_limit);
    auto limit = state_.modal.dynamics ? state_.modal.dynamics->vector : VectorLimit{};
    bool const all = reader_.take("ALL") || (!is_on && reader_.at_end());
    if (all) {
      for (Limit const& each : limits) limit.*each.member = is_on ? listed(each) : VectorLimit::none;
    } else if (!read_limits(limit, is_on)) {
      return;
    }
    if (!reader_.at_end()) return reader_.refuse(says::unknown_vector_limit);
    change_dynamics(state_.modal, state_.channel.dynamics,
                    [&](BlockDynamics& dynamics) { dynamics.vector = limit; });
  }

  void least_corner_velocity() {
    std::optional<double> velocity;
    if (reader_.take("ON")) {
      velocity = 0;
      if (!reader_.at_end()) {
        if (!reader_.take("[")) return reader_.refuse(says::unknown_corner_velocity);
        velocity = reader_.take_number();
        if (!velocity) return;
        if (!(*velocity >= 0) || !reader_.take("]")) return reader_.refuse(says::unknown_corner_velocity);
      }
    } else if (!reader_.take("OFF")) {
      return reader_.refuse(says::unknown_corner_velocity);
    }
    if (!reader_.at_end()) return reader_.refuse(says::unknown_corner_velocity);
    if (velocity) *velocity *= (state_.modal.inch ? mm_per_inch : 1) / seconds_per_minute;
    change_dynamics(state_.modal, state_.channel.dynamics,
                    [&](BlockDynamics& dynamics) { dynamics.least_corner_velocity = velocity; });
  }

  /// PATH_DEV is all that matters: how far the corners may be rounded.
  void rounding() {
    while (!reader_.at_end()) {
      if (reader_.take() != "PATH_DEV" || !reader_.take("=")) continue;
      auto const deviation = reader_.take_number();
      if (!deviation) return;
      state_.modal.path_deviation = *deviation * (state_.modal.inch ? mm_per_inch : 1);
    }
  }

 private:
  void set_slope(machine::Slope slope) {
    change_dynamics(state_.modal, state_.channel.dynamics,
                    [slope](BlockDynamics& dynamics) { dynamics.slope = slope; });
  }

  /// In mm/s and mm/s².
  [[nodiscard]] double converted(Limit const& limit, double value) const {
    if (limit.is_velocity) return value / seconds_per_minute;
    bool const per_minute = state_.channel.dynamics.vector.per_minute;
    return per_minute ? value / (seconds_per_minute * seconds_per_minute) : value;
  }
  [[nodiscard]] double listed(Limit const& limit) const {
    return converted(limit, state_.channel.dynamics.vector.*limit.listed);
  }

  /// False where something was refused.
  bool read_limits(VectorLimit& limit, bool is_on) {
    auto const refused = [this] {
      reader_.refuse(says::unknown_vector_limit);
      return false;
    };
    if (!reader_.take("[") || reader_.next() == "]") return refused();
    while (!reader_.take("]")) {
      std::string_view const word = reader_.take();
      auto const* const known = std::find_if(limits.begin(), limits.end(),
                                             [word](Limit const& each) { return each.keyword == word; });
      if (known == limits.end()) return refused();
      double value = is_on ? listed(*known) : VectorLimit::none;
      if (reader_.take("=")) {
        auto const number = reader_.take_number();
        if (!number) return false;
        if (!is_on || !(*number > 0)) return refused();
        value = converted(*known, *number);
      }
      limit.*known->member = value;
    }
    return true;
  }

  CommandReader reader_;
  ProgramState& state_;
};

}  // namespace

MotionWord const* motion_command_at(std::size_t at, NcBlock const& block) {
  constexpr std::size_t longest_name = 3;
  std::vector<std::string_view> words;
  for (std::size_t i = at; i < std::min(at + longest_name, block.tokens.size()); ++i) {
    words.push_back(block.text(block.tokens[i]));
  }
  return find_motion_word(words);
}

void take_motion_command(MotionWord const& word, std::size_t at, NcBlock const& block, ProgramState& state) {
  MotionCommand command(word, at, block, state);
  bool const rounds = word.effect == MotionEffect::round_corners && state.channel.sharp_corners;
  if (word.use == WordUse::refused && !rounds) {
    return state.problems.refuse(block, block.tokens[at], *word.refusal);
  }
  switch (word.effect) {
    case MotionEffect::slope: return command.slope();
    case MotionEffect::slope_number: return command.slope_number();
    case MotionEffect::vector_limit: return command.vector_limit();
    case MotionEffect::least_corner_velocity: return command.least_corner_velocity();
    case MotionEffect::round_corners: state.modal.rounds_corners = true; return command.rounding();
    case MotionEffect::round_no_more: state.modal.rounds_corners = false; return;
    case MotionEffect::set_rounding: return command.rounding();
    case MotionEffect::nothing:
    case MotionEffect::stop:
    case MotionEffect::stop_from_here:
    case MotionEffect::stop_no_more:
    case MotionEffect::brake_late:
    case MotionEffect::brake_in_time:
    case MotionEffect::brake_in_time_here:
    case MotionEffect::limit_by:
    case MotionEffect::limit_by_all:
    case MotionEffect::weigh:
    case MotionEffect::feed_forward:
    case MotionEffect::feed_no_more:
    case MotionEffect::round_corner: return;
  }
}

}  // namespace axisc::motion
