#include "grammar/print_tree.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace axisc::test {
namespace {

using namespace grammar;

std::string shown(std::string_view text) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string result = "<";
  for (char const c : text) {
    auto const byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F) {
      result += c;
    } else {
      result += "\\x";
      result += digits[byte / 16];
      result += digits[byte % 16];
    }
  }
  return result + '>';
}

std::string_view name_of(TrailerKind kind) {
  constexpr std::array<std::string_view, 5> names = {"none", "parenthesis", "hash", "slash-star", "text"};
  return names.at(static_cast<std::size_t>(kind));
}

class Printer {
 public:
  explicit Printer(std::string_view bytes) : bytes_(bytes) {}

  void add(Assignment const& assignment) {
    std::string text = view(assignment.name) + " = ";
    text += std::string(test::name_of(assignment.kind)) + " " + view(assignment.value);
    if (assignment.trailer_kind != TrailerKind::none) {
      text += ", " + std::string(name_of(assignment.trailer_kind)) + " " + view(assignment.trailer);
    }
    Span const free_text = grammar::free_text(bytes_, assignment);
    if (free_text != assignment.value) text += ", as text " + view(free_text);
    add(assignment.name.begin, assignment.line, text);
  }

  void add(Problem const& problem) {
    add(problem.span.begin, problem.line,
        "! " + std::string(test::name_of(problem.kind)) + " " + view(problem.span));
  }

  void add(Directive const& directive) {
    add(directive.comment.begin, directive.line,
        (directive.whole_line ? "directive for the next line " : "directive ") + view(directive.comment));
  }

  void add_end(Span span) { add(span.begin, 0, "end " + view(span)); }

  [[nodiscard]] std::string text(std::uint32_t lines) const {
    std::string text;
    for (auto const& [offset, line] : lines_) text += line;
    return text + std::to_string(lines) + " lines\n";
  }

 private:
  [[nodiscard]] std::string view(Span span) const { return shown(bytes_.substr(span.begin, span.size())); }

  void add(std::uint32_t offset, std::uint32_t line, std::string const& text) {
    lines_.emplace(offset, (line == 0 ? std::string("   ") : std::to_string(line) + ": ") + text + "\n");
  }

  std::string_view bytes_;
  std::multimap<std::uint32_t, std::string> lines_;
};

}  // namespace

std::string_view name_of(ValueKind kind) {
  constexpr std::array<std::string_view, 9> names = {"integer",       "hexadecimal",      "real",
                                                     "word",          "quoted",           "reference",
                                                     "decimal-comma", "malformed-number", "other"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string_view name_of(ProblemKind kind) {
  constexpr std::array<std::string_view, 6> names = {"invalid-character", "expected-name",
                                                     "expected-value",    "malformed-index",
                                                     "text-after-end",    "unterminated-string"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string print_tree(grammar::AxisList const& list, std::string_view bytes) {
  Printer printer(bytes);
  for (auto const& assignment : list.assignments) printer.add(assignment);
  for (auto const& problem : list.problems) printer.add(problem);
  for (auto const& directive : list.directives) printer.add(directive);
  if (list.end_marker) printer.add_end(*list.end_marker);
  return printer.text(list.lines);
}

}  // namespace axisc::test
