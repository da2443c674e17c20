// Why a file is not a recording.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace axisc::recordings {

enum class RecordingProblem : std::uint8_t {
  // Of a text.
  no_rows,          ///< no line of numbers
  long_line,        ///< more than longest_line bytes
  field_count,      ///< `fields` at `line`, where the first row has `expected`
  mixed_marks,      ///< decimal commas and decimal points
  comma_separator,  ///< decimal commas where commas separate
  bad_table,        ///< `text`: a row of the header table whose groups are not those of the others
  different_spans,  ///< groups cover different times, and none ended
  // Of a binary file.
  too_short,        ///< fewer bytes than the head says
  bad_container,    ///< blocks with gaps, overlaps or equal numbers
  bad_xml,          ///< not UTF-8, or not well-formed
  bad_project,      ///< `text`: an element that is missing or not valid
  unknown_type,     ///< `text`
  compressed,       ///< `text`
  unknown_version,  ///< `text`, of a block
  bad_block,        ///< a rule of a block is broken
  bad_extremes,     ///< extremes do not agree with the samples
  bad_time,         ///< samples are not in the order of time
};

struct BadRecording {
  RecordingProblem problem = RecordingProblem::no_rows;
  std::uint64_t line = 0;  ///< from 1, of a text; of no_rows the last one
  std::uint64_t byte = 0;  ///< from 0, of a binary file
  std::size_t fields = 0, expected = 0;
  std::string text = {};  ///< valid UTF-8 and not long
};

}  // namespace axisc::recordings
