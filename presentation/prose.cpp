#include "presentation/prose.hpp"

#include <algorithm>

namespace axisc::presentation {

namespace {

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  line.remove_prefix(1);
  while (!line.empty()) {
    auto cell = line.substr(0, line.find('|'));
    line.remove_prefix(std::min(cell.size() + 1, line.size()));
    cell.remove_prefix(std::min(cell.find_first_not_of(' '), cell.size()));
    cell = cell.substr(0, cell.find_last_not_of(' ') + 1);
    cells.emplace_back(cell);
  }
  return cells;
}

class ProseReader {
 public:
  void line(std::string_view line) {
    if (line.starts_with("```")) {
      end_paragraph();
      if (!is_code_) blocks_.emplace_back(Verbatim{.key = {}, .text = {}});
      is_code_ = !is_code_;
    } else if (is_code_) {
      std::get<Verbatim>(blocks_.back()).text.append(line).append("\n");
    } else if (line.starts_with('|')) {
      row(line);
    } else if (line.empty()) {
      end_paragraph();
    } else {
      paragraph_.append(paragraph_.empty() ? "" : " ").append(line);
    }
    is_table_ = line.starts_with('|');
  }

  std::vector<Block> finish() {
    end_paragraph();
    return std::move(blocks_);
  }

 private:
  void row(std::string_view line) {
    if (line.starts_with("|---")) return;
    end_paragraph();
    auto cells = cells_of(line);
    if (!is_table_) {
      auto& columns =
          std::get<Table>(blocks_.emplace_back(Table{.key = {}, .columns = {}, .rows = {}})).columns;
      for (auto& cell : cells) columns.push_back({.key = {}, .label = as_given(std::move(cell))});
      return;
    }
    auto& table = std::get<Table>(blocks_.back());
    cells.resize(table.columns.size());
    auto& values = table.rows.emplace_back();
    for (auto& cell : cells) values.emplace_back(cell.empty() ? Value() : as_given(std::move(cell)));
  }
  void end_paragraph() {
    if (!paragraph_.empty()) blocks_.emplace_back(Paragraph{as_given(std::move(paragraph_))});
    paragraph_.clear();
  }

  std::vector<Block> blocks_;
  std::string paragraph_;
  bool is_code_ = false, is_table_ = false;
};

}  // namespace

std::vector<Block> blocks_of(Prose const& prose, Language language) {
  std::string_view text = prose.markdown.in(language);
  ProseReader reader;
  while (!text.empty()) {
    auto const line = text.substr(0, text.find('\n'));
    reader.line(line);
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return reader.finish();
}

}  // namespace axisc::presentation
