// Indents small JSON values, such as those in the heads and tails of reports, to their place in a document.
// Long ones are written by JsonStream.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace axisc {

/// Appends `value` with two-space indentation, every line but the first after `indent`. Strings are made
/// well-formed UTF-8.
void append_indented(std::string& text, nlohmann::ordered_json const& value, std::string_view indent);

}  // namespace axisc
