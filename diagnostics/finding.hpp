// A finding is data: what is wrong, where, what the control would do, and what to write instead.
#pragma once

#include "diagnostics/message.hpp"
#include "diagnostics/source_text.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

enum class Severity : std::uint8_t { error, warning, note };

/// The number of a code: 3005 is AX3005. Codes never change meaning.
enum class Code : std::uint16_t {};

/// "AX3005".
[[nodiscard]] std::string code_text(Code code);

/// A further place that belongs to a finding.
struct Related {
  Place place;
  Message message;
};

/// Replaces the bytes of `place` by `text` (UTF-8; written in the encoding of the source).
struct Edit {
  Place place;
  std::string text;
};

/// Safe fixes never change what the machine does.
enum class FixSafety : std::uint8_t { safe, changes_behaviour };

struct Fix {
  Message title;
  std::vector<Edit> edits;
  FixSafety safety = FixSafety::changes_behaviour;
};

/// The control's reaction to the same input.
struct ControlReaction {
  std::string message;  ///< its message numbers, "50663" or "50663/60311"; empty where it has none
  std::optional<Message> reaction;  ///< in words
  std::string value;                ///< the value it would run with; empty where none is known
  Wording physical = {};            ///< that value in a unit for people; empty where this adds nothing
};

struct Finding {
  Code code{};
  std::string_view name;  ///< "delay-too-long"; points into the rule table
  Severity severity = Severity::error;
  std::optional<Place> place;  ///< none for findings about a file as a whole
  std::string file;            ///< shown instead of a place where there is none
  Message message;
  std::optional<Message> label;  ///< next to the caret
  std::vector<Message> notes;
  std::vector<Message> help;
  std::vector<Related> related;
  std::optional<Fix> fix;
  std::optional<ControlReaction> control;
  std::string axis;              ///< name of the axis, where one is concerned
  std::string parameter;         ///< path as the list writes it, `filter[0].order`
  std::string p_axis;            ///< "P-AXIS-00140"
  std::uint32_t occurrence = 1;  ///< among the findings of one identity, see fingerprint.hpp
};

struct FindingCounts {
  std::size_t errors = 0;
  std::size_t warnings = 0;
  std::size_t notes = 0;

  void add(Severity severity);
  [[nodiscard]] std::size_t total() const { return errors + warnings + notes; }
};

[[nodiscard]] FindingCounts count(std::vector<Finding> const& findings);

/// The number of findings of a code.
struct CodeCount {
  Code code{};
  std::string_view name;
  std::size_t count = 0;
  std::size_t fixable = 0;  ///< of them with a fix
};

/// By number of findings, then by code.
void most_frequent_first(std::vector<CodeCount>& counts);

}  // namespace axisc
