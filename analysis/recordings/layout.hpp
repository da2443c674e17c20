// Which field of a row is what: the header of a text.
#pragma once

#include "analysis/recordings/recording.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc::recordings {

struct TextLine {
  std::uint64_t number = 0;  ///< from 1
  std::string text;
};

/// Fields that were sampled together: a time, unless the clock is counted, and the values of channels.
struct FieldGroup {
  std::size_t first = 0;    ///< field
  std::size_t clock = 0;    ///< index into Recording::clocks
  std::size_t channel = 0;  ///< index into Recording::channels, of the first value
  std::size_t values = 0;
  bool has_time = true;

  [[nodiscard]] std::size_t fields() const { return values + (has_time ? 1 : 0); }
};

struct Layout {
  char separator = ',';
  std::size_t fields = 0;  ///< of a row in which no group has ended
  std::vector<FieldGroup> groups;
  Recording recording;                              ///< without samples
  std::vector<std::optional<TimeUnit>> units = {};  ///< of each clock; none: its times decide
};

}  // namespace axisc::recordings
