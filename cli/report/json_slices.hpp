// Slices of a JSON text, so that values can be copied byte for byte.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace axisc::cli {

// The text must be valid JSON (nlohmann::json::accept).

/// The text of the value of `key`; none if it is missing or `object` is not an object.
[[nodiscard]] std::optional<std::string_view> json_member(std::string_view object, std::string_view key);
/// The items of an array; none for anything else.
[[nodiscard]] std::optional<std::vector<std::string_view>> json_items(std::string_view array);

}  // namespace axisc::cli
