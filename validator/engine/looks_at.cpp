#include "validator/engine/rule.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace axisc::validator {
namespace {

struct Family {
  std::string_view word;
  std::string_view beginning;
};

constexpr std::array families{Family{.word = "filters[].", .beginning = "filter[]."},
                              Family{.word = "filters[].", .beginning = "lr_param.add_interface.filter[]."},
                              Family{.word = "ipc.", .beginning = "lr_param.improved_position_control."},
                              Family{.word = "", .beginning = ""}};

bool fits(std::string_view pattern, std::string_view name) {
  if (!pattern.ends_with('*')) return name == pattern;
  pattern.remove_suffix(1);
  return name.starts_with(pattern);
}

bool names(std::string_view word, std::string_view name) {
  return std::any_of(families.begin(), families.end(), [&](Family const& family) {
    return word.starts_with(family.word) && name.starts_with(family.beginning) &&
           fits(word.substr(family.word.size()), name.substr(family.beginning.size()));
  });
}

}  // namespace

bool looks_at(Rule const& rule, schema::Parameter const& parameter) {
  if (rule.about != nullptr && rule.about(parameter)) return true;
  for (std::string_view rest = rule.parameters; !rest.empty();) {
    auto const end = std::min(rest.find(' '), rest.size());
    if (names(rest.substr(0, end), parameter.name)) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

}  // namespace axisc::validator
