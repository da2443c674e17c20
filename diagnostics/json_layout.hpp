// JSON documents that are written piece by piece: one document of all findings would take several kilobytes of memory
// for each, so only one finding is a tree at a time.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace axisc {

/// Appends `value` with two-space indentation, every line but the first behind `indent`. Strings become well-formed
/// UTF-8 whatever they hold.
void append_indented(std::string& text, nlohmann::ordered_json const& value, std::string_view indent);

}  // namespace axisc
