// Recordings as texts: what TwinCAT Scope exports, and columns of any measuring program.
//
//   encoding     UTF-8, UTF-16 with a byte order mark, else windows-1252; lines end in LF or CRLF
//   header       TwinCAT Scope's table, from its last `Name` line on, or a line that names the columns, or
// none
//   separators   of the table: the character after a key (tab, semicolon, comma, colon, blank); else tabs,
//                semicolons or commas, whichever the first row has
//   groups       a time and the values up to the next time. A group that has ended is blank, or cut off at
// the
//                end of the row; rows that repeat time and values are dropped
//   numbers      with decimal points or decimal commas, one of them in a file
//   left out     blank lines, blanks and quotation marks around a field, separators at the end of a line
//   the end      of the text, or a line `EOF`
#pragma once

#include "analysis/recordings/bad_recording.hpp"
#include "analysis/recordings/recording.hpp"
#include "analysis/recordings/text_lines.hpp"

#include <variant>

namespace axisc::recordings {

/// Reads all samples: memory is that of the packed values, most often a tenth of the text. Cost: one pass.
[[nodiscard]] std::variant<Recording, BadRecording> read_text_recording(ByteSource source);

}  // namespace axisc::recordings
