// JSON values that are small and few, as the heads and tails of reports hold them, at their place in a document. What is
// long is written by JsonStream.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace axisc {

/// Appends `value` with two-space indentation, every line but the first behind `indent`. Strings become well-formed
/// UTF-8 whatever they hold.
void append_indented(std::string& text, nlohmann::ordered_json const& value, std::string_view indent);

}  // namespace axisc
