// The words of NC programs that say how a path is driven, in one table: the interpreter follows it, `axisc
// explain G60` and the editor print it, and docs/nc-programs.md is compared with it.
#pragma once

#include "diagnostics/sentence.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace axisc::schema {

enum class WordUse : std::uint8_t {
  computed,  ///< the plan takes it into account
  accepted,  ///< changes nothing that is planned
  refused,   ///< the plan would not be that of the control: AX9008
};

enum class WordReach : std::uint8_t { block, modal };

/// What the interpreter does with a word.
enum class MotionEffect : std::uint8_t {
  nothing,
  stop,            ///< at the end of this block
  stop_from_here,  ///< at the end of every block
  stop_no_more,
  brake_late,     ///< for a lower feed only behind the block
  brake_in_time,  ///< by its end
  brake_in_time_here,
  limit_by,  ///< the sum of functions of the look-ahead
  limit_by_all,
  weigh,
  round_corner,  ///< of this block
  round_corners,
  round_no_more,
  set_rounding,
  slope,
  slope_number,
  vector_limit,
  least_corner_velocity,
  feed_forward,
  feed_no_more,
};

/// What a weight changes, in percent of the values of the lists.
struct Weighting {
  enum class Of : std::uint8_t { velocity, acceleration, ramp_times, curve_ramp_time, feedforward };
  enum class In : std::uint8_t { feed, rapid, all, no_plan };
  Of of{};
  In in{};
  bool by_axis = false;  ///< of the axes whose words follow, not of all axes with the value behind `=`
};

struct MotionWord {
  std::string_view word;  ///< `G131`, `#VECTOR LIMIT`
  std::string_view form;  ///< as programs write it: `G131=percent`
  WordUse use{};
  WordReach reach = WordReach::modal;
  MotionEffect effect = MotionEffect::nothing;
  Weighting weighting = {};
  SentenceRef meaning;
  Sentence const* refusal = nullptr;  ///< of a word that is refused: with its name, and what helps
  std::string_view source = {};       ///< page of the manual, as `prog/206301707`
};

[[nodiscard]] std::span<MotionWord const> motion_words();

/// By the number of a G word; null for others. Cost: one table access.
[[nodiscard]] MotionWord const* find_motion_word(int number);
/// By the words that a command begins with, `#CONTOUR` `MODE` `ON`: the longest that fits; null for others.
[[nodiscard]] MotionWord const* find_motion_word(std::span<std::string_view const> words);
/// As people write it: `g60`, `G9`, `G131=50`, `#slope [TYPE=STEP]`; null for others.
[[nodiscard]] MotionWord const* find_motion_word(std::string_view text);

/// Number of words that make the name of a command: 2 for `#VECTOR LIMIT`.
[[nodiscard]] std::size_t length_of(MotionWord const& word);

/// The address of the page that a row names.
[[nodiscard]] std::string address_of(std::string_view source);

}  // namespace axisc::schema
