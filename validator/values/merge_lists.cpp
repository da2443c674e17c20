#include "validator/values/merge_lists.hpp"

#include "configuration/machine/machine.hpp"
#include "validator/values/effective_values.hpp"
#include "validator/values/references.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace axisc::validator {
namespace {

/// For most parameters the last line of the last list applies. If a line cannot be used, or has no value of
/// its own, the lines before it matter: then all lines of its parameter are processed in order.
class Merger {
 public:
  Merger(LoadedList const* default_list, LoadedList const& axis_list)
      : lists_{default_list, &axis_list}, values_(default_list, axis_list) {}

  MergedValues merge(std::optional<bool> rotary) && {
    for (LoadedList const* const list : lists_) {
      if (list != nullptr) find_difficult(*list);
    }
    for (LoadedList const* const list : lists_) {
      if (list != nullptr && !difficult_.empty()) go_through(*list);
    }
    std::vector<ReferenceProblem> problems = resolve_references(
        values_, pending_, rotary.value_or(axis_type_of(values_) != machine::AxisType::translatory));
    return {.values = std::move(values_), .reference_problems = std::move(problems)};
  }

 private:
  void find_difficult(LoadedList const& list) {
    for (std::uint32_t const assignment : list.line_values.without_value()) {
      if (auto const slot = list.line_values.slot(assignment)) note_difficult(*slot);
    }
    for (LostAssignment const& lost : list.lost) note_difficult(lost.slot);
  }

  void note_difficult(schema::Slot slot) {
    difficult_.resize(values_.catalogue().slot_count());
    difficult_[static_cast<std::size_t>(slot)] = true;
  }

  void go_through(LoadedList const& list) {
    for (std::size_t i = 0; i < list.line_values.size(); ++i) {
      std::optional<schema::Slot> const slot = list.line_values.slot(i);
      if (slot && difficult_[static_cast<std::size_t>(*slot)]) assign(list, i);
    }
    for (LostAssignment const& lost : list.lost) lose(list, lost);
  }

  void assign(LoadedList const& list, std::size_t assignment) {
    EffectiveValue value = value_of_line(list, assignment);
    LineValue const line_value = list.line_values[assignment];
    pending_.erase(value.slot);
    if (line_value.status == ReadingStatus::reference) pending_[value.slot] = line_value.reference;
    EffectiveValue& entry = values_.edit(value.slot);
    if (line_value.status != ReadingStatus::value) value.value = entry.value;
    entry = value;
  }

  void lose(LoadedList const& list, LostAssignment const& lost) {
    Origin const origin = list.is_default_list ? Origin::default_list : Origin::axis_list;
    EffectiveValue& entry = values_.edit(lost.slot);
    bool const set_here = entry.origin == origin;
    if (set_here && (lost.guessed || entry.line > lost.line)) return;
    pending_.erase(lost.slot);
    entry.unusable = true;
    if (set_here) return;
    entry.origin = origin;
    entry.has_value = false;
    entry.source = list.source;
    entry.name_span = lost.name;
    entry.line = lost.line;
  }

  std::array<LoadedList const*, 2> lists_;  ///< in the order in which they are read
  EffectiveValues values_;
  std::vector<bool> difficult_;  ///< by slot; empty where no slot is
  PendingReferences pending_;
};

}  // namespace

machine::AxisType axis_type_of(EffectiveValues const& values) {
  switch (static_cast<int>(values.at("kenngr.achs_typ").value.number)) {
    case 2: return machine::AxisType::rotary;
    case 4: return machine::AxisType::spindle;
    default: return machine::AxisType::translatory;
  }
}

MergedValues merge_lists(LoadedList const* default_list, LoadedList const& axis_list,
                         std::optional<bool> rotary) {
  return Merger(default_list, axis_list).merge(rotary);
}

}  // namespace axisc::validator
