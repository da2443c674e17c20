// Reads an NC program piece by piece, whatever its length.
#pragma once

#include "configuration/files.hpp"
#include "diagnostics/source_text.hpp"
#include "grammar/nc_program.hpp"

#include <cstdint>
#include <string>
#include <variant>

namespace axisc::validator {

/// Identifies a content; equal for equal lines within one run of the program.
struct ContentMark {
  std::uint64_t bytes = 0;
  std::uint64_t hash = 0;
  friend bool operator==(ContentMark const&, ContentMark const&) = default;
};

struct ReadProgram {
  SourceText text;          ///< an excerpt: the lines that findings can point at
  grammar::NcProgram tree;  ///< its spans refer to `text`
  ContentMark mark;
};

enum class ProgramText : std::uint8_t { excerpt, whole };

/// Memory: the excerpt and the longest line. Refuses what `check_text` refuses. With ProgramText::whole the
/// text is complete, not an excerpt.
[[nodiscard]] std::variant<ReadProgram, configuration::FileError> read_program(
    configuration::Files& files, std::string const& path, ProgramText kept = ProgramText::excerpt);

/// Passes the bytes of a program that was read before to `receive` again. Throws SourceChanged if they have
/// changed since.
void read_program_again(configuration::Files& files, std::string const& path, ContentMark const& mark,
                        configuration::PieceReceiver const& receive);

}  // namespace axisc::validator
