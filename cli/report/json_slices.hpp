// Parts of a JSON text as they stand there, so that they can be written again byte for byte.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace axisc::cli {

// For text that is JSON (nlohmann::json::accept).

/// The text behind `key` of an object; none where it is missing, or `object` is no object.
[[nodiscard]] std::optional<std::string_view> json_member(std::string_view object, std::string_view key);
/// The items of an array; none for anything else.
[[nodiscard]] std::optional<std::vector<std::string_view>> json_items(std::string_view array);

}  // namespace axisc::cli
