#include "axisc/answers/explain/explain_index.hpp"

#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/answers/explain/explain_parts.hpp"
#include "axisc/answers/labels.hpp"
#include "axisc/asked/quantities.hpp"
#include "diagnostics/finding.hpp"
#include "diagnostics/joined.hpp"
#include "validator/engine/rule_facts.hpp"
#include "validator/engine/rule_title.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace axisc::says {

constexpr Sentence by_symptom{"By symptom", "Nach Symptom"};
constexpr Sentence by_parameter{"By parameter", "Nach Parameter"};
constexpr Sentence by_message{"By message of the control", "Nach Meldung der Steuerung"};
constexpr Sentence by_code{"By code", "Nach Code"};
constexpr Sentence of_every{"Every parameter of a kind: {codes}. Others:",
                            "Jeder Parameter einer Art: {codes}. Weitere:"};
constexpr Sentence code{"code", "Code"};
constexpr Sentence title{"title", "Titel"};
constexpr Sentence severity{"severity", "Schweregrad"};
constexpr Sentence message{"message", "Meldung"};

constexpr Sentence unread{"The control ignores a line of a list, or reads it otherwise than meant",
                          "Die Steuerung übergeht eine Zeile oder liest sie anders als gemeint"};
constexpr Sentence other_value{"Another value is in force than the list seems to say",
                               "Es gilt ein anderer Wert, als die Liste zu sagen scheint"};
constexpr Sentence no_effect{"A filter, parameter or command has no effect",
                             "Ein Filter, Parameter oder Befehl wirkt nicht"};
constexpr Sentence switched_off{"The control switches a filter off, or cannot compute it",
                                "Die Steuerung schaltet einen Filter ab oder kann ihn nicht berechnen"};
constexpr Sentence contour{"Contours are distorted, axes are out of step",
                           "Konturen sind verformt, Achsen laufen nicht synchron"};
constexpr Sentence vibration{"An axis vibrates or overshoots", "Eine Achse schwingt oder schwingt über"};
constexpr Sentence late{"An axis follows late, or settles slowly",
                        "Eine Achse folgt spät oder schwingt langsam ein"};
constexpr Sentence position{"An axis stops in another position than programmed",
                            "Eine Achse hält an einer anderen Position als programmiert"};
constexpr Sentence slow_path{"A path is slower or jerkier than expected",
                             "Eine Bahn ist langsamer oder ruckartiger als erwartet"};
constexpr Sentence gantry{"A gantry skews or reports errors", "Ein Gantry steht schief oder meldet Fehler"};
constexpr Sentence position_control{"Improved Position Control does nothing, or makes vibration worse",
                                    "Die optimierte Lageregelung bewirkt nichts oder verstärkt Schwingungen"};
constexpr Sentence program_aborts{"A program is aborted, or the motion stops",
                                  "Ein Programm wird abgebrochen, oder die Bewegung hält an"};
constexpr Sentence start_up{"Start-up is aborted; a list, an axis or a spindle is missing",
                            "Der Hochlauf bricht ab; eine Liste, Achse oder Spindel fehlt"};
constexpr Sentence figures{
    "axisc refuses a file, or its results are for another machine",
    "axisc weist eine Datei ab, oder seine Ergebnisse gelten für eine andere Maschine"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

struct Symptom {
  std::string_view word;
  SentenceRef text;
};

/// In the order of the index.
constexpr std::array symptoms{Symptom{"no-effect", says::no_effect},
                              Symptom{"switched-off", says::switched_off},
                              Symptom{"contour", says::contour},
                              Symptom{"vibration", says::vibration},
                              Symptom{"late", says::late},
                              Symptom{"position", says::position},
                              Symptom{"slow-path", says::slow_path},
                              Symptom{"gantry", says::gantry},
                              Symptom{"position-control", says::position_control},
                              Symptom{"program-aborts", says::program_aborts},
                              Symptom{"start-up", says::start_up},
                              Symptom{"unread", says::unread},
                              Symptom{"other-value", says::other_value},
                              Symptom{"figures", says::figures}};

Field code_of(validator::Rule const& rule) {
  auto code = code_text(rule.code);
  return shown(says::code, Link{.text = code, .id = code});
}

Field title_of(validator::Rule const& rule) {
  return shown(says::title, Wording(validator::title(rule)));
}

Table for_people() {
  return {.key = {}, .audience = Audience::people};
}

bool has(validator::Rule const& rule, std::string_view symptom) {
  auto const words = validator::facts(rule).symptoms;
  return std::find(words.begin(), words.end(), symptom) != words.end();
}

Section by_symptom() {
  Section all = part(says::by_symptom, {}, Audience::people);
  for (auto const& [word, text] : symptoms) {
    auto table = for_people();
    for (auto const& rule : validator::rules()) {
      if (has(rule, word)) add_row(table, {code_of(rule), title_of(rule)});
    }
    all.blocks.emplace_back(part(text, {std::move(table)}, Audience::people));
  }
  return all;
}

/// A parameter or a number is in the first of its rows alone, as in the index of a book.
Section by_parameter(schema::Catalogue const& of_axes) {
  std::vector<std::string> general;
  for (auto const& rule : validator::rules()) {
    if (rule.about != nullptr) general.push_back(code_text(rule.code));
  }
  auto table = for_people();
  for (auto const& parameter : of_axes.parameters()) {
    bool is_first = true;
    for (auto const& rule : validator::rules()) {
      if (rule.about != nullptr || !validator::looks_at(rule, parameter)) continue;
      auto const once = [&](std::string text) { return is_first ? Value(std::move(text)) : Value(); };
      add_row(table, {shown(labels::parameter, once(std::string(parameter.name))),
                      shown(labels::number, once(schema::number_text(parameter.kind, parameter.p_axis))),
                      code_of(rule), title_of(rule)});
      is_first = false;
    }
  }
  return part(says::by_parameter,
              {Paragraph{Words(says::of_every, {{"codes", joined(general, ", ")}})}, std::move(table)},
              Audience::people);
}

Section by_message() {
  std::map<std::uint64_t, std::vector<validator::Rule const*>> rules_of;
  for (auto const& rule : validator::rules()) {
    for (auto const& text : split_list(rule.control, '/')) {
      if (auto const number = parse_count(text)) rules_of[*number].push_back(&rule);
    }
  }
  auto table = for_people();
  for (auto const& [number, rules] : rules_of) {
    for (auto const* const rule : rules) {
      auto const first = rule == rules.front() ? Value(std::to_string(number)) : Value();
      add_row(table, {shown(says::message, first), code_of(*rule), title_of(*rule)});
    }
  }
  return part(says::by_message, {std::move(table)}, Audience::people);
}

Section by_code() {
  auto table = for_people();
  for (auto const& rule : validator::rules()) {
    add_row(table, {code_of(rule), shown(labels::name, rule.name),
                    shown(says::severity, severity_symbol(rule.severity)), title_of(rule),
                    shown(says::since, version_of(rule))});
  }
  return part(says::by_code, {std::move(table)}, Audience::people);
}

}  // namespace

std::vector<Block> rule_index(schema::Catalogue const& of_axes) {
  return {by_symptom(), by_parameter(of_axes), by_message(), by_code()};
}

std::optional<Words> symptom_text(std::string_view symptom) {
  for (auto const& [word, text] : symptoms) {
    if (word == symptom) return Words(text);
  }
  return std::nullopt;
}

}  // namespace axisc
