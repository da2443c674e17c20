#include "schema/generator/kind_writer.hpp"

#include "schema/generator/catalogue_data.hpp"
#include "schema/generator/row_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

namespace axisc::schema::generator {
namespace {

std::string beginning_of(std::string_view name) {
  return std::string(name.substr(0, name.find_first_of(".[")));
}

/// The kinds in which names begin like this.
std::map<std::string, std::set<ListKind>> beginnings_of(KindRows const& kinds,
                                                        std::vector<ParameterRow> const& axis_rows) {
  std::map<std::string, std::set<ListKind>> beginnings;
  for (ParameterRow const& row : axis_rows) beginnings[beginning_of(row.name)].insert(ListKind::axis);
  for (auto const& [kind, rows] : kinds) {
    for (ParameterRow const& row : rows) beginnings[beginning_of(row.name)].insert(kind);
  }
  return beginnings;
}

}  // namespace

std::string write_kinds(KindRows const& kinds, std::vector<ParameterRow> const& axis_rows) {
  std::ostringstream out;
  out << "// Generated from other-lists.json. Edit that file instead.\n\n";
  for (auto const& [kind, rows] : kinds) {
    std::uint64_t slots = 0;
    for (ParameterRow const& row : rows) slots += slots_of(row.array);
    if (slots > std::numeric_limits<std::uint32_t>::max()) {
      throw DataError(std::string(row_of(kind).word) + ": more slots than can be counted");
    }
  }
  for (auto const& [kind, rows] : kinds) RowWriter(out, std::string(row_of(kind).word) + "_", rows).write();
  out << "\n// By kind.\nconstexpr std::span<Parameter const> kind_table[] = {\n";
  for (ListKindRow const& row : list_kind_rows) {
    out << "    " << (kinds.contains(row.kind) ? std::string(row.word) + "_parameter_table" : "{}") << ",\n";
  }
  out << "};\n\n// What names of one kind alone begin with, in the order of the texts.\n"
      << "constexpr Beginning beginning_table[] = {\n";
  for (auto const& [text, its_kinds] : beginnings_of(kinds, axis_rows)) {
    if (its_kinds.size() != 1) continue;
    out << "    {" << quoted(text) << ", ListKind::" << row_of(*its_kinds.begin()).word << "},\n";
  }
  out << "};\n";
  return std::move(out).str();
}

}  // namespace axisc::schema::generator
