#include "editor/meaning/value_hierarchy.hpp"
#include "editor/reading/requests.hpp"
#include "editor/server.hpp"

#include <nlohmann/json.hpp>

namespace axisc::editor {

using Json = nlohmann::json;

Json Server::prepare_hierarchy(Json const& params) {
  auto const& asked = document(params);
  if (!is_list(asked.path)) return nullptr;
  auto const offset = offset_of(asked.text, position_in(params.at("position")), encoding_);
  return ValueHierarchy(reading_of(asked), asked, encoding_, surroundings_.language).items_at(offset);
}

Json Server::supertypes(Json const& params) {
  auto const& item = params.at("item");
  auto const& asked = documents_.at(item.at("data").at("document").get<std::string>());
  return ValueHierarchy(reading_of(asked), asked, encoding_, surroundings_.language).overridden(item);
}

Json Server::subtypes(Json const& params) {
  auto const& item = params.at("item");
  auto const& asked = documents_.at(item.at("data").at("document").get<std::string>());
  return ValueHierarchy(reading_of(asked), asked, encoding_, surroundings_.language).overriding(item);
}

}  // namespace axisc::editor
