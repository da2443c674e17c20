#include "grammar/axis_list.hpp"

#include "grammar/axis_list_def.hpp"
#include "grammar/character_class.hpp"
#include "grammar/directive_finder.hpp"
#include "grammar/invalid_character.hpp"
#include "grammar/line_splitter.hpp"
#include "grammar/must.hpp"
#include "grammar/regular_lines.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace axisc::grammar {
namespace {

constexpr std::size_t typical_line = 40;
constexpr std::size_t largest_reservation = 1U << 14U;
constexpr std::size_t regular_assignments = 32;

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is(character::blank, text.front())) text.remove_prefix(1);
  while (!text.empty() && is(character::blank, text.back())) text.remove_suffix(1);
  return text;
}

std::string_view first_word(std::string_view line) {
  return line.substr(0, std::min(line.find_first_of(" \t"), line.size()));
}

/// Runs one parser of the grammar from the start of `line`; no attribute, no expectations.
template <typename Parser>
std::string_view matched(Parser const& parser, std::string_view line) {
  char const* position = line.data();
  if (!parser.parse(position, line.data() + line.size(), x3::unused, x3::unused, x3::unused)) return {};
  return line.substr(0, static_cast<std::size_t>(position - line.data()));
}

/// `text` begins at a value token: up to the first `(` outside quotes.
std::string_view up_to_parenthesis(std::string_view text) {
  std::size_t position = text.find_first_of("\"(");
  while (position != std::string_view::npos && text[position] == '"') {
    std::size_t const closing = text.find('"', position + 1);
    position =
        closing == std::string_view::npos ? text.find('(', position) : text.find_first_of("\"(", closing + 1);
  }
  return without_blanks(text.substr(0, position));
}

class Reader {
 public:
  Reader(std::string_view bytes, std::uint32_t text_begin, bool windows_1252)
      : bytes_(bytes), windows_1252_(windows_1252), splitter_(bytes.substr(text_begin)), directives_(bytes) {
    list_.assignments.reserve(std::min(bytes.size() / typical_line, largest_reservation));
  }

  AxisList read(Way way) && {
    RegularLineReader const regular_reader = find_regular_line_reader(way);
    std::string_view line;
    while (true) {
      if (regular_reader != nullptr) read_regular(regular_reader);
      if (!splitter_.next(line)) break;
      std::string_view const text = without_blanks(line);
      if (text.empty()) continue;
      if (list_.end_marker) {
        read_behind_end(text);
      } else {
        read_line(text);
      }
    }
    list_.lines = splitter_.number();
    return std::move(list_);
  }

 private:
  /// Reads on up to the first line that needs the grammar.
  void read_regular(RegularLineReader reader) {
    if (list_.end_marker || splitter_.remaining() <= room_behind_line) return;
    RegularLines lines{.text = bytes_.data(),
                       .line = splitter_.position(),
                       .stop = find_stop(),
                       .end = splitter_.end(),
                       .number = splitter_.number(),
                       .windows_1252 = windows_1252_};
    std::size_t count = 0;
    do {
      count = reader(lines, regular_.data(), regular_.size());
      list_.assignments.insert(list_.assignments.end(), regular_.data(), regular_.data() + count);
    } while (count == regular_.size());
    splitter_.go_on_at(lines.line, lines.number);
  }

  /// A line with a directive is left to the grammar, and so are those with little room behind them.
  [[nodiscard]] char const* find_stop() {
    auto const position = static_cast<std::size_t>(splitter_.position() - bytes_.data());
    std::size_t const directive = directives_.next(position);
    if (directive != next_directive_) {
      next_directive_ = directive;
      directive_line_ = directive == std::string_view::npos ? bytes_.size() : line_begin(directive);
    }
    return bytes_.data() + std::min(directive_line_, bytes_.size() - room_behind_line);
  }

  [[nodiscard]] std::size_t line_begin(std::size_t place) const {
    std::size_t const line_feed = bytes_.rfind('\n', place);
    return line_feed == std::string_view::npos ? 0 : line_feed + 1;
  }

  void read_line(std::string_view line) {
    bool const invalid = report_invalid_character(line);
    if (line.front() == '#') {
      keep_directive(line, true);
    } else if (std::string_view const end = matched(syntax::end_marker, line); !end.empty()) {
      read_end(line, end, invalid);
    } else if (invalid) {
      keep_directive(comment_of_broken(line), false);
    } else {
      read_assignment(line);
    }
  }

  bool report_invalid_character(std::string_view line) {
    auto const found = find_invalid_character(line, windows_1252_);
    if (found) problem(ProblemKind::invalid_character, line.substr(found->begin, found->size()));
    return found.has_value();
  }

  void read_assignment(std::string_view line) {
    syntax::AssignmentLine parsed;
    Failure<ProblemKind> failure;
    char const* position = line.data();
    syntax::assignment.parse(position, line.data() + line.size(), x3::make_context<FailureTag>(failure),
                             x3::unused, parsed);
    if (failure.where != nullptr) {
      report(failure, line);
      keep_directive(comment_of_broken(line), false);
      return;
    }
    std::string_view const from_value =
        line.substr(static_cast<std::size_t>(parsed.value.text.begin() - line.data()));
    std::string_view const trailer = view(parsed.trailer.text);
    list_.assignments.push_back({.name = span(view(parsed.name)),
                                 .value = span(view(parsed.value.text)),
                                 .trailer = span(trailer),
                                 .free_text = span(up_to_parenthesis(from_value)),
                                 .kind = parsed.value.kind,
                                 .trailer_kind = parsed.trailer.kind,
                                 .line = splitter_.number()});
    keep_directive(trailer, false);
  }

  void report(Failure<ProblemKind> const& failure, std::string_view line) {
    std::string_view const rest = line.substr(static_cast<std::size_t>(failure.where - line.data()));
    switch (failure.kind) {
      case ProblemKind::malformed_index:
        return problem(failure.kind, matched(syntax::broken_index, rest));
      case ProblemKind::unterminated_string:
        return problem(failure.kind, rest);
      default:
        return problem(failure.kind, first_word(line));
    }
  }

  void read_end(std::string_view line, std::string_view end, bool invalid) {
    list_.end_marker = span(end);
    std::string_view const behind = without_blanks(line.substr(end.size()));
    if (behind.empty()) return;
    if (behind.front() == '#' || behind.front() == '(') {
      keep_directive(behind, false);
    } else if (!invalid) {
      report_text_behind_end(behind);
    }
  }

  /// The control does not read on, so neither characters nor syntax matter here.
  void read_behind_end(std::string_view line) {
    if (line.front() != '#') report_text_behind_end(line);
  }

  void report_text_behind_end(std::string_view text) {
    if (!text_behind_end_reported_) problem(ProblemKind::text_after_end, text);
    text_behind_end_reported_ = true;
  }

  /// A line that could not be read may still carry a directive: from the first thing that looks like a
  /// comment.
  static std::string_view comment_of_broken(std::string_view line) {
    std::size_t const opener = std::min({line.find('('), line.find('#'), line.find("/*"), line.size()});
    return line.substr(opener);
  }

  void keep_directive(std::string_view comment, bool whole_line) {
    keep_directive(span(comment), whole_line);
  }

  void keep_directive(Span comment, bool whole_line) {
    if (!directives_.within(comment)) return;
    list_.directives.push_back({.comment = comment, .whole_line = whole_line, .line = splitter_.number()});
  }

  void problem(ProblemKind kind, std::string_view text) {
    list_.problems.push_back({.kind = kind, .span = span(text), .line = splitter_.number()});
  }

  [[nodiscard]] static std::string_view view(syntax::Range const& range) {
    return {range.begin(), static_cast<std::size_t>(range.size())};
  }

  [[nodiscard]] Span span(std::string_view text) const {
    auto const begin = static_cast<std::uint32_t>(text.data() - bytes_.data());
    return {.begin = begin, .end = begin + static_cast<std::uint32_t>(text.size())};
  }

  std::string_view bytes_;
  bool windows_1252_;
  LineSplitter splitter_;
  DirectiveFinder directives_;
  std::size_t next_directive_ = 0;
  std::size_t directive_line_ = 0;  ///< where its line begins
  AxisList list_;
  std::array<Assignment, regular_assignments> regular_;
  bool text_behind_end_reported_ = false;
};

}  // namespace

AxisList parse_axis_list(std::string_view bytes, std::uint32_t text_begin, bool windows_1252, Way way) {
  return Reader(bytes, text_begin, windows_1252).read(way);
}

std::size_t longest_line_in(std::string_view bytes) {
  std::size_t longest = 0;
  LineSplitter splitter(bytes);
  for (std::string_view line; splitter.next(line);) longest = std::max(longest, line.size());
  return longest;
}

}  // namespace axisc::grammar
