#include "editor/meaning/dynamics_notes.hpp"

#include "diagnostics/format_number.hpp"
#include "diagnostics/message.hpp"
#include "editor/reading/requests.hpp"
#include "validator/views/axis_dynamics.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>
#include <array>

namespace axisc::editor::says {

constexpr Sentence capped{"{value} counts ({cap})", "es gilt {value} ({cap})"};
constexpr Sentence as_up{"as for accelerating: {value}", "wie beim Beschleunigen: {value}"};
constexpr Sentence both{"{value}, {jerk}", "{value}, {jerk}"};
constexpr Sentence sentence_of_cap{"{cap} limits it: {value} counts.",
                                   "{cap} begrenzt den Wert: Es gilt {value}."};
constexpr Sentence sentence_as_up{"0 means as for accelerating: {value}.",
                                  "0 heißt wie beim Beschleunigen: {value}."};
constexpr Sentence sentence_of_jerk{"The jerk a/tr of this ramp is {jerk}.",
                                    "Der Ruck a/tr dieser Rampe ist {jerk}."};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

using machine::AxisDynamics;

/// A parameter of gear 0 with the value that counts, what caps it, and the acceleration that a ramp time
/// belongs to.
struct DrivenParameter {
  std::string_view pattern;
  double (*counts)(AxisDynamics const&);
  std::string_view cap;
  double (*acceleration)(AxisDynamics const&) = nullptr;
};

constexpr std::string_view of_a_max = "P-AXIS-00008";
constexpr std::string_view of_tr_min = "P-AXIS-00201";
constexpr std::string_view of_vb_max = "P-AXIS-00212";

double up(AxisDynamics const& axis) {
  return axis.feed.up.acceleration;
}
double down(AxisDynamics const& axis) {
  return axis.feed.down.acceleration;
}
double rapid(AxisDynamics const& axis) {
  return axis.rapid.up.acceleration;
}
double weaker(AxisDynamics const& axis) {
  return std::min(up(axis), down(axis));
}

constexpr std::array parameters = {
    DrivenParameter{"getriebe[].vb_eilgang", [](AxisDynamics const& d) { return d.rapid.velocity; },
                    of_vb_max},
    DrivenParameter{"getriebe[].lslope_profil.a_stufe_1",
                    [](AxisDynamics const& d) { return d.feed.step_up.first; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.a_stufe_2",
                    [](AxisDynamics const& d) { return d.feed.step_up.second; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.d_stufe_1",
                    [](AxisDynamics const& d) { return d.feed.step_down.first; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.d_stufe_2",
                    [](AxisDynamics const& d) { return d.feed.step_down.second; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.a_grenz_stufe_1",
                    [](AxisDynamics const& d) { return d.rapid.step_up.first; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.a_grenz_stufe_2",
                    [](AxisDynamics const& d) { return d.rapid.step_up.second; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.d_grenz_stufe_1",
                    [](AxisDynamics const& d) { return d.rapid.step_down.first; }, of_a_max},
    DrivenParameter{"getriebe[].lslope_profil.d_grenz_stufe_2",
                    [](AxisDynamics const& d) { return d.rapid.step_down.second; }, of_a_max},
    DrivenParameter{"getriebe[].slope_profil.a_beschl", up, of_a_max},
    DrivenParameter{"getriebe[].slope_profil.a_brems", down, of_a_max},
    DrivenParameter{"getriebe[].slope_profil.a_grenz", rapid, of_a_max},
    DrivenParameter{"getriebe[].slope_profil.tr_beschl_zu",
                    [](AxisDynamics const& d) { return d.feed.up.build_up; }, of_tr_min, up},
    DrivenParameter{"getriebe[].slope_profil.tr_beschl_ab",
                    [](AxisDynamics const& d) { return d.feed.up.take_back; }, of_tr_min, up},
    DrivenParameter{"getriebe[].slope_profil.tr_brems_zu",
                    [](AxisDynamics const& d) { return d.feed.down.build_up; }, of_tr_min, down},
    DrivenParameter{"getriebe[].slope_profil.tr_brems_ab",
                    [](AxisDynamics const& d) { return d.feed.down.take_back; }, of_tr_min, down},
    DrivenParameter{"getriebe[].slope_profil.tr_grenz",
                    [](AxisDynamics const& d) { return d.rapid.up.build_up; }, of_tr_min, rapid},
    DrivenParameter{"getriebe[].dynamik.tr_geom", [](AxisDynamics const& d) { return d.curve_ramp_time; },
                    of_tr_min, weaker},
    DrivenParameter{"getriebe[].dynamik.tr_w_min",
                    [](AxisDynamics const& d) { return d.shortest_weighted_ramp_time; }, of_tr_min},
    DrivenParameter{"getriebe[].dynamik.a_w_max",
                    [](AxisDynamics const& d) { return d.weighted_acceleration.value_or(0); }, of_a_max}};

/// "40 m/s³" of mm/s² and µs.
std::string jerk_text(double acceleration, double time, machine::AxisType type, Language language) {
  constexpr double seconds_per_us = 1e-6;
  constexpr double mm_per_m = 1000;
  constexpr int digits = 4;
  double const jerk = acceleration / (time * seconds_per_us);
  bool const is_translatory = type == machine::AxisType::translatory;
  return format_rounded(is_translatory ? jerk / mm_per_m : jerk, digits).in(language) +
         (is_translatory ? " m/s³" : " °/s³");
}

}  // namespace

std::optional<DynamicsNotes::Note> DynamicsNotes::note_of(grammar::Assignment const& line,
                                                          schema::NameLookup const& found) {
  if (found.row == nullptr || list_.axis() == nullptr || found.status != schema::NameLookup::Status::found) {
    return std::nullopt;
  }
  auto const* const known = std::find_if(
      parameters.begin(), parameters.end(),
      [&found](DrivenParameter const& parameter) { return found.row->name == parameter.pattern; });
  if (known == parameters.end()) return std::nullopt;
  auto const& values = list_.axis()->merged.values;
  auto const& value = values[found.slot];
  bool const is_gear_0 = &value == &values.at(known->pattern);
  bool const is_this_line =
      value.set() && value.line == line.line && list_.sources()[value.source].name() == list_.text().name();
  if (!is_gear_0 || !is_this_line || !value.has_value || value.unusable) return std::nullopt;
  if (!dynamics_) dynamics_ = validator::axis_dynamics(values);
  double const written = value.value.number;
  double const counts = known->counts(*dynamics_);
  Note note;
  if (counts != written && counts > 0) {
    note.counts = validator::physical(counts, list_.unit_of(*found.row)).in(language_);
    if (written != 0) note.cap = known->cap;
  }
  if (known->acceleration != nullptr && counts > 0) {
    note.jerk = jerk_text(known->acceleration(*dynamics_), counts, list_.axis()->type, language_);
  }
  return note;
}

std::string DynamicsNotes::of(grammar::Assignment const& line, schema::NameLookup const& found) {
  auto const note = note_of(line, found);
  if (!note) return {};
  if (note->counts.empty()) return note->jerk;
  auto const value = note->cap.empty()
                         ? say(says::as_up, language_, {{"value", note->counts}})
                         : say(says::capped, language_, {{"value", note->counts}, {"cap", note->cap}});
  if (note->jerk.empty()) return value;
  return say(says::both, language_, {{"value", value}, {"jerk", note->jerk}});
}

std::string DynamicsNotes::sentence_of(grammar::Assignment const& line, schema::NameLookup const& found) {
  auto const note = note_of(line, found);
  if (!note) return {};
  std::string text;
  if (!note->counts.empty()) {
    text += "\n" +
            (note->cap.empty()
                 ? say(says::sentence_as_up, language_, {{"value", note->counts}})
                 : say(says::sentence_of_cap, language_, {{"value", note->counts}, {"cap", note->cap}})) +
            "\n";
  }
  if (!note->jerk.empty())
    text += "\n" + say(says::sentence_of_jerk, language_, {{"jerk", note->jerk}}) + "\n";
  return text;
}

}  // namespace axisc::editor
