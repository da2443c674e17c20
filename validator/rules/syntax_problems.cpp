// What the grammar finds: AX1001 to AX1004, AX1008, AX1012.
#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

#include <array>
#include <cstdio>

namespace axisc::validator {
namespace {

using grammar::Problem;
using grammar::ProblemKind;

template <typename Visit>
void for_each_problem(ListContext const& context, ProblemKind kind, Visit visit) {
  for (Problem const& problem : context.list.tree.problems) {
    if (problem.kind == kind) visit(problem);
  }
}

std::string hexadecimal(char const* format, unsigned char byte) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), format, byte);
  return text.data();
}

}  // namespace

void checks::invalid_character(ListContext const& context, Report& report) {
  for_each_problem(context, ProblemKind::invalid_character, [&](Problem const& problem) {
    auto const byte = static_cast<unsigned char>(context.source.slice(problem.span).front());
    bool const undefined = byte >= 0x80 && context.source.encoding() == Encoding::windows_1252;
    std::string const shown = undefined     ? hexadecimal("0x%02X", byte)
                              : byte < 0x80 ? hexadecimal("U+%04X", byte)
                                            : "U+0080";
    Text const text = undefined ? Text::ax1001_undefined : Text::ax1001;
    report.add(place_of(context, problem.span), message(text, {{"character", shown}}));
  });
}

void checks::expected_name(ListContext const& context, Report& report) {
  for_each_problem(context, ProblemKind::expected_name, [&](Problem const& problem) {
    Finding& finding = report.add(place_of(context, problem.span), message(Text::ax1002));
    set_reaction(finding, Text::ax1002_reaction);
  });
}

void checks::expected_value(ListContext const& context, Report& report) {
  for_each_problem(context, ProblemKind::expected_value, [&](Problem const& problem) {
    std::string const name = context.source.utf8(problem.span);
    Finding& finding = report.add(place_of(context, problem.span), message(Text::ax1003, {{"name", name}}));
    finding.parameter = name;
    finding.help.push_back(message(Text::ax1003_help));
  });
}

void checks::malformed_index(ListContext const& context, Report& report) {
  for_each_problem(context, ProblemKind::malformed_index, [&](Problem const& problem) {
    std::string const index = context.source.utf8(problem.span);
    Finding& finding = report.add(place_of(context, problem.span), message(Text::ax1004, {{"index", index}}));
    finding.help.push_back(message(Text::ax1004_help));
  });
}

void checks::text_after_end(ListContext const& context, Report& report) {
  for_each_problem(context, ProblemKind::text_after_end, [&](Problem const& problem) {
    Finding& finding = report.add(place_of(context, problem.span), message(Text::ax1008));
    if (context.list.tree.end_marker) {
      finding.related.push_back({.place = place_of(context, *context.list.tree.end_marker),
                                 .message = message(Text::ax1008_related)});
    }
  });
}

void checks::unterminated_string(ListContext const& context, Report& report) {
  for_each_problem(context, ProblemKind::unterminated_string, [&](Problem const& problem) {
    report.add(place_of(context, problem.span), message(Text::ax1012));
  });
}

}  // namespace axisc::validator
