#include "axisc/answers/explain/named_subject.hpp"

#include "axisc/asked/finding_codes.hpp"
#include "axisc/asked/quantities.hpp"
#include "configuration/list_kind.hpp"
#include "diagnostics/ascii.hpp"

namespace axisc {

namespace {

schema::Parameter const* row_of_name(schema::Catalogue const& catalogue, std::string const& word) {
  for (auto const& parameter : catalogue.parameters()) {
    if (parameter.name == word) return &parameter;
  }
  return catalogue.find(word).row;
}

/// "50663" is in "50663/60311/70451".
bool foretells(validator::Rule const& rule, std::string_view number) {
  return ("/" + std::string(rule.control) + "/").find("/" + std::string(number) + "/") != std::string::npos;
}

}  // namespace

validator::Rule const* rule_named(std::string const& word) {
  auto const code = find_code(word);
  auto const by_number = code ? code : find_code("AX" + word);
  return by_number ? validator::find_rule(*by_number) : nullptr;
}

std::vector<schema::Parameter const*> rows_of_number(std::span<schema::Catalogue const> catalogues,
                                                     std::string const& word) {
  auto const text = ascii::upper_case(word);
  std::vector<schema::Parameter const*> rows;
  for (auto const& catalogue : catalogues) {
    auto const prefix = configuration::number_prefix(catalogue.kind()) + "-";
    bool const has_prefix = text.starts_with(prefix);
    if (!has_prefix && catalogue.kind() != schema::ListKind::axis) continue;
    auto const number = parse_count(std::string_view(text).substr(has_prefix ? prefix.size() : 0));
    if (!number || *number > 0xFFFFU) continue;
    for (auto const id : catalogue.find_number(static_cast<std::uint16_t>(*number))) {
      rows.push_back(&catalogue.parameter(id));
    }
  }
  return rows;
}

std::vector<schema::Parameter const*> rows_of_name(std::span<schema::Catalogue const> catalogues,
                                                   std::string const& word) {
  std::vector<schema::Parameter const*> rows;
  for (auto const& catalogue : catalogues) {
    if (auto const* const row = row_of_name(catalogue, word)) rows.push_back(row);
    if (!rows.empty() && catalogue.kind() == schema::ListKind::axis) break;
  }
  return rows;
}

std::vector<validator::Rule const*> rules_foretelling(std::string_view number) {
  std::vector<validator::Rule const*> rules;
  for (auto const& rule : validator::rules()) {
    if (foretells(rule, number)) rules.push_back(&rule);
  }
  return rules;
}

schema::Topic const* topic_named(std::string_view text) {
  auto const named = ascii::trimmed(text);
  if (auto const* const topic = schema::find_topic(named)) return topic;
  for (auto const& topic : schema::topics()) {
    auto const& name = topic.name;
    bool const is_command = name.starts_with('#') && named.size() > name.size() &&
                            ascii::equal_ignoring_case(named.substr(0, name.size()), name) &&
                            !ascii::is_letter(named[name.size()]);
    if (is_command) return &topic;
  }
  return nullptr;
}

}  // namespace axisc
