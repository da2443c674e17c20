#include "editor/capabilities/folding.hpp"

#include "editor/reading/open_machines.hpp"

#include <nlohmann/json.hpp>

namespace axisc::editor {

namespace {

enum class LineKind : std::uint8_t { blank, comment, other };

LineKind kind_of(std::string_view line) {
  auto const begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return LineKind::blank;
  return line[begin] == '#' || line[begin] == '(' || line[begin] == ';' ? LineKind::comment : LineKind::other;
}

}  // namespace

Json fold(OpenMachines& machines, Json const& params) {
  TextLines const lines(machines.asked(params).text, machines.encoding());
  auto ranges = Json::array();
  std::size_t heading = 0;  // line of the section's heading plus one; 0: none
  std::size_t comment = 0;  // first line of the current comment plus one; 0: none
  std::size_t last = 0;     // last line that is not blank plus one
  bool has_content = false;
  auto before = LineKind::blank;
  auto const end_comment = [&](std::size_t end) {
    if (comment != 0 && end > comment) {
      ranges.push_back({{"startLine", comment - 1}, {"endLine", end - 1}, {"kind", "comment"}});
    }
    comment = 0;
  };
  auto const end_section = [&] {
    if (heading != 0 && has_content) {
      ranges.push_back({{"startLine", heading - 1}, {"endLine", last - 1}, {"kind", "region"}});
    }
    heading = 0;
    has_content = false;
  };
  for (std::size_t i = 0; i < lines.count(); ++i) {
    auto const kind = kind_of(lines.line(i));
    if (kind == LineKind::comment && before != LineKind::comment) {
      if (before == LineKind::blank || heading == 0) {
        end_section();
        heading = i + 1;
      }
      comment = i + 1;
    }
    if (kind != LineKind::comment) end_comment(i);
    if (kind == LineKind::other) has_content = true;
    if (kind != LineKind::blank) last = i + 1;
    before = kind;
  }
  end_comment(lines.count());
  end_section();
  return ranges;
}

}  // namespace axisc::editor
