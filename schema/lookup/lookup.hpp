// What people look for when they do not know a name: messages of the control, topics, and the words that
// people use for parameters, rules and words of NC programs. The texts are in control-messages.json and
// lookup.json; the generator turns them into constant tables at build time.
#pragma once

#include "diagnostics/page.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace axisc::schema {

/// Messages that say the same, each from another part of the control.
struct ControlMessage {
  std::span<std::uint32_t const> numbers;
  Page meaning;
  Page reaction;                                 ///< of the control; empty: not documented
  Page remedy;                                   ///< empty: none is known
  std::span<std::string_view const> parameters;  ///< of axis lists, as the catalogue writes them
};

[[nodiscard]] std::span<ControlMessage const> control_messages();
/// Null for a number that no row has.
[[nodiscard]] ControlMessage const* find_control_message(std::uint32_t number);

/// The part of the control that numbers its messages like this, in words; none where it is not documented.
[[nodiscard]] std::optional<SentenceRef> reporter_of(std::uint32_t number);

/// A page that belongs to no single parameter or rule: a type of filter, a command, a question.
struct Topic {
  std::string_view name;  ///< `BANDSTOP`, `#FILTER`, "vibration"
  Page title;
  Page page;                                ///< Markdown
  std::span<std::string_view const> see;    ///< names that explain_answer() knows
  std::span<std::string_view const> words;  ///< that people use for it, of both languages
};

[[nodiscard]] std::span<Topic const> topics();
/// By name, letter case aside; null for others.
[[nodiscard]] Topic const* find_topic(std::string_view name);

/// Words that people use for a parameter, a rule or a word of NC programs.
struct Synonyms {
  std::string_view of;                      ///< `getriebe[].lose`, `P-CHAN-00071`, `AX3002`, `G60`
  std::span<std::string_view const> words;  ///< of both languages
};

[[nodiscard]] std::span<Synonyms const> synonyms();

/// Words of one meaning, in both languages and in whatever form: "velocity", "speed", "Geschwindigkeit".
using WordGroup = std::span<std::string_view const>;

/// What the search knows of words beside the subjects.
struct SearchWords {
  WordGroup fillers;                   ///< that say nothing about a subject: "the", "wie", "Achse"
  WordGroup units;                     ///< after a number, which says nothing either: "48 Hz"
  WordGroup prepositions;              ///< before what is beside the point: "beim Bremsen", "in a corner"
  WordGroup for_messages;              ///< by which people ask for a message of the control: "Fehler"
  std::span<WordGroup const> faults;   ///< that tell what is wrong: "missing", "unknown"
  std::span<WordGroup const> degrees;  ///< that do so in some texts: "too high", but not "high-pass"
  std::span<WordGroup const> actions;  ///< what is to be done: "switch on", "reduce"; less than to what
  std::span<WordGroup const> same;     ///< all others
};

[[nodiscard]] SearchWords const& search_words();

}  // namespace axisc::schema
