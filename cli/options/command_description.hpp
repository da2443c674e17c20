// What a command takes: its help, its manual page and the completions of shells are made of this.
#pragma once

#include "diagnostics/message.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::cli {

/// An option, or an argument without one.
struct OptionDescription {
  /// Separated by commas: "-o,--output"; empty for an argument.
  std::string names = {};
  /// Placeholder of the value, in English; "[=all]" for one that may be left out; empty for a flag.
  std::string shown = {};
  SentenceRef meaning = says::as_given;
  std::vector<std::string> values = {};  ///< where only these are allowed
  bool repeats = false;                  ///< may be given several times
  std::string only_for = {};  ///< values of --kind with which it means something: "path, plant"; empty: all
};

struct CommandDescription {
  std::string name = {};                 ///< empty for the program itself
  SentenceRef meaning = says::as_given;  ///< a few words
  std::vector<OptionDescription> options = {};
};

/// "FILE.csv" in English, "DATEI.csv" in German. A name such as P-AXIS-00140 stays whole.
[[nodiscard]] std::string placeholder_in(Language language, std::string_view shown);

/// "-o, --output FILE", "--fix[=all]", "INPUT...".
[[nodiscard]] std::string heading_of(OptionDescription const& option, Language language);

/// What an option means, with the kinds that it is for.
[[nodiscard]] std::string meaning_of(OptionDescription const& option, Language language);

/// "axisc", "axisc-lint": the name of the manual page.
[[nodiscard]] std::string page_name(CommandDescription const& command);

/// What a shell offers for a value or an argument.
enum class Offer : std::uint8_t { nothing, values, files, folders };
[[nodiscard]] Offer offer_for(OptionDescription const& option);

}  // namespace axisc::cli
