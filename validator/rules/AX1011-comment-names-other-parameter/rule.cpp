#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"

#include <charconv>
#include <optional>

namespace axisc::validator::checks::ax1011::says {

constexpr Sentence headline{"the comment names {named}, but `{parameter}` is {own}",
                            "der Kommentar nennt {named}, `{parameter}` ist aber {own}"};
constexpr Sentence note{"{named} is `{name}`", "{named} ist `{name}`"};
constexpr Sentence help{"correct the comment, or the name if the comment is right",
                        "den Kommentar berichtigen, oder den Namen, wenn der Kommentar stimmt"};

}  // namespace axisc::validator::checks::ax1011::says

namespace axisc::validator::checks::ax1011 {
namespace {

struct Mention {
  std::uint32_t number = 0;
  Span span;
};

std::optional<Mention> next_mention(std::string_view text, std::string_view prefix, std::size_t from) {
  for (std::size_t at = text.find(prefix, from); at != std::string_view::npos;
       at = text.find(prefix, at + 1)) {
    Mention mention;
    char const* const digits = text.data() + at + prefix.size();
    auto const [end, error] = std::from_chars(digits, text.data() + text.size(), mention.number);
    if (end == digits || error != std::errc{}) continue;
    mention.span = {.begin = static_cast<std::uint32_t>(at),
                    .end = static_cast<std::uint32_t>(end - text.data())};
    return mention;
  }
  return std::nullopt;
}

/// The first number of the list's own kind in the comment of a line; none if its own is among them, or if the
/// comment has none.
std::optional<Mention> other_parameter(Line const& line) {
  Span const trailer = line.assignment().trailer;
  if (trailer.empty()) return std::nullopt;
  LineValue const line_value = line.context.list.line_values[line.number];
  if (!line_value.row_known() || line_value.row->p_axis == 0) return std::nullopt;
  std::string_view const text = line.context.source.slice(trailer);
  std::string const prefix = configuration::number_prefix(line_value.row->kind) + "-";
  std::optional<Mention> first = next_mention(text, prefix, 0);
  for (std::optional<Mention> mention = first; mention;
       mention = next_mention(text, prefix, mention->span.end)) {
    if (mention->number == line_value.row->p_axis) return std::nullopt;
  }
  if (first) {
    first->span.begin += trailer.begin;
    first->span.end += trailer.begin;
  }
  return first;
}

std::string own_number(Line const& line) {
  schema::Parameter const& row = *line.context.list.line_values[line.number].row;
  return schema::number_text(row.kind, row.p_axis);
}

void describe(Finding& finding, Line const& line) {
  Mention const first = *other_parameter(line);
  std::string const named = line.text(first.span);
  finding.message =
      message(says::headline, {{"named", named}, {"parameter", line.name()}, {"own", own_number(line)}});
  finding.help.push_back(message(says::help));
  if (first.number > UINT16_MAX) return;
  schema::Catalogue const& catalogue = line.context.list.catalogue;
  for (schema::ParameterId const id : catalogue.find_number(static_cast<std::uint16_t>(first.number))) {
    std::string name(catalogue.parameter(id).name);
    finding.notes.push_back(message(says::note, {{"named", named}, {"name", std::move(name)}}));
  }
}

void comment_names_other_parameter(ListContext const& context, Report& report) {
  if (!context.list.line_values.may_name_numbers()) return;
  for (std::uint32_t number = 0; number < context.list.line_values.size(); ++number) {
    Line const line{context, number};
    if (auto const first = other_parameter(line)) report_line<describe>(report, line, first->span);
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .check = comment_names_other_parameter,
};

}  // namespace axisc::validator::checks::ax1011
