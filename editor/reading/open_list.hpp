// An open list, read together with its machine.
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
  /// `machine` is null if it cannot be read. `catalogue` is the one of axis lists; `kind`, from the settings,
  /// applies to a list without a machine. The machine and its sources outlive the list.
  OpenList(OpenDocument const& document, Buffers const& files, validator::LoadedMachine const* machine,
           SourceSet const& sources, schema::Catalogue const& catalogue,
           std::optional<schema::ListKind> kind);
  OpenList(OpenList const&) = delete;
  OpenList& operator=(OpenList const&) = delete;

  [[nodiscard]] SourceSet const& sources() const { return sources_; }
  [[nodiscard]] SourceText const& text() const { return text_; }
  [[nodiscard]] schema::Catalogue const& catalogue() const { return catalogue_; }
  [[nodiscard]] grammar::AxisList const& tree() const { return tree_; }
  [[nodiscard]] std::string_view slice(Span span) const { return text_.slice(span); }
  /// The assignment on the line that contains a byte; null for none.
  [[nodiscard]] grammar::Assignment const* line_at(std::size_t offset) const;
  [[nodiscard]] schema::NameLookup find(std::string_view name) const { return catalogue_.find(name); }
  /// The axis that the list configures; null if there are several, for default lists and other kinds.
  [[nodiscard]] validator::LoadedAxis const* axis() const { return axis_; }
  /// The unit of a parameter; if the type of the axis is unknown, that of translatory axes.
  [[nodiscard]] std::string_view unit_of(schema::Parameter const& row) const;
  /// The unit depends on the type of the axis, which is unknown.
  [[nodiscard]] bool is_unit_open(schema::Parameter const& row) const {
    return axis_ == nullptr && row.unit_rotary != row.unit_translatory && !row.unit_rotary.empty();
  }
  /// Of the machine; 1 ms if it is unknown.
  [[nodiscard]] design::CycleTime cycle_time() const;
  /// The lines that set a parameter for this list, as the control reads them: default list first.
  [[nodiscard]] std::vector<Place> lines_setting(schema::Slot slot) const;
  /// For a default list, also the lines of every axis that uses it.
  [[nodiscard]] std::vector<Place> lines_setting_in_machine(schema::Slot slot) const;

 private:
  void find_in(Buffers const& files, OpenDocument const& document);

  SourceText text_;
  grammar::AxisList tree_;
  SourceSet const& sources_;
  validator::LoadedMachine const* machine_;
  schema::Catalogue catalogue_;
  validator::LoadedAxis const* axis_ = nullptr;
  validator::LoadedList const* list_ = nullptr;
};

}  // namespace axisc::editor
