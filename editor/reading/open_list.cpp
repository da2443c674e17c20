#include "editor/reading/open_list.hpp"

#include "configuration/list_kind.hpp"
#include "configuration/project_file.hpp"
#include "configuration/start_up_list.hpp"
#include "configuration/xml/xml_names.hpp"
#include "validator/views/units_text.hpp"

#include <algorithm>

namespace axisc::editor {

namespace {

schema::ListKind kind_of(SourceText const& text) {
  if (configuration::looks_like_start_up_list(text.bytes())) return schema::ListKind::startup;
  return configuration::decided_kind(text).value_or(schema::ListKind::axis);
}

void add_lines(validator::LoadedList const& list, schema::Slot slot, std::vector<Place>& places) {
  for (std::size_t i = 0; i < list.tree.assignments.size(); ++i) {
    if (list.line_values.slot(i) != slot) continue;
    places.push_back({.source = list.source, .span = list.tree.assignments[i].name});
  }
}

}  // namespace

bool is_list(std::string const& path) {
  return !configuration::is_xml_name(path) && !configuration::is_project_name(path) &&
         !path.ends_with(".json") && !path.ends_with(".nc");
}

OpenList::OpenList(OpenDocument const& document, Buffers const& files,
                   validator::LoadedMachine const* machine, SourceSet const& sources,
                   schema::Catalogue const& catalogue, std::optional<schema::ListKind> kind)
    : text_(document.path, document.text),
      tree_(grammar::parse_axis_list(text_)),
      sources_(sources),
      machine_(machine) {
  if (machine_ != nullptr) find_in(files, document);
  if (list_ != nullptr) {
    catalogue_ = list_->catalogue;
    return;
  }
  auto const known = kind ? *kind : kind_of(text_);
  catalogue_ = known == schema::ListKind::axis ? catalogue : schema::Catalogue::of(known);
}

void OpenList::find_in(Buffers const& files, OpenDocument const& document) {
  auto const& machine = *machine_;
  auto const is_here = [&](validator::NamedList const& named) {
    return files.document(sources_[named.list.source].name()) == &document;
  };
  for (std::size_t i = 0; i < machine.lists.size(); ++i) {
    if (!is_here(machine.lists[i])) continue;
    list_ = &machine.lists[i].list;
    for (auto const& axis : machine.axes) {
      if (axis.list != i) continue;
      axis_ = axis_ == nullptr ? &axis : nullptr;
      if (axis_ == nullptr) return;
    }
    if (axis_ != nullptr) return;
  }
  for (auto const& named : machine.other_lists) {
    if (is_here(named)) list_ = &named.list;
  }
}

grammar::Assignment const* OpenList::line_at(std::size_t offset) const {
  auto const line = text_.position(static_cast<std::uint32_t>(offset)).line;
  auto const found = std::lower_bound(
      tree_.assignments.begin(), tree_.assignments.end(), line,
      [](grammar::Assignment const& assignment, std::uint32_t wanted) { return assignment.line < wanted; });
  return found == tree_.assignments.end() || found->line != line ? nullptr : &*found;
}

std::string_view OpenList::unit_of(schema::Parameter const& row) const {
  return validator::unit_of(row, axis_ == nullptr ? machine::AxisType::translatory : axis_->type);
}

design::CycleTime OpenList::cycle_time() const {
  return machine_ != nullptr ? machine_->cycle_time.value_or(design::CycleTime{}) : design::CycleTime{};
}

std::vector<Place> OpenList::lines_setting_in_machine(schema::Slot slot) const {
  auto places = lines_setting(slot);
  if (list_ == nullptr || !list_->is_default_list) return places;
  for (auto const& named : machine_->lists) {
    if (&named.list != list_) add_lines(named.list, slot, places);
  }
  return places;
}

std::vector<Place> OpenList::lines_setting(schema::Slot slot) const {
  std::vector<Place> places;
  if (list_ == nullptr) return places;
  bool const is_of_axis = list_->kind == schema::ListKind::axis && !list_->is_default_list;
  auto const* const defaults = is_of_axis ? machine_->list_of_defaults() : nullptr;
  for (auto const* const list : {defaults, list_}) {
    if (list != nullptr) add_lines(*list, slot, places);
  }
  return places;
}

}  // namespace axisc::editor
