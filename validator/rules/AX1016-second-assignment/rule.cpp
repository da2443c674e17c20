#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax1016::says {

constexpr Sentence headline{"`{name}` is on the line of another parameter",
                            "`{name}` steht in der Zeile eines anderen Parameters"};
constexpr Sentence reaction{"it ignores the rest of the line", "sie übergeht den Rest der Zeile"};
constexpr Sentence fix{"begin a new line", "eine neue Zeile beginnen"};

}  // namespace axisc::validator::checks::ax1016::says

namespace axisc::validator::checks::ax1016 {
namespace {

/// The text after the value that is not a comment.
Span text_behind(Line const& line) {
  if (!line.line_value().trouble.empty()) return line.line_value().trouble;
  bool const is_text = line.assignment().trailer_kind == grammar::TrailerKind::text;
  return is_text ? line.assignment().trailer : Span{};
}

/// The name of a parameter there; empty where there is none.
Span second_name(Line const& line) {
  Span span = text_behind(line);
  std::string_view const text = line.context.source.slice(span);
  std::string_view const word = text.substr(0, text.find_first_of(" \t("));
  bool const is_name =
      word.find('.') != std::string_view::npos && line.context.list.catalogue.find(word).row != nullptr;
  span.end = span.begin + static_cast<std::uint32_t>(is_name ? word.size() : 0);
  return span;
}

void describe(Finding& finding, Line const& line) {
  SourceText const& source = line.context.source;
  Span const name = second_name(line);
  finding.message = message_of(says::headline, Argument{"name", line.text(name)});
  set_reaction(finding, says::reaction);
  Span const whole = source.line_span(line.assignment().line);
  std::string_view const before = source.slice({.begin = whole.begin, .end = name.begin});
  auto const gap = static_cast<std::uint32_t>(before.find_last_not_of(" \t") + 1) + whole.begin;
  finding.fix = replace_by(line.place({.begin = gap, .end = name.begin}), "\n", message(says::fix));
}

void second_assignment(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    if (Span const name = second_name(line); !name.empty()) report_line<describe>(report, line, name);
  });
}

}  // namespace

extern constinit Rule const rule{
    .precedence = Precedence::before_family,
    .check = second_assignment,
};

}  // namespace axisc::validator::checks::ax1016
