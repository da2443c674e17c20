#include "editor/capabilities/hierarchy.hpp"

#include "editor/meaning/value_hierarchy.hpp"
#include "editor/reading/open_machines.hpp"

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

ValueHierarchy hierarchy_of(OpenMachines& machines, Document const& document) {
  return {machines.reading_of(document), document, machines.encoding(), machines.language()};
}

/// An item carries the document that it was asked from.
ValueHierarchy hierarchy_of(OpenMachines& machines, Json const& item) {
  return hierarchy_of(machines, machines.document(item.at("data").at("document")));
}

}  // namespace

Json prepare_hierarchy(OpenMachines& machines, Json const& params) {
  auto const& asked = machines.asked(params);
  if (!is_list(asked.path)) return nullptr;
  return hierarchy_of(machines, asked).items_at(machines.offset(asked, params));
}

Json supertypes(OpenMachines& machines, Json const& params) {
  auto const& item = params.at("item");
  return hierarchy_of(machines, item).overridden(item);
}

Json subtypes(OpenMachines& machines, Json const& params) {
  auto const& item = params.at("item");
  return hierarchy_of(machines, item).overriding(item);
}

}  // namespace axisc::editor
