#include "editor/meaning/dynamics_notes.hpp"

#include "diagnostics/format_number.hpp"
#include "diagnostics/message.hpp"
#include "editor/reading/requests.hpp"
#include "validator/views/axis_dynamics.hpp"
#include "validator/views/driven_value.hpp"
#include "validator/views/units_text.hpp"

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

/// "40 m/s³" of mm/s³, "40 °/s³".
std::string jerk_text(double jerk, machine::AxisType type, Language language) {
  constexpr double mm_per_m = 1000;
  constexpr int digits = 4;
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
  auto const& values = list_.axis()->merged.values;
  auto const& value = values[found.slot];
  bool const is_gear_0 = &value == &values.at(found.row->name);
  bool const is_this_line =
      value.set() && value.line == line.line && list_.sources()[value.source].name() == list_.text().name();
  if (!is_gear_0 || !is_this_line || !value.has_value || value.unusable) return std::nullopt;
  if (!dynamics_) dynamics_ = validator::axis_dynamics(values);
  auto const driven = validator::driven_value(*dynamics_, found.row->name);
  if (!driven) return std::nullopt;
  double const written = value.value.number;
  Note note;
  if (driven->counts != written && driven->counts > 0) {
    note.counts = validator::physical(driven->counts, list_.unit_of(*found.row)).in(language_);
    if (written != 0) note.cap = driven->cap;
  }
  if (driven->jerk) note.jerk = jerk_text(*driven->jerk, list_.axis()->type, language_);
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
  if (!note->jerk.empty()) {
    text += "\n" + say(says::sentence_of_jerk, language_, {{"jerk", note->jerk}}) + "\n";
  }
  return text;
}

}  // namespace axisc::editor
