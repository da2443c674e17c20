// Takes a command line apart: which words are options, which their values, and which are arguments.
//
//   --output FILE, --output=FILE     a value, whatever it looks like
//   -o FILE, -oFILE, -qv             short names; those of flags may be written together
//   --fix, --fix=all                 a word that may be left out stands behind "="
//   --                               everything behind it is an argument
//   -, -5                            arguments
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::cli {

enum class OptionKind : std::uint8_t {
  flag,            ///< each time it is named gives ""
  flag_with_word,  ///< gives its word, or ""
  value,
  argument,   ///< one word that belongs to no option
  arguments,  ///< any number of them
};

struct OptionWords {
  std::string names;  ///< "-o,--output"; empty for arguments
  OptionKind kind{};
  std::vector<std::string> given;
};

/// The long name of an option, or else the short one.
[[nodiscard]] std::string_view full_name(OptionWords const& option);

/// All names of an option.
[[nodiscard]] std::vector<std::string_view> names_of(OptionWords const& option);

/// An option without the value that it needs, or with one that it does not take.
struct WrongValue {
  OptionWords const* option;
};

/// Fills in what the words give to each option. Words that nobody takes are left over, in their order. Throws WrongValue.
[[nodiscard]] std::vector<std::string> take_apart(std::span<std::string const> words,
                                                  std::span<OptionWords> options);

}  // namespace axisc::cli
