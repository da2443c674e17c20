#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/motion_blocks.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>
#include <array>

namespace axisc::validator::checks::ax8007::says {

constexpr Sentence headline{"`{parameter}` must be at least `{acceleration}`",
                            "`{parameter}` muss mindestens `{acceleration}` sein"};
constexpr Sentence label{"{value}, but feed blocks accelerate with {acceleration}",
                         "{value}, aber Vorschubsätze beschleunigen mit {acceleration}"};
constexpr Sentence related{"the acceleration is set here", "hier wird die Beschleunigung gesetzt"};
constexpr Sentence acceleration_default{
    "no list sets `{acceleration}`: its default {value} applies",
    "keine Liste setzt `{acceleration}`: es gilt der Standardwert {value}"};
constexpr Sentence undocumented{
    "what the control does in that case is not documented; axisc plans with the feed acceleration, and "
    "weights above 100 % have no effect",
    "was die Steuerung dann tut, ist nicht dokumentiert; axisc plant mit der Vorschubbeschleunigung, und ein "
    "Gewicht über 100 % bewirkt nichts"};
constexpr Sentence help{"raise it to at least {value}, or leave it out: then P-AXIS-00008 counts",
                        "auf mindestens {value} erhöhen, oder weglassen: dann gilt P-AXIS-00008"};

}  // namespace axisc::validator::checks::ax8007::says

namespace axisc::validator::checks::ax8007 {
namespace {

constexpr std::array of_step = {std::string_view("getriebe[].lslope_profil.a_stufe_1"),
                                std::string_view("getriebe[].lslope_profil.a_stufe_2")};
constexpr std::array of_others = {std::string_view("getriebe[].slope_profil.a_beschl"),
                                  std::string_view("getriebe[].slope_profil.a_brems")};

/// The larger of both; null if one of them cannot be used.
EffectiveValue const* largest_of(EffectiveValues const& values, std::span<std::string_view const> names) {
  auto const& first = values.at(names[0]);
  auto const& second = values.at(names[1]);
  if (first.unusable || second.unusable) return nullptr;
  return second.value.number > first.value.number ? &second : &first;
}

/// The acceleration that the cap has to reach: that of the slope, or where that is not known the smaller one.
EffectiveValue const* needed(GroupContext const& context, EffectiveValues const& values) {
  auto const* const step = largest_of(values, of_step);
  auto const* const other = largest_of(values, of_others);
  if (step == nullptr || other == nullptr) return nullptr;
  auto const& dynamics = context.group.dynamics;
  if (dynamics.is_from_list && !programs_choose_slope(context)) {
    return dynamics.slope == machine::Slope::step ? step : other;
  }
  return step->value.number < other->value.number ? step : other;
}

void weight_cap_too_low(GroupContext const& context, Report& report) {
  for (std::size_t const index : context.group.axes) {
    LoadedAxis const& axis = context.whole.machine.axes[index];
    auto const& values = axis.merged.values;
    EffectiveValue const& cap = values.at("getriebe[].dynamik.a_w_max");
    auto const* const acceleration = needed(context, values);
    bool const is_set = cap.value_place() && !cap.unusable && cap.value.number > 0;
    if (!is_set || acceleration == nullptr || cap.value.number >= acceleration->value.number) continue;
    auto const physical_of = [&axis](EffectiveValue const& value) {
      return physical(value.value.number, unit_of(*value.row, axis.type));
    };
    std::string const name = parameter_name(*acceleration);
    report.axis = axis.name;
    Finding& finding = report.add(
        cap, message(says::headline, {{"parameter", parameter_name(cap)}, {"acceleration", name}}));
    finding.label =
        message(says::label, {{"value", physical_of(cap)}, {"acceleration", physical_of(*acceleration)}});
    if (acceleration->value_place()) {
      finding.related.push_back({.place = *acceleration->value_place(), .message = message(says::related)});
    } else {
      finding.notes.push_back(message(says::acceleration_default,
                                      {{"acceleration", name}, {"value", physical_of(*acceleration)}}));
    }
    finding.notes.push_back(message(says::undocumented));
    finding.help.push_back(message(says::help, {{"value", physical_of(*acceleration)}}));
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters =
        "getriebe[].dynamik.a_w_max getriebe[].dynamik.a_max getriebe[].slope_profil.a_beschl "
        "getriebe[].slope_profil.a_brems "
        "getriebe[].lslope_profil.a_stufe_1 getriebe[].lslope_profil.a_stufe_2",
    .check = weight_cap_too_low,
};

}  // namespace axisc::validator::checks::ax8007
