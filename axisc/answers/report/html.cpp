#include "axisc/answers/report/html.hpp"

#include "presentation/pictures/svg_text.hpp"

#include <algorithm>

namespace axisc {

namespace {

using pictures::escaped;

/// `code`, **bold** and [links](to) within a line. What has no end stays as it is.
std::string inline_html(std::string_view line) {
  std::string text;
  while (!line.empty()) {
    auto const quoted = [&](std::string_view mark, std::string_view tag) {
      if (!line.starts_with(mark)) return false;
      auto const end = line.find(mark, mark.size());
      if (end == std::string_view::npos) return false;
      auto const inner = line.substr(mark.size(), end - mark.size());
      text += mark == "`" ? text_of(tag, inner)
                          : "<" + std::string(tag) + ">" + inline_html(inner) + "</" + std::string(tag) + ">";
      line.remove_prefix(end + mark.size());
      return true;
    };
    if (quoted("`", "code") || quoted("**", "strong")) continue;
    if (auto const middle = line.find("]("); line.front() == '[' && middle != std::string_view::npos) {
      auto const end = line.find(')', middle);
      if (end != std::string_view::npos) {
        // Links lead out of the page; their words are enough.
        text += inline_html(line.substr(1, middle - 1));
        line.remove_prefix(end + 1);
        continue;
      }
    }
    text += escaped(line.substr(0, 1));
    line.remove_prefix(1);
  }
  return text;
}

std::string table_row(std::string_view line, std::string_view tag) {
  std::string text = "<tr>";
  line.remove_prefix(1);
  while (!line.empty()) {
    auto const end = std::min(line.find('|'), line.size());
    auto cell = line.substr(0, end);
    while (cell.starts_with(' ')) cell.remove_prefix(1);
    while (cell.ends_with(' ')) cell.remove_suffix(1);
    text += "<" + std::string(tag) + ">" + inline_html(cell) + "</" + std::string(tag) + ">";
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return text + "</tr>\n";
}

/// Blocks of one document, line by line.
class MarkdownWriter {
 public:
  explicit MarkdownWriter(int level) : level_(level) {}

  void line(std::string_view line) {
    if (line.starts_with("```")) {
      end_block();
      text_ += is_code_ ? "</pre>\n" : R"(<pre tabindex="0">)";
      is_code_ = !is_code_;
    } else if (is_code_) {
      text_ += escaped(line) + "\n";
    } else if (line.starts_with('#')) {
      end_block();
      auto const words = line.substr(std::min(line.find_first_not_of("# "), line.size()));
      auto const tag = "h" + std::to_string(std::min(level_ + 1, 6));
      text_ += "<" + tag + ">" + inline_html(words) + "</" + tag + ">\n";
    } else if (line.starts_with("|---")) {
      return;
    } else if (line.starts_with('|')) {
      bool const is_header = open("table");
      text_ += table_row(line, is_header ? "th" : "td");
    } else if (line.starts_with("- ")) {
      open("ul");
      text_ += "<li>" + inline_html(line.substr(2)) + "</li>\n";
    } else if (line.find_first_not_of(' ') == std::string_view::npos) {
      end_block();
    } else {
      if (!open("p")) text_ += "\n";
      text_ += inline_html(line);
    }
  }

  std::string finish() {
    end_block();
    if (is_code_) text_ += "</pre>\n";
    return std::move(text_);
  }

 private:
  /// True where the block begins here.
  bool open(std::string_view tag) {
    if (block_ == tag) return false;
    end_block();
    block_ = tag;
    text_ += "<" + block_ + ">";
    return true;
  }
  void end_block() {
    if (!block_.empty()) text_ += "</" + block_ + ">\n";
    block_.clear();
  }

  int level_;
  std::string text_, block_;
  bool is_code_ = false;
};

}  // namespace

std::string text_of(std::string_view tag, std::string_view text) {
  std::string html = "<";
  return html.append(tag).append(">").append(escaped(text)).append("</").append(tag).append(">");
}

std::string heading(int level, std::string_view id, std::string_view text) {
  std::string const tag = "h" + std::to_string(level);
  return "<" + tag + pictures::attribute("id", id) + ">" + escaped(text) + "</" + tag + ">\n";
}

std::string details(std::string_view summary, std::string_view content) {
  return "<details>" + text_of("summary", summary) + "\n" + std::string(content) + "</details>\n";
}

std::string html_of_markdown(std::string_view markdown, int level) {
  MarkdownWriter writer(level);
  while (!markdown.empty()) {
    auto const end = std::min(markdown.find('\n'), markdown.size());
    writer.line(markdown.substr(0, end));
    markdown.remove_prefix(std::min(end + 1, markdown.size()));
  }
  return writer.finish();
}

}  // namespace axisc
