#include "validator/effective_values.hpp"
#include "validator/machine.hpp"
#include "validator/references.hpp"

#include <utility>
#include <vector>

namespace axisc::validator {
namespace {

class Merger {
 public:
  explicit Merger(schema::Catalogue catalogue) : values_(std::move(catalogue)) {}

  void add(LoadedList const& list) {
    list_ = &list;
    origin_ = list.is_default_list ? Origin::default_list : Origin::axis_list;
    values_.expect(list.readings.size());
    for (std::size_t i = 0; i < list.readings.size(); ++i) {
      if (list.readings[i].known()) assign(list.tree.assignments[i], list.readings[i]);
    }
    for (LostAssignment const& lost : list.lost) lose(lost);
  }

  MergedValues finish(std::optional<bool> rotary) {
    std::vector<ReferenceProblem> problems = resolve_references(
        values_, pending_, rotary.value_or(axis_type_of(values_) != AxisType::translatory));
    values_.order_set_values();
    return {.values = std::move(values_), .reference_problems = std::move(problems)};
  }

 private:
  void assign(grammar::Assignment const& assignment, Reading const& reading) {
    if (!pending_.empty()) pending_.erase(reading.slot);
    if (reading.status == ReadingStatus::value) {
      EffectiveValue& entry = values_.replace(reading.slot, *reading.row);
      entry.value = reading.value;
      entry.unusable = false;
      place(entry, assignment);
    } else {
      EffectiveValue& entry = values_.edit(reading.slot);
      entry.unusable = !reading.usable();
      place(entry, assignment);
      if (reading.status == ReadingStatus::reference) pending_[reading.slot] = reading.reference;
    }
  }

  void place(EffectiveValue& entry, grammar::Assignment const& assignment) const {
    entry.origin = origin_;
    entry.source = list_->source;
    entry.value_span = assignment.value;
    entry.name_span = assignment.name;
    entry.has_value = true;
    entry.line = assignment.line;
  }

  void lose(LostAssignment const& lost) {
    EffectiveValue const* const current = values_.find_set(lost.slot);
    bool const set_here = current != nullptr && current->origin == origin_;
    if (set_here && (lost.guessed || current->line > lost.line)) return;
    EffectiveValue& entry = values_.edit(lost.slot);
    pending_.erase(lost.slot);
    entry.unusable = true;
    if (set_here) return;
    entry.origin = origin_;
    entry.has_value = false;
    entry.source = list_->source;
    entry.name_span = lost.name;
    entry.line = lost.line;
  }

  LoadedList const* list_ = nullptr;
  Origin origin_ = Origin::axis_list;
  EffectiveValues values_;
  PendingReferences pending_;
};

}  // namespace

AxisType axis_type_of(EffectiveValues const& values) {
  switch (static_cast<int>(values.at("kenngr.achs_typ").value.number)) {
    case 2:
      return AxisType::rotary;
    case 4:
      return AxisType::spindle;
    default:
      return AxisType::translatory;
  }
}

MergedValues merge_lists(LoadedList const* default_list, LoadedList const& axis_list,
                         std::optional<bool> rotary) {
  Merger merger(axis_list.catalogue);
  if (default_list != nullptr) merger.add(*default_list);
  merger.add(axis_list);
  return merger.finish(rotary);
}

}  // namespace axisc::validator
