#include "axisc/answers/difference/machine_difference.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/ascii.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace axisc::says {

constexpr Sentence unknown{"{input} has no axis \"{axis}\"; the axes are {axes}",
                           "{input} hat keine Achse „{axis}“; die Achsen sind {axes}"};
constexpr Sentence ambiguous{"\"{axis}\" may be {axes}; give the number of the axis, or its list",
                             "„{axis}“ kann {axes} sein; die Nummer der Achse oder ihre Liste angeben"};

}  // namespace axisc::says

namespace axisc {

namespace {

using Matches = std::function<bool(ComparedAxis const&)>;

std::vector<ComparedAxis const*> all_of(ComparedMachine const& machine, Matches const& matches) {
  std::vector<ComparedAxis const*> found;
  for (auto const& axis : machine.axes) {
    if (matches(axis)) found.push_back(&axis);
  }
  return found;
}

bool has_name(ComparedAxis const& axis, std::string const& name) {
  return axis.name == name || std::find(axis.called.begin(), axis.called.end(), name) != axis.called.end();
}

bool has_name_in_other_case(ComparedAxis const& axis, std::string const& name) {
  return std::any_of(axis.called.begin(), axis.called.end(),
                     [&](std::string const& called) { return ascii::equal_ignoring_case(called, name); }) ||
         ascii::equal_ignoring_case(axis.name, name);
}

bool has_list(ComparedAxis const& axis, std::string const& name) {
  auto const file = validator::file_name(axis.list);
  return !file.empty() && (axis.list == name || file == name || validator::without_extension(file) == name);
}

/// "X (1, achsmds1.lis)".
std::string description(ComparedAxis const& axis) {
  auto text = axis.name;
  std::string details = axis.number ? std::to_string(*axis.number) : std::string();
  if (!axis.list.empty()) details += (details.empty() ? "" : ", ") + axis.list;
  return details.empty() ? text : text + " (" + details + ")";
}

std::string descriptions(std::vector<ComparedAxis const*> const& axes) {
  std::string text;
  for (auto const* const axis : axes) text += (text.empty() ? "" : ", ") + description(*axis);
  return text;
}

bool is_stripped(ComparedMachine const& machine) {
  return machine.axes.front().values == nullptr;
}

/// Axes by something that only one of them has.
template <class Key>
class OnlyOnes {
 public:
  void add(Key key, ComparedAxis const& axis) {
    auto const [known, is_new] = axes_.try_emplace(std::move(key), &axis);
    if (!is_new) known->second = nullptr;
  }
  /// Null where there is none, or more than one.
  [[nodiscard]] ComparedAxis const* find(Key const& key) const {
    auto const found = axes_.find(key);
    return found == axes_.end() ? nullptr : found->second;
  }

 private:
  std::map<Key, ComparedAxis const*> axes_;
};

OnlyOnes<std::uint32_t> by_number(ComparedMachine const& machine) {
  OnlyOnes<std::uint32_t> numbers;
  for (auto const& axis : machine.axes) {
    if (axis.number) numbers.add(*axis.number, axis);
  }
  return numbers;
}

}  // namespace

ComparedAxis const& axis_called(ComparedMachine const& machine, std::string const& name) {
  Matches const ways[] = {
      [&](ComparedAxis const& axis) { return has_name(axis, name); },
      [&](ComparedAxis const& axis) { return axis.number && std::to_string(*axis.number) == name; },
      [&](ComparedAxis const& axis) { return has_list(axis, name); },
      [&](ComparedAxis const& axis) { return has_name_in_other_case(axis, name); }};
  for (auto const& way : ways) {
    auto const found = all_of(machine, way);
    if (found.size() == 1) return *found.front();
    if (found.size() > 1) {
      throw Failure({says::ambiguous, {{"axis", name}, {"axes", descriptions(found)}}});
    }
  }
  auto const all = all_of(machine, [](ComparedAxis const&) { return true; });
  throw Failure({says::unknown, {{"input", machine.input}, {"axis", name}, {"axes", descriptions(all)}}});
}

std::vector<AxisPair> pair_axes(ComparedMachine const& before, ComparedMachine const& after) {
  std::vector<AxisPair> pairs;
  if (before.axes.size() == after.axes.size() &&
      (before.axes.size() == 1 || is_stripped(before) || is_stripped(after))) {
    for (std::size_t i = 0; i < after.axes.size(); ++i) pairs.emplace_back(&before.axes[i], &after.axes[i]);
    return pairs;
  }
  auto const old_numbers = by_number(before);
  auto const new_numbers = by_number(after);
  std::set<ComparedAxis const*> paired;
  for (auto const& axis : after.axes) {
    bool const is_only_one = axis.number && new_numbers.find(*axis.number) == &axis;
    pairs.emplace_back(is_only_one ? old_numbers.find(*axis.number) : nullptr, &axis);
    if (pairs.back().first != nullptr) paired.insert(pairs.back().first);
  }
  OnlyOnes<std::string_view> old_names;
  for (auto const& axis : before.axes) {
    if (!paired.contains(&axis)) old_names.add(axis.name, axis);
  }
  for (auto& [was, is] : pairs) {
    if (was != nullptr) continue;
    auto const* const named = old_names.find(is->name);
    if (named != nullptr && paired.insert(named).second) was = named;
  }
  for (auto const& axis : before.axes) {
    if (!paired.contains(&axis)) pairs.emplace_back(&axis, nullptr);
  }
  return pairs;
}

}  // namespace axisc
