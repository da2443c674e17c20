#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/rules/motion_blocks.hpp"
#include "validator/views/axis_dynamics.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace axisc::validator::checks::ax8001::says {

constexpr Sentence headline{"`{word}`: axis \"{axis}\" gets {counts} in `{parameter}`, not {asked}",
                            "`{word}`: Achse „{axis}“ erhält {counts} in `{parameter}`, nicht {asked}"};
constexpr Sentence most{
    "a weight gives at most P-AXIS-00292, or P-AXIS-00008 where that is not set",
    "ein Gewicht gibt höchstens P-AXIS-00292 oder, wo es nicht gesetzt ist, P-AXIS-00008"};
constexpr Sentence most_of_rapid{"a weight gives at most P-AXIS-00008",
                                 "ein Gewicht gibt höchstens P-AXIS-00008"};
constexpr Sentence least{"a weight gives at least P-AXIS-00293, and never less than P-AXIS-00201",
                         "ein Gewicht gibt mindestens P-AXIS-00293 und nie weniger als P-AXIS-00201"};
constexpr Sentence value_here{"100 % are this value", "100 % sind dieser Wert"};
constexpr Sentence reaction{"it limits the weighted value", "sie begrenzt den gewichteten Wert"};
constexpr Sentence help_most{"axis {axis} allows at most {percent} %",
                             "die Achse {axis} lässt höchstens {percent} % zu"};
constexpr Sentence help_least{"axis {axis} needs at least {percent} %",
                              "die Achse {axis} braucht mindestens {percent} %"};

}  // namespace axisc::validator::checks::ax8001::says

namespace axisc::validator::checks::ax8001 {
namespace {

using Of = schema::Weighting::Of;
using In = schema::Weighting::In;

/// A value that a weight changes, with the control's messages where it is limited.
struct Weighed {
  std::string_view parameter;
  std::string_view control;
  std::uint8_t part = 0;               ///< the number in P-CHAN-00001, or 00073, that means this value alone
  std::string_view instead_of_0 = {};  ///< the parameter that counts where this one is 0
};

constexpr std::string_view first_stage = "getriebe[].lslope_profil.a_stufe_1";
constexpr std::string_view second_stage = "getriebe[].lslope_profil.a_stufe_2";
constexpr std::array step_accelerations{
    Weighed{first_stage, "50130", 1}, Weighed{second_stage, "50130/120029", 1},
    Weighed{"getriebe[].lslope_profil.d_stufe_1", "50130", 2, first_stage},
    Weighed{"getriebe[].lslope_profil.d_stufe_2", "50130", 2, second_stage}};
constexpr std::array accelerations{Weighed{"getriebe[].slope_profil.a_beschl", "50130/120031", 1},
                                   Weighed{"getriebe[].slope_profil.a_brems", "50130/120033", 2}};
constexpr std::string_view rapid_acceleration = "50130/120627";
constexpr std::array rapid_step_accelerations{
    Weighed{"getriebe[].lslope_profil.a_grenz_stufe_1", rapid_acceleration},
    Weighed{"getriebe[].lslope_profil.a_grenz_stufe_2", rapid_acceleration}};
constexpr std::array rapid_accelerations{Weighed{"getriebe[].slope_profil.a_grenz", rapid_acceleration}};
constexpr std::array ramps{Weighed{"getriebe[].slope_profil.tr_beschl_zu", "50130/120035", 1},
                           Weighed{"getriebe[].slope_profil.tr_beschl_ab", "50130/120036", 2},
                           Weighed{"getriebe[].slope_profil.tr_brems_zu", "50130/120037", 3},
                           Weighed{"getriebe[].slope_profil.tr_brems_ab", "50130/120038", 4}};
constexpr std::array rapid_ramps{Weighed{"getriebe[].slope_profil.tr_grenz", "50130/120629"}};

std::span<Weighed const> weighed_by(schema::Weighting const& weighting, machine::Slope slope) {
  bool const is_step = slope == machine::Slope::step;
  bool const is_rapid = weighting.in == In::rapid;
  if (weighting.in == In::no_plan) return {};
  if (weighting.of == Of::acceleration) {
    if (is_step) return is_rapid ? std::span<Weighed const>(rapid_step_accelerations) : step_accelerations;
    return is_rapid ? std::span<Weighed const>(rapid_accelerations) : accelerations;
  }
  // Without effect with STEP.
  if (weighting.of != Of::ramp_times || is_step) return {};
  return is_rapid ? std::span<Weighed const>(rapid_ramps) : ramps;
}

class WeightCheck {
 public:
  WeightCheck(ProgramContext const& context, Report& report) : context_(context), report_(report) {}

  void run() {
    auto const& channel = context_.group->dynamics;
    machine::Slope slope = channel.slope;
    take_parts_of_channel();
    for (grammar::WantedBlock const& wanted : context_.program.tree.blocks) {
      MotionBlock const block(wanted, context_.text);
      slope = block.slope(channel.slope).value_or(slope);
      if (block.weighs_all()) weighed_acceleration_ = weighed_ramp_ = 0;
      if (block.takes_default_slope()) take_parts_of_channel();
      for (BlockFunction const& function : block.functions()) {
        if (function.word == nullptr || function.word->effect != schema::MotionEffect::weigh) continue;
        auto const weighed = weighed_by(function.word->weighting, slope);
        if (function.word->weighting.by_axis) {
          for (BlockAxisWord const& word : block.axis_words_behind(function.index)) {
            if (word.value) check(function, word.span, *word.value, weighed, word.axis);
          }
        } else if (function.value) {
          check(function, function.value_span, *function.value, weighed, {});
        }
      }
    }
  }

 private:
  void take_parts_of_channel() {
    weighed_acceleration_ = context_.group->dynamics.weighted_acceleration;
    weighed_ramp_ = context_.group->dynamics.weighted_ramp;
  }

  /// What G130 to G133 weigh of several values: all, or the one that P-CHAN-00001 or 00073 names.
  [[nodiscard]] bool is_weighed(BlockFunction const& function, Weighed const& weighed) const {
    bool const is_time = function.word->weighting.of == Of::ramp_times;
    std::uint8_t const part = is_time ? weighed_ramp_ : weighed_acceleration_;
    return part == 0 || weighed.part == 0 || weighed.part == part;
  }

  [[nodiscard]] static EffectiveValue const& value_of(LoadedAxis const& axis, Weighed const& weighed) {
    EffectiveValue const& value = axis.merged.values.at(weighed.parameter);
    bool const is_other = !weighed.instead_of_0.empty() && !value.unusable && value.value.number == 0;
    return is_other ? axis.merged.values.at(weighed.instead_of_0) : value;
  }

  /// Of one axis, or of all without a name: the first that is limited. Each weight is reported once.
  void check(BlockFunction const& function, Span span, double percent, std::span<Weighed const> weighed,
             std::string_view name) {
    for (std::size_t const index : context_.group->axes) {
      LoadedAxis const& axis = context_.whole.machine.axes[index];
      if (!name.empty() && axis.name != name) continue;
      for (Weighed const& each : weighed) {
        if (!is_weighed(function, each) || !is_limited(axis, function, each, percent)) continue;
        bool const is_new = reported_.insert({function.number, std::string(name), percent}).second;
        if (is_new) report(axis, function, span, each, percent);
        return;
      }
    }
  }

  [[nodiscard]] static double limit_of(LoadedAxis const& axis, BlockFunction const& function) {
    auto const dynamics = axis_dynamics(axis.merged.values);
    auto const& weighting = function.word->weighting;
    if (weighting.of == Of::ramp_times) {
      return weighting.in == In::rapid ? dynamics.shortest_ramp_time : dynamics.shortest_weighted_ramp_time;
    }
    if (weighting.in == In::rapid) return dynamics.highest_acceleration;
    return dynamics.weighted_acceleration.value_or(dynamics.highest_acceleration);
  }

  [[nodiscard]] static bool is_limited(LoadedAxis const& axis, BlockFunction const& function,
                                       Weighed const& weighed, double percent) {
    EffectiveValue const& value = value_of(axis, weighed);
    if (value.unusable) return false;
    double const asked = value.value.number * percent / 100;
    bool const is_time = function.word->weighting.of == Of::ramp_times;
    // What the list itself has beyond the limit is a finding about the list.
    if (is_time) return percent < 100 && asked < limit_of(axis, function);
    return percent > 100 && asked > limit_of(axis, function);
  }

  void report(LoadedAxis const& axis, BlockFunction const& function, Span span, Weighed const& weighed,
              double percent) {
    EffectiveValue const& value = value_of(axis, weighed);
    std::string_view const unit = unit_of(*value.row, axis.type);
    report_.axis = axis.name;
    Finding& finding =
        report_.add(Place{.source = context_.program.source, .span = span},
                    message(says::headline, {{"word", std::string(function.word->word)},
                                             {"axis", axis.name},
                                             {"parameter", parameter_name(value)},
                                             {"counts", physical(limit_of(axis, function), unit)},
                                             {"asked", physical(value.value.number * percent / 100, unit)}}));
    bool const is_time = function.word->weighting.of == Of::ramp_times;
    bool const is_rapid = function.word->weighting.in == In::rapid;
    finding.notes.push_back(message(is_time ? says::least : is_rapid ? says::most_of_rapid : says::most));
    // Without a value of its own no share of it is enough.
    if (value.value.number > 0) {
      double const share = 100 * limit_of(axis, function) / value.value.number;
      double const percent_kept = is_time ? std::min(std::ceil(share), 100.0) : std::floor(share);
      finding.help.push_back(message(is_time ? says::help_least : says::help_most,
                                     {{"axis", axis.name}, {"percent", number(percent_kept)}}));
    }
    if (value.value_place()) {
      finding.related.push_back({.place = *value.value_place(), .message = message(says::value_here)});
    }
    react(finding, weighed.control, message(says::reaction));
  }

  ProgramContext const& context_;
  Report& report_;
  std::uint8_t weighed_acceleration_ = 0, weighed_ramp_ = 0;  ///< as P-CHAN-00001 and 00073 have them
  std::set<std::tuple<int, std::string, double>> reported_;
};

void weight_limited(ProgramContext const& context, Report& report) {
  if (context.group != nullptr) WeightCheck(context, report).run();
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .control = "50130/120029/120031/120033/120035/120036/120037/120038/120627/120629",
    .parameters =
        "getriebe[].dynamik.a_w_max getriebe[].dynamik.a_max getriebe[].dynamik.tr_w_min "
        "getriebe[].dynamik.tr_min getriebe[].slope_profil.* getriebe[].lslope_profil.*",
    .check = weight_limited,
};

}  // namespace axisc::validator::checks::ax8001
