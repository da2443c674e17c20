#include "axisc/answers/explain/explain_parts.hpp"
#include "axisc/answers/explain/explain_subject.hpp"
#include "axisc/answers/explain/parameter_ranges.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/ascii.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence named_topic{"{name}: {title}", "{name}: {title}"};
constexpr Sentence topic_range{"range", "Wertebereich"};
constexpr Sentence see{"See also, with `axisc explain`:", "Siehe auch, mit `axisc explain`:"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

/// Parameters of the filters `filter[]` that a type uses, with what they may be.
Table ranges_of_type(std::string_view type, schema::Catalogue const& catalogue) {
  Table table{.key = "ranges"};
  for (auto const& parameter : catalogue.parameters()) {
    if (!parameter.name.starts_with("filter[].")) continue;
    for (auto const& [types, range] : ranges_by_type(parameter)) {
      if (std::find(types.begin(), types.end(), type) == types.end()) continue;
      add_row(table, {{"parameter", labels::parameter, parameter.name}, {"range", says::topic_range, range}});
    }
  }
  return table;
}

}  // namespace

Section topic_section(schema::Topic const& topic, std::span<schema::Catalogue const> catalogues) {
  bool const is_name = ascii::is_capital(topic.name.front()) || topic.name.front() == '#';
  auto const title = as_given(Wording(topic.title));
  Names names;
  std::vector<Subject> subjects;
  for (auto const name : topic.see) {
    names.emplace_back(name);
    if (auto const subject = subject_named(catalogues, name)) subjects.push_back(*subject);
  }
  auto see = subjects_table({}, subjects);
  see.audience = Audience::people;
  Section section{
      .key = {},
      .title = is_name ? Words(says::named_topic, {{"name", topic.name}, {"title", title}}) : title,
      .blocks = {Prose{.key = "page", .markdown = Wording(topic.page)}},
      .identity = {data("name", topic.name), data("title", title)}};
  auto ranges = ranges_of_type(topic.name, catalogues.front());
  section.blocks.emplace_back(std::move(ranges));
  section.blocks.emplace_back(Facts{{data("see", std::move(names))}});
  section.blocks.emplace_back(Paragraph{says::see});
  section.blocks.emplace_back(std::move(see));
  return section;
}

}  // namespace axisc
