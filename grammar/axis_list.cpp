#include "grammar/axis_list.hpp"

#include "diagnostics/utf8.hpp"
#include "grammar/axis_list_def.hpp"
#include "grammar/axis_list_reader.hpp"
#include "grammar/character_class.hpp"
#include "grammar/invalid_character.hpp"
#include "grammar/lexical.hpp"
#include "grammar/line_splitter.hpp"
#include "grammar/must.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace axisc::grammar {
namespace {

constexpr std::size_t typical_line = 40;
constexpr std::size_t largest_reservation = 1U << 14U;

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is(character::blank, text.front())) text.remove_prefix(1);
  while (!text.empty() && is(character::blank, text.back())) text.remove_suffix(1);
  return text;
}

std::string_view first_word(std::string_view line) {
  auto const* const end =
      std::find_if(line.begin(), line.end(), [](char byte) { return is(character::blank, byte); });
  return line.substr(0, static_cast<std::size_t>(end - line.begin()));
}

/// Runs one parser of the grammar from the start of `line`; no attribute, no expectations.
template <typename Parser>
std::string_view matched(Parser const& parser, std::string_view line) {
  char const* position = line.data();
  if (!parser.parse(position, line.data() + line.size(), x3::unused, x3::unused, x3::unused)) return {};
  return line.substr(0, static_cast<std::size_t>(position - line.data()));
}

/// Hardly any comment has one, so it is searched for the rare colon.
bool is_directive(std::string_view comment) {
  for (std::size_t colon = comment.find(':'); colon != std::string_view::npos;
       colon = comment.find(':', colon + 1)) {
    if (comment.substr(0, colon + 1).ends_with(directive_introducer)) return true;
  }
  return false;
}

std::size_t find_mark(std::string_view text, std::size_t from) {
  while (from < text.size() && !is(character::quote | character::parenthesis, text[from])) ++from;
  return from;
}

/// `text` begins at a value token: up to the first `(` outside quotes.
std::string_view up_to_parenthesis(std::string_view text) {
  std::size_t position = find_mark(text, 0);
  while (position < text.size() && text[position] == '"') {
    std::size_t const closing = text.find('"', position + 1);
    position = closing == std::string_view::npos ? text.find(lexical::parenthesis, position)
                                                 : find_mark(text, closing + 1);
  }
  return without_blanks(text.substr(0, position));
}

/// A line that could not be read may still carry a directive: from the first thing that looks like a comment.
std::string_view comment_of_broken(std::string_view line) {
  std::size_t opener = 0;
  while (opener < line.size() && !lexical::opens_comment(line.substr(opener))) ++opener;
  return line.substr(opener);
}

std::string_view view(syntax::Range const& range) {
  return {range.begin(), static_cast<std::size_t>(range.size())};
}

}  // namespace

AxisListReader::AxisListReader(std::string_view bytes) : bytes_(bytes) {
  list_.assignments.reserve(std::min(bytes.size() / typical_line, largest_reservation));
}

void AxisListReader::read(std::string_view line, std::uint32_t number, bool windows_1252) {
  line_ = number;
  windows_1252_ = windows_1252;
  std::string_view const text = without_blanks(line);
  if (text.empty()) return;
  if (has_ended()) {
    read_behind_end(text);
  } else {
    read_line(text);
  }
}

void AxisListReader::read_line(std::string_view line) {
  bool const invalid = report_invalid_character(line);
  if (line.front() == lexical::hash) {
    keep_directive(line, true);
  } else if (std::string_view const end = matched(syntax::end_marker, line); !end.empty()) {
    read_end(line, end, invalid);
  } else if (invalid) {
    keep_directive(comment_of_broken(line), false);
  } else {
    read_assignment(line);
  }
}

bool AxisListReader::report_invalid_character(std::string_view line) {
  auto const found = find_invalid_character(line, windows_1252_);
  if (found) problem(ProblemKind::invalid_character, line.substr(found->begin, found->size()));
  return found.has_value();
}

void AxisListReader::read_assignment(std::string_view line) {
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
  std::string_view const trailer = view(parsed.trailer.text);
  list_.assignments.push_back({.name = span(view(parsed.name)),
                               .value = span(view(parsed.value.text)),
                               .trailer = span(trailer),
                               .line = line_,
                               .kind = parsed.value.kind,
                               .trailer_kind = parsed.trailer.kind});
  keep_directive(trailer, false);
}

void AxisListReader::report(Failure<ProblemKind> const& failure, std::string_view line) {
  std::string_view const from_there = line.substr(static_cast<std::size_t>(failure.where - line.data()));
  switch (failure.kind) {
    case ProblemKind::malformed_index:
      return problem(failure.kind, matched(syntax::broken_index, from_there));
    case ProblemKind::unterminated_string: return problem(failure.kind, from_there);
    default: return problem(failure.kind, first_word(line));
  }
}

void AxisListReader::read_end(std::string_view line, std::string_view end, bool invalid) {
  list_.end_marker = span(end);
  std::string_view const behind = without_blanks(line.substr(end.size()));
  if (behind.empty()) return;
  if (behind.front() == lexical::hash || behind.front() == lexical::parenthesis) {
    keep_directive(behind, false);
  } else if (!invalid) {
    report_text_behind_end(behind);
  }
}

/// The control stops reading here, so neither characters nor syntax matter.
void AxisListReader::read_behind_end(std::string_view line) {
  if (line.front() != lexical::hash) report_text_behind_end(line);
}

void AxisListReader::report_text_behind_end(std::string_view text) {
  if (!text_behind_end_reported_) problem(ProblemKind::text_after_end, text);
  text_behind_end_reported_ = true;
}

void AxisListReader::keep_directive(std::string_view comment, bool whole_line) {
  if (!is_directive(comment)) return;
  list_.directives.push_back({.comment = span(comment), .whole_line = whole_line, .line = line_});
}

void AxisListReader::problem(ProblemKind kind, std::string_view text) {
  list_.problems.push_back({.kind = kind, .span = span(text), .line = line_});
}

Span AxisListReader::span(std::string_view text) const {
  auto const begin = static_cast<std::uint32_t>(text.data() - bytes_.data());
  return {.begin = begin, .end = begin + static_cast<std::uint32_t>(text.size())};
}

AxisList parse_axis_list(std::string_view bytes, std::uint32_t text_begin, bool windows_1252,
                         std::uint32_t lines_before) {
  AxisListReader reader(bytes);
  LineSplitter splitter(bytes.substr(text_begin), lines_before);
  for (std::string_view line; splitter.next(line);) reader.read(line, splitter.number(), windows_1252);
  return std::move(reader).finish(splitter.number());
}

AxisList parse_axis_list(SourceText const& source) {
  // The encoding is determined only if a byte depends on it.
  bool const is_ascii = ascii_prefix(source.bytes()) == source.bytes().size();
  return parse_axis_list(source.bytes(), source.text_begin(),
                         !is_ascii && source.encoding() == Encoding::windows_1252, source.lines_before());
}

Span free_text(std::string_view bytes, Assignment const& assignment) {
  std::string_view const text =
      bytes.substr(assignment.value.begin, assignment.trailer.end - assignment.value.begin);
  std::size_t const size = up_to_parenthesis(text).size();
  return {.begin = assignment.value.begin, .end = assignment.value.begin + static_cast<std::uint32_t>(size)};
}

std::size_t longest_line_in(std::string_view bytes) {
  std::size_t longest = 0;
  LineSplitter splitter(bytes);
  for (std::string_view line; splitter.next(line);) longest = std::max(longest, line.size());
  return longest;
}

}  // namespace axisc::grammar
