// The list that a request is about, read with its machine.
#pragma once

#include "axisc/workspace/buffers.hpp"
#include "grammar/axis_list.hpp"
#include "validator/loading/loading.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace axisc::editor {

/// False for machine files, programs, XML and projects.
[[nodiscard]] bool is_list(std::string const& path);

class OpenList {
 public:
  /// `machine` is null where it cannot be read; `catalogue` is that of its axis lists, `kind` what the settings say of a list
  /// alone. The machine and its sources outlive the list.
  OpenList(Document const& document, Buffers const& files, validator::LoadedMachine const* machine,
           SourceSet const& sources, schema::Catalogue const& catalogue,
           std::optional<schema::ListKind> kind);
  OpenList(OpenList const&) = delete;
  OpenList& operator=(OpenList const&) = delete;

  [[nodiscard]] SourceSet const& sources() const { return sources_; }
  [[nodiscard]] SourceText const& text() const { return text_; }
  [[nodiscard]] schema::Catalogue const& catalogue() const { return catalogue_; }
  [[nodiscard]] grammar::AxisList const& tree() const { return tree_; }
  [[nodiscard]] std::string_view slice(Span span) const { return text_.slice(span); }
  /// The assignment of the line that a byte is in.
  [[nodiscard]] grammar::Assignment const* line_at(std::size_t offset) const;
  /// What a name of the list means.
  [[nodiscard]] schema::NameLookup find(std::string_view name) const { return catalogue_.find(name); }
  /// The axis that the list makes; none for default lists, lists of other kinds, and where it makes several.
  [[nodiscard]] validator::LoadedAxis const* axis() const { return axis_; }
  /// The unit of a parameter of the list's axis, of a translatory one where it is not known.
  [[nodiscard]] std::string_view unit_of(schema::Parameter const& row) const;
  /// The unit depends on the type of the axis, which is not known.
  [[nodiscard]] bool is_unit_open(schema::Parameter const& row) const {
    return axis_ == nullptr && row.unit_rotary != row.unit_translatory && !row.unit_rotary.empty();
  }
  /// Of the machine; 1 ms where it is not known.
  [[nodiscard]] design::CycleTime cycle_time() const;
  /// The lines of an axis' lists that set a parameter, as the control reads them: default list, axis list.
  [[nodiscard]] std::vector<Place> lines_setting(schema::Slot slot) const;
  /// From a default list also those of every axis that it serves.
  [[nodiscard]] std::vector<Place> lines_setting_in_machine(schema::Slot slot) const;

 private:
  void find_in(Buffers const& files, Document const& document);

  SourceText text_;
  grammar::AxisList tree_;
  SourceSet const& sources_;
  validator::LoadedMachine const* machine_;
  schema::Catalogue catalogue_;
  validator::LoadedAxis const* axis_ = nullptr;
  validator::LoadedList const* list_ = nullptr;
};

}  // namespace axisc::editor
