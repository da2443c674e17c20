// Reads an NC program piece by piece, whatever its length.
#pragma once

#include "diagnostics/source_text.hpp"
#include "grammar/nc_program.hpp"
#include "configuration/files.hpp"

#include <cstdint>
#include <string>
#include <variant>

namespace axisc::validator {

/// What tells one content from another; equal for equal lines within one run of the program.
struct ContentMark {
  std::uint64_t bytes = 0;
  std::uint64_t hash = 0;
  friend bool operator==(ContentMark const&, ContentMark const&) = default;
};

struct ReadProgram {
  SourceText text;          ///< an excerpt: the lines that findings can point at
  grammar::NcProgram tree;  ///< its spans count in the text
  ContentMark mark;
};

enum class ProgramText : std::uint8_t { excerpt, whole };

/// Memory: that of the excerpt, and of the longest line. The same refusals as `check_text` has. With ProgramText::whole
/// the text is no excerpt.
[[nodiscard]] std::variant<ReadProgram, configuration::FileError> read_program(configuration::Files& files, std::string const& path,
                                                                ProgramText kept = ProgramText::excerpt);

/// Hands the bytes of a program that was read before to `receive` once more. Throws SourceChanged where they are no
/// longer the same.
void read_program_again(configuration::Files& files, std::string const& path, ContentMark const& mark,
                        configuration::PieceReceiver const& receive);

}  // namespace axisc::validator
