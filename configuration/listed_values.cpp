#include "configuration/listed_values.hpp"

#include "diagnostics/ascii.hpp"
#include "grammar/axis_list.hpp"

#include <charconv>
#include <system_error>

namespace axisc::configuration {
namespace {

using grammar::ValueKind;

/// Numbers end at a blank; words and paths continue to the comment.
Span value_span(SourceText const& text, grammar::Assignment const& assignment) {
  switch (assignment.kind) {
    case ValueKind::integer:
    case ValueKind::hexadecimal:
    case ValueKind::real:
    case ValueKind::reference: return assignment.value;
    case ValueKind::quoted: return {.begin = assignment.value.begin + 1, .end = assignment.value.end - 1};
    default: return grammar::free_text(text.bytes(), assignment);
  }
}

}  // namespace

std::vector<ListedValue> listed_values(SourceText const& text, SourceId source) {
  grammar::AxisList const list = grammar::parse_axis_list(text);
  std::vector<ListedValue> values;
  values.reserve(list.assignments.size());
  for (grammar::Assignment const& assignment : list.assignments) {
    Span const span = value_span(text, assignment);
    values.push_back({.name = text.slice(assignment.name),
                      .value = {.text = text.utf8(span), .place = {.source = source, .span = span}},
                      .name_place = {.source = source, .span = assignment.name}});
  }
  return values;
}

std::optional<NameIndices> match_name(std::string_view name, std::string_view pattern) {
  NameIndices indices;
  std::size_t position = 0;
  while (!pattern.empty()) {
    std::size_t const bracket = pattern.find('[');
    std::string_view const fixed =
        pattern.substr(0, bracket == std::string_view::npos ? bracket : bracket + 1);
    if (name.size() < fixed.size() || !ascii::equal_ignoring_case(name.substr(0, fixed.size()), fixed)) {
      return std::nullopt;
    }
    name.remove_prefix(fixed.size());
    pattern.remove_prefix(fixed.size());
    if (bracket == std::string_view::npos) break;
    std::uint32_t& index = indices.index.at(position++);
    auto const [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
    if (error != std::errc{}) return std::nullopt;
    name.remove_prefix(static_cast<std::size_t>(end - name.data()));
  }
  return name.empty() ? std::optional(indices) : std::nullopt;
}

std::optional<std::uint32_t> as_number(LocatedText const& value) {
  std::uint32_t number = 0;
  char const* const end = value.text.data() + value.text.size();
  auto const [stop, error] = std::from_chars(value.text.data(), end, number);
  return error == std::errc{} && stop == end ? std::optional(number) : std::nullopt;
}

std::optional<ListCount> as_count(ListedValue const& listed) {
  auto const number = as_number(listed.value);
  if (!number) return std::nullopt;
  return ListCount{.number = *number, .place = listed.value.place};
}

}  // namespace axisc::configuration
