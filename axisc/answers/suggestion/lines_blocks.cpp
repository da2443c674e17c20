#include "axisc/answers/suggestion/suggest_answer.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence lines_of{"{axes}:", "{axes}:"};
constexpr Sentence nothing_to_write{
    "{axes}: nothing to write; their setpoints and lists stay as they are",
    "{axes}: nichts zu schreiben; ihre Sollwerte und Listen bleiben, wie sie sind"};
constexpr Sentence findings{"lists with this setting have findings: {codes}",
                            "Listen mit dieser Einstellung haben Befunde: {codes}"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

void add_lines(std::vector<Block>& blocks, std::vector<AxisLines> const& axes,
               std::vector<std::string> const& findings) {
  Sections all{.key = "axes", .items = {}};
  std::vector<std::pair<std::vector<tuning::ListLine>, Names>> together;
  for (auto const& one : axes) {
    auto const& lines = one.lines;
    auto table = table_of("lines", data_columns({"name", "value"}), lines, [](tuning::ListLine const& line) {
      return Row{line.name, line.value};
    });
    all.items.push_back({.key = {},
                         .title = {},
                         .blocks = {std::move(table)},
                         .identity = {data("axis", one.axis), data("list", one.list)},
                         .audience = Audience::programs});
    auto const same = std::find_if(together.begin(), together.end(),
                                   [&](auto const& group) { return group.first == lines; });
    auto& names = same != together.end() ? same->second : together.emplace_back(lines, Names()).second;
    names.push_back(one.axis + " (" + one.list + ")");
  }
  blocks.emplace_back(std::move(all));
  for (auto& [lines, names] : together) {
    blocks.emplace_back(Paragraph{
        Words(lines.empty() ? SentenceRef(says::nothing_to_write) : says::lines_of, {{"axes", names}})});
    std::size_t width = 0;
    for (auto const& line : lines) width = std::max(width, line.name.size());
    Verbatim text{.key = {}, .text = {}, .audience = Audience::people};
    for (auto const& line : lines) {
      constexpr std::size_t gap = 4;
      text.text.append(line.name).append(width + gap - line.name.size(), ' ').append(line.value).append("\n");
    }
    blocks.emplace_back(std::move(text));
  }
  blocks.emplace_back(Facts{{data("findings", Names(findings))}});
  if (!findings.empty()) {
    blocks.emplace_back(Paragraph{Words(says::findings, {{"codes", Names(findings)}})});
  }
}

}  // namespace axisc
