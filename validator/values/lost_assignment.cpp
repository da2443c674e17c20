#include "validator/values/lost_assignment.hpp"

#include "diagnostics/ascii.hpp"
#include "grammar/character_class.hpp"
#include "schema/edit_distance.hpp"
#include "schema/name_candidates.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::validator {
namespace {

bool is_name_character(char c) {
  return c == '.' || grammar::is(grammar::character::letter | grammar::character::digit, c);
}

/// Sets `name` to the name on the line, with every index completed: `filter[0.order` and `filter[ 0 ].order`
/// are filter[0].order; an index without number is 0.
void read_with_whole_indices(std::string_view line, std::string& name) {
  name.clear();
  while (true) {
    auto const* const end =
        std::find_if_not(line.begin(), line.end(), [](char c) { return is_name_character(c); });
    name.append(line.begin(), end);
    line.remove_prefix(static_cast<std::size_t>(end - line.begin()));
    if (!line.starts_with('[')) return;

    std::string_view const index = line.substr(0, line.find_first_of(".]"));
    line.remove_prefix(index.size());
    name += '[';
    if (std::none_of(index.begin(), index.end(), ascii::is_digit)) name += '0';
    std::copy_if(index.begin(), index.end(), std::back_inserter(name), ascii::is_digit);
    name += ']';
    if (line.starts_with(']')) line.remove_prefix(1);
  }
}

bool is_well_formed(std::string_view name) {
  return !name.empty() && name.front() != '.' && name.back() != '.' &&
         name.find("..") == std::string_view::npos;
}

std::optional<schema::Slot> slot_of_name(schema::Catalogue const& catalogue, std::string_view name) {
  using Status = schema::NameLookup::Status;
  if (!is_well_formed(name)) return std::nullopt;
  if (schema::ConcreteParameter const exact = catalogue.find_exact(name)) return exact.slot;
  schema::NameLookup const lookup = catalogue.find(name);
  switch (lookup.status) {
    case Status::found: return lookup.slot;
    case Status::index_missing:
    case Status::index_superfluous: return schema::slot_of(*lookup.row);
    case Status::unknown:
    case Status::index_out_of_range: break;
  }
  return std::nullopt;
}

}  // namespace

std::vector<LostAssignment> lost_assignments(SourceText const& source, grammar::AxisList const& list,
                                             LineValues const& line_values,
                                             schema::Catalogue const& catalogue) {
  using grammar::ProblemKind;
  std::vector<LostAssignment> lost;
  std::string name;
  for (grammar::Problem const& problem : list.problems) {
    if (problem.kind == ProblemKind::text_after_end) continue;
    Span line = source.line_span(problem.line);
    std::string_view const text = source.slice(line);
    std::size_t const blanks = text.find_first_not_of(" \t");
    if (blanks == std::string_view::npos) continue;
    line.begin += static_cast<std::uint32_t>(blanks);
    read_with_whole_indices(source.slice(line), name);
    line.end = std::min(line.end, line.begin + static_cast<std::uint32_t>(name.size()));
    if (auto const slot = slot_of_name(catalogue, name)) {
      lost.push_back({.slot = *slot, .name = line, .line = problem.line, .guessed = false});
    }
  }
  for (std::uint32_t const i : line_values.doubtful()) {
    LineValue const& line_value = line_values.closer(i);
    grammar::Assignment const& assignment = list.assignments[i];
    std::optional<schema::Slot> slot;
    if (!line_value.row_known()) {
      // `filter [0].order 2`
      std::string const joined =
          std::string(source.slice(assignment.name)) + std::string(source.slice(assignment.value));
      if (source.slice(assignment.value).starts_with('[')) slot = slot_of_name(catalogue, joined);
      auto const& suggested = line_values.suggestions(i);
      if (suggested.is_close) slot = slot_of_name(catalogue, suggested.names.front());
    } else if (!line_value.known()) {
      slot = slot_of_name(catalogue, source.slice(assignment.name));
    }
    if (slot) {
      lost.push_back({.slot = *slot, .name = assignment.name, .line = assignment.line, .guessed = true});
    }
  }
  return lost;
}

namespace {

constexpr std::array<std::string_view, 5> compiled_families = {
    "filter", "filter_fir", "vib_guard", "lr_param.add_interface", "lr_param.improved_position_control"};

/// As many parts of a name as the family has, up to the first index.
std::string_view beginning_of(std::string_view name, std::string_view family) {
  auto dots = std::count(family.begin(), family.end(), '.');
  auto const ends = [&dots](char byte) { return byte == '[' || (byte == '.' && dots-- == 0); };
  auto const length = std::find_if(name.begin(), name.end(), ends) - name.begin();
  return name.substr(0, static_cast<std::size_t>(length));
}

}  // namespace

bool is_compiled_family(std::string_view name) {
  return std::any_of(compiled_families.begin(), compiled_families.end(),
                     [name](std::string_view family) { return beginning_of(name, family) == family; });
}

bool is_close_to_compiled_family(std::string_view name) {
  return std::any_of(compiled_families.begin(), compiled_families.end(), [name](std::string_view family) {
    std::size_t const limit = schema::slips_of_the_pen(family.size());
    std::string_view const beginning = beginning_of(name, family);
    bool const is_as_long =
        beginning.size() <= family.size() + limit && family.size() <= beginning.size() + limit;
    if (!is_as_long) return false;
    std::string const written = ascii::lower_case(beginning);
    std::size_t const middle = written.find('_');
    bool const is_swapped =
        middle != std::string::npos && written.substr(middle + 1) + "_" + written.substr(0, middle) == family;
    return is_swapped || schema::edit_distance(written, family, limit) <= limit;
  });
}

}  // namespace axisc::validator
