// The table that a scope writes before the rows of a text: a row for each property of the channels.
#pragma once

#include "analysis/recordings/bad_recording.hpp"
#include "analysis/recordings/layout.hpp"

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace axisc::recordings {

/// Key of a row of the header table at the front of `line`, and the separator after it.
struct TableKey {
  std::string_view name;
  char separator = '\t';
};
[[nodiscard]] std::optional<TableKey> table_key(std::string_view line);

/// The table in `header`, from its last `Name` line on; none where a line that is not of the table names the
/// columns of rows like `first_row`, or nothing does.
[[nodiscard]] std::variant<std::monostate, Layout, BadRecording> table_layout(
    std::vector<TextLine> const& header, TextLine const& first_row);

}  // namespace axisc::recordings
