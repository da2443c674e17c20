#include "axisc/answers/report/html.hpp"

#include "presentation/pictures/svg_text.hpp"

namespace axisc {

using pictures::escaped;

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

}  // namespace axisc
