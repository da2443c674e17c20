#include "validator/engine/rule_title.hpp"

#include "schema/descriptions/description.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace axisc::validator {

namespace {

/// Rules about what #FILTER commands say.
constexpr std::array<std::uint16_t, 5> command_rules = {5001, 5002, 5006, 5007, 5008};
constexpr Page command_section{"FIR filters, section 5", "FIR-Filter, Abschnitt 5"};

void add(std::vector<Page>& sections, Page const& section) {
  bool const is_known = std::any_of(sections.begin(), sections.end(),
                                    [&](Page const& known) { return known.english == section.english; });
  if (!section.english.empty() && !is_known) sections.push_back(section);
}

}  // namespace

std::vector<Page> manual_sections(Rule const& rule) {
  std::vector<Page> sections;
  auto const code = static_cast<std::uint16_t>(rule.code);
  if (std::find(command_rules.begin(), command_rules.end(), code) != command_rules.end()) {
    add(sections, command_section);
  }
  // A rule about every parameter of a kind is not described anywhere.
  if (rule.about != nullptr) return sections;
  for (auto const& parameter : schema::parameters()) {
    if (looks_at(rule, parameter)) add(sections, schema::manual_section(parameter));
  }
  return sections;
}

}  // namespace axisc::validator
