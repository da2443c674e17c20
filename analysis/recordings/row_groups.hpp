// Samples from the rows of a text.
#pragma once

#include "analysis/recordings/bad_recording.hpp"
#include "analysis/recordings/decimal_number.hpp"
#include "analysis/recordings/layout.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace axisc::recordings {

class RowGroups {
 public:
  explicit RowGroups(Layout layout);

  /// Why the text is refused.
  [[nodiscard]] std::optional<BadRecording> add(std::string_view line, std::uint64_t number);
  /// Call once, after the last row.
  [[nodiscard]] std::variant<Recording, BadRecording> finish();

 private:
  [[nodiscard]] std::optional<BadRecording> add_group(FieldGroup const& group, std::uint64_t number);
  void add_sample(FieldGroup const& group, std::uint64_t number, double time);
  [[nodiscard]] std::optional<DecimalNumber> number_of(std::string_view field);
  static void break_clock(Clock& clock, ClockProblem problem, std::uint64_t number, std::string_view text);
  [[nodiscard]] bool is_blank(FieldGroup const& group) const;
  [[nodiscard]] std::optional<BadRecording> different_spans() const;

  Layout layout_;
  std::vector<std::string_view> fields_;  ///< of the row
  std::vector<double> values_;            ///< of a group of the row
  std::uint64_t rows_ = 0, last_line_ = 0;
  bool has_point_ = false, has_comma_ = false;
  bool has_ended_ = false;  ///< a group, before others
};

}  // namespace axisc::recordings
