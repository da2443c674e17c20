// The places that set a parameter, as a hierarchy: each overrides those that the control reads before it, and the default.
#pragma once

#include "editor/reading/machine_reading.hpp"
#include "editor/reading/text_positions.hpp"

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace axisc::editor {

class ValueHierarchy {
 public:
  using Json = nlohmann::json;

  /// Both outlive this object. `asked` is the open document that the client asked from.
  ValueHierarchy(MachineReading& reading, Document const& asked, PositionEncoding encoding,
                 Language language);

  /// The parameter at a byte of the asked document, or what its number in a reference or comment names: the lines that set
  /// it for the document, its default where none does.
  [[nodiscard]] Json items_at(std::size_t offset) const;
  /// Of an item: what is overridden by it, in the order of reading, the default last.
  [[nodiscard]] Json overridden(Json const& item) const;
  /// What overrides it, in the order of reading: later lines of its list, and of a default list those of all axes.
  [[nodiscard]] Json overriding(Json const& item) const;

 private:
  struct Line {
    validator::LoadedList const* list;
    std::size_t assignment;
  };
  struct Chain {
    std::vector<Line> before;  ///< the control reads these first
    std::vector<Line> after;
  };

  [[nodiscard]] validator::LoadedList const* list_of(std::string const& uri) const;
  [[nodiscard]] static std::vector<Line> lines_in(validator::LoadedList const& list, schema::Slot slot);
  [[nodiscard]] Chain chain_of(Json const& item, validator::LoadedList const& list, schema::Slot slot) const;
  [[nodiscard]] Json item_of(Line const& line) const;
  /// None where the parameter has none.
  [[nodiscard]] Json default_item(schema::Parameter const& row, std::string const& name,
                                  Json const& at) const;

  MachineReading& reading_;
  Document const& asked_;
  PositionEncoding encoding_;
  Language language_;
};

}  // namespace axisc::editor
