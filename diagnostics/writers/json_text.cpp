#include "diagnostics/writers/json_text.hpp"

#include "diagnostics/writers/json_stream.hpp"

#include <nlohmann/json.hpp>

namespace axisc {

std::string json_string(std::string_view text) {
  using Json = nlohmann::json;
  return escape_invisible(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string json_document(nlohmann::ordered_json const& json) {
  return escape_invisible(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + "\n";
}

}  // namespace axisc
