#include "editor/reading/requests.hpp"

#include <nlohmann/json.hpp>

namespace axisc::editor {

TextPosition position_in(nlohmann::json const& json) {
  auto const count = [&json](char const* key) {
    return static_cast<std::size_t>(json.at(key).get_ref<nlohmann::json::number_unsigned_t const&>());
  };
  return {.line = count("line"), .character = count("character")};
}

}  // namespace axisc::editor
