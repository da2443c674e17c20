#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace axisc::validator {
namespace {

constexpr std::string_view prefix = "P-AXIS-";

struct Mention {
  std::uint32_t number = 0;
  Span span;  ///< within the text that was searched
};

std::optional<Mention> next_mention(std::string_view text, std::size_t from) {
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

}  // namespace

void checks::comment_names_other_parameter(ListContext const& context, Report& report) {
  if (context.source.bytes().find(prefix) == std::string_view::npos) return;
  for_each_reading(context.list, [&](grammar::Assignment const& assignment, Reading const& reading) {
    if (!reading.row_known() || assignment.trailer.empty()) return;
    std::uint16_t const own = reading.row->p_axis;
    std::string_view const trailer = context.source.slice(assignment.trailer);
    std::optional<Mention> const first = next_mention(trailer, 0);
    if (own == 0 || !first) return;
    for (std::optional<Mention> mention = first; mention;
         mention = next_mention(trailer, mention->span.end)) {
      if (mention->number == own) return;
    }
    Span const span{.begin = assignment.trailer.begin + first->span.begin,
                    .end = assignment.trailer.begin + first->span.end};
    std::string const named = context.source.utf8(span);
    Finding& finding = add_at(context, report, assignment, reading, span,
                              message(Text::ax1011, {{"named", named},
                                                     {"parameter", written_name(context, assignment)},
                                                     {"own", schema::p_axis_text(own)}}));
    if (first->number > UINT16_MAX) return;
    for (schema::ParameterId const id :
         context.list.catalogue.find_number(static_cast<std::uint16_t>(first->number))) {
      std::string name(context.list.catalogue.parameter(id).name);
      finding.notes.push_back(message(Text::ax1011_note, {{"named", named}, {"name", std::move(name)}}));
    }
  });
}

}  // namespace axisc::validator
