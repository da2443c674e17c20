// Reads a list line by line, for callers that recognise simple lines themselves.
#pragma once

#include "grammar/axis_list.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace axisc::grammar {

template <typename Kind>
struct Failure;

class AxisListReader {
 public:
  /// `bytes` must outlive the reader.
  explicit AxisListReader(std::string_view bytes);

  /// One line without its line end, a piece of the text, by the grammar. `number` grows from line to line,
  /// counted from 1. `windows_1252` counts for a line with bytes above 0x7F only.
  void read(std::string_view line, std::uint32_t number, bool windows_1252);
  /// The content of the next lines, which the grammar need not read. The list has not ended.
  void add(std::span<Assignment const> assignments) {
    list_.assignments.insert(list_.assignments.end(), assignments.begin(), assignments.end());
  }

  /// The part of the list that was read so far.
  [[nodiscard]] AxisList const& list() const { return list_; }
  /// After `Ende` the control reads no further.
  [[nodiscard]] bool has_ended() const { return list_.end_marker.has_value(); }
  /// To be called when the whole text, this many lines, was read.
  [[nodiscard]] AxisList finish(std::uint32_t lines) && {
    list_.lines = lines;
    return std::move(list_);
  }

 private:
  void read_line(std::string_view line);
  void read_assignment(std::string_view line);
  void read_end(std::string_view line, std::string_view end, bool invalid);
  void read_behind_end(std::string_view line);
  bool report_invalid_character(std::string_view line);
  void report(Failure<ProblemKind> const& failure, std::string_view line);
  void report_text_behind_end(std::string_view text);
  void problem(ProblemKind kind, std::string_view text);
  void keep_directive(std::string_view comment, bool whole_line);
  [[nodiscard]] Span span(std::string_view text) const;

  std::string_view bytes_;
  bool windows_1252_ = false;
  std::uint32_t line_ = 0;  ///< that is being read
  AxisList list_;
  bool text_behind_end_reported_ = false;
};

}  // namespace axisc::grammar
