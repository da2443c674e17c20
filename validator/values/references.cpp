#include "validator/values/references.hpp"

#include <algorithm>
#include <string_view>
#include <tuple>

namespace axisc::validator {
namespace {

using schema::Slot;

struct Target {
  std::optional<Slot> slot;
  ReferenceTrouble trouble = ReferenceTrouble::unresolvable;  ///< if there is no slot
};

/// Several names may share one number: the one that a list sets is used, else the first.
Target find_target(Reference const& reference, EffectiveValues const& values) {
  Target target;
  if (reference.p_axis == 0 || reference.p_axis > UINT16_MAX) return target;
  schema::Catalogue const& catalogue = values.catalogue();
  for (schema::ParameterId const id : catalogue.find_number(static_cast<std::uint16_t>(reference.p_axis))) {
    schema::Parameter const& row = catalogue.parameter(id);
    std::uint32_t const entries = std::max<std::uint32_t>(row.array[0], 1);
    if (reference.index >= entries) {
      target.trouble = ReferenceTrouble::wrong_index;
      continue;
    }
    Slot const slot = schema::slot_of(row, reference.index);
    if (values[slot].set()) return {.slot = slot};
    if (!target.slot) target.slot = slot;
  }
  return target;
}

/// A documented default that is itself a reference: the default of that parameter.
std::optional<schema::Value> value_of_default(Slot slot, EffectiveValues const& values) {
  schema::Parameter const& row = values.row(slot);
  if (auto value = schema::default_value(row)) return value;
  std::uint16_t const number = schema::default_reference(row);
  if (number == 0) return std::nullopt;
  Target const target = find_target({.p_axis = number, .index = schema::indices_of(row, slot)[0]}, values);
  if (!target.slot || values[*target.slot].unusable) return std::nullopt;
  return values[*target.slot].value;
}

/// Whether the control can use a value of `from` for `to`.
bool types_agree(schema::Parameter const& to, schema::Parameter const& from, schema::Value const& value) {
  if (schema::is_number(to.type)) {
    return schema::is_number(from.type) &&
           (to.type == schema::DataType::real64 || from.type != schema::DataType::real64);
  }
  if (to.type == schema::DataType::boolean) return from.type == schema::DataType::boolean;
  if (from.type != schema::DataType::string || to.is_enumeration() != from.is_enumeration()) return false;
  return !to.is_enumeration() || schema::read_symbol(to, value.text).symbol != nullptr;
}

class Resolver {
 public:
  Resolver(EffectiveValues& values, PendingReferences const& pending, bool rotary)
      : values_(values), pending_(pending), rotary_(rotary) {}

  std::vector<ReferenceProblem> resolve_all() {
    // In the order of their lines.
    std::vector<Slot> slots;
    slots.reserve(pending_.size());
    for (auto const& [slot, reference] : pending_) slots.push_back(slot);
    std::sort(slots.begin(), slots.end(),
              [this](Slot a, Slot b) { return stands_before(values_[a], values_[b]); });
    for (Slot const slot : slots) {
      if (!states_.contains(slot)) follow(slot);
    }
    return std::move(problems_);
  }

 private:
  enum class State : std::uint8_t { visiting, done };

  void follow(Slot slot) {
    std::vector<Slot> path;
    while (pending_.contains(slot) && !states_.contains(slot)) {
      states_[slot] = State::visiting;
      path.push_back(slot);
      Target const target = find_target(pending_.at(slot), values_);
      if (!target.slot) {
        report(slot, target.trouble);
        return spoil(path);
      }
      targets_[slot] = *target.slot;
      slot = *target.slot;
    }
    auto const visiting = states_.find(slot);
    if (visiting != states_.end() && visiting->second == State::visiting) {
      report_circle({std::find(path.begin(), path.end(), slot), path.end()});
      return spoil(path);
    }
    std::reverse(path.begin(), path.end());
    for (Slot const member : path) {
      take_over(member, targets_[member]);
      states_[member] = State::done;
    }
  }

  void take_over(Slot slot, Slot target) {
    EffectiveValue const& source = values_[target];
    if (source.unusable) return make_unusable(slot);
    std::optional<schema::Value> value = source.value;
    if (!source.set()) value = value_of_default(target, values_);
    if (!value) return fail(slot, ReferenceTrouble::unresolvable);
    schema::Parameter const& to = values_.row(slot);
    schema::Parameter const& from = values_.row(target);
    if (!types_agree(to, from, *value)) return fail(slot, ReferenceTrouble::wrong_type);
    if (schema::is_integer(to.type)) {
      schema::DataRange const range = schema::data_range(to.type);
      if (value->number < range.lowest || value->number > range.highest) {
        fail(slot, ReferenceTrouble::out_of_data_range);
        problems_.back().number = value->number;
        return;
      }
    }
    std::string_view const unit = rotary_ ? to.unit_rotary : to.unit_translatory;
    std::string_view const other = rotary_ ? from.unit_rotary : from.unit_translatory;
    if (!unit.empty() && !other.empty() && unit != other) report(slot, ReferenceTrouble::other_unit);
    values_.refer(slot, target, *value);
  }

  void fail(Slot slot, ReferenceTrouble trouble) {
    report(slot, trouble);
    make_unusable(slot);
  }

  void make_unusable(Slot slot) { values_.edit(slot).unusable = true; }

  void spoil(std::vector<Slot> const& path) {
    for (Slot const slot : path) {
      make_unusable(slot);
      states_[slot] = State::done;
    }
  }

  void report(Slot slot, ReferenceTrouble trouble) {
    ReferenceProblem& problem = problems_.emplace_back();
    problem.trouble = trouble;
    problem.slot = slot;
    problem.p_axis = pending_.at(slot).p_axis;
    problem.index = pending_.at(slot).index;
    auto const target = targets_.find(slot);
    if (target != targets_.end()) problem.target = target->second;
  }

  /// Once, at the last of the lines.
  void report_circle(std::vector<Slot> circle) {
    std::sort(circle.begin(), circle.end(), [this](Slot left, Slot right) {
      EffectiveValue const& a = values_[left];
      EffectiveValue const& b = values_[right];
      return std::tie(a.origin, a.line) < std::tie(b.origin, b.line);
    });
    report(circle.back(), ReferenceTrouble::circular);
    circle.pop_back();
    problems_.back().circle = std::move(circle);
  }

  EffectiveValues& values_;
  PendingReferences const& pending_;
  bool rotary_;
  std::unordered_map<Slot, State> states_;
  std::unordered_map<Slot, Slot> targets_;
  std::vector<ReferenceProblem> problems_;
};

}  // namespace

std::vector<ReferenceProblem> resolve_references(EffectiveValues& values, PendingReferences const& pending,
                                                 bool rotary) {
  if (pending.empty()) return {};
  return Resolver(values, pending, rotary).resolve_all();
}

}  // namespace axisc::validator
