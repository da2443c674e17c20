#include "validator/views/position_control_view.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace axisc::validator {
namespace {

enum class StageMember : std::uint8_t {
  mode,
  numerator,
  denominator,
  older_damping,
  newer_damping,
  older_order,
  older_frequency,
  older_quality,
  type,
  prototype,
  order,
  frequency,
  quality,
};

struct MemberRow {
  std::string_view name;
  bool per_filter;  ///< filter[k].x
};

constexpr std::array<MemberRow, 13> members = {{
    {.name = "mode", .per_filter = false},
    {.name = "weight_fact_num", .per_filter = false},
    {.name = "weight_fact_denom", .per_filter = false},
    {.name = "filter.damping", .per_filter = false},
    {.name = "osc_damping", .per_filter = false},
    {.name = "filter.order", .per_filter = false},
    {.name = "filter.fg_f0", .per_filter = false},
    {.name = "filter.q_factor", .per_filter = false},
    {.name = "filter[].type", .per_filter = true},
    {.name = "filter[].prototype", .per_filter = true},
    {.name = "filter[].order", .per_filter = true},
    {.name = "filter[].fg_f0", .per_filter = true},
    {.name = "filter[].q_factor", .per_filter = true},
}};

using StageFilterSlots = std::array<schema::Slot, filters_per_stage>;
using StageSlots = std::array<std::array<StageFilterSlots, members.size()>, position_control_stages>;

StageSlots look_up_stage_slots() {
  StageSlots slots{};
  for (std::size_t member = 0; member < members.size(); ++member) {
    std::string pattern("lr_param.improved_position_control.stage[].");
    pattern.append(members[member].name);
    schema::Parameter const& row = row_at(pattern);
    for (std::uint32_t stage = 0; stage < slots.size(); ++stage) {
      for (std::uint32_t filter = 0; filter < filters_per_stage; ++filter) {
        slots[stage][member][filter] = schema::slot_of(row, stage, members[member].per_filter ? filter : 0);
      }
    }
  }
  return slots;
}

/// Views are made by the thousand; the names are looked up once.
StageSlots const& stage_slots() {
  static StageSlots const slots = look_up_stage_slots();
  return slots;
}

EffectiveValue const& stage_value(EffectiveValues const& values, std::uint32_t stage, StageMember member,
                                  std::uint32_t filter = 0) {
  return values[stage_slots()[stage][static_cast<std::size_t>(member)][filter]];
}

bool is_any_set(EffectiveValues const& values) {
  for (auto const& stage : stage_slots()) {
    for (std::size_t member = 0; member < members.size(); ++member) {
      std::size_t const count = members[member].per_filter ? filters_per_stage : 1;
      for (std::size_t filter = 0; filter < count; ++filter) {
        if (values.is_set(stage[member][filter])) return true;
      }
    }
  }
  return false;
}

StageFilterType kind_of(EffectiveValue const& type, std::uint32_t filter) {
  // The documented defaults differ: the first filter is a band-pass, the second is none.
  if (!type.set() || type.unusable) return filter == 0 ? StageFilterType::bandpass : StageFilterType::none;
  if (type.value.text == "NO_FILTER") return StageFilterType::none;
  return type.value.text == "ALLPASS" ? StageFilterType::allpass : StageFilterType::bandpass;
}

StageFilterView older_filter(EffectiveValues const& values, std::uint32_t stage) {
  return {.type = nullptr,
          .prototype = nullptr,
          .order = stage_value(values, stage, StageMember::older_order),
          .frequency = stage_value(values, stage, StageMember::older_frequency),
          .quality = stage_value(values, stage, StageMember::older_quality),
          .kind = StageFilterType::bandpass};
}

StageFilterView newer_filter(EffectiveValues const& values, std::uint32_t stage, std::uint32_t filter) {
  EffectiveValue const& type = stage_value(values, stage, StageMember::type, filter);
  return {.type = &type,
          .prototype = &stage_value(values, stage, StageMember::prototype, filter),
          .order = stage_value(values, stage, StageMember::order, filter),
          .frequency = stage_value(values, stage, StageMember::frequency, filter),
          .quality = stage_value(values, stage, StageMember::quality, filter),
          .kind = kind_of(type, filter)};
}

}  // namespace

StageView::StageView(EffectiveValues const& values, std::uint32_t index_)
    : index(index_),
      mode(stage_value(values, index_, StageMember::mode)),
      weight_numerator(stage_value(values, index_, StageMember::numerator)),
      weight_denominator(stage_value(values, index_, StageMember::denominator)),
      older_damping(stage_value(values, index_, StageMember::older_damping)),
      newer_damping(stage_value(values, index_, StageMember::newer_damping)),
      older(older_filter(values, index_)),
      newer{newer_filter(values, index_, 0), newer_filter(values, index_, 1)} {}

std::optional<machine::StageMode> StageView::active_mode() const {
  double const number = mode.value.number;
  if (mode.unusable || number < 1 || number > 3) return std::nullopt;
  return static_cast<machine::StageMode>(static_cast<int>(number));
}

bool StageView::simulates() const {
  auto const active = active_mode();
  return active && *active != machine::StageMode::direct;
}

bool StageView::uses_newer_filters() const {
  return std::any_of(newer.begin(), newer.end(), [](StageFilterView const& filter) {
    return filter.type->set() || filter.prototype->set() || configured(filter.order) ||
           configured(filter.frequency) || configured(filter.quality);
  });
}

std::vector<StageFilterView> StageView::filters() const {
  if (!uses_newer_filters()) return {older};
  std::vector<StageFilterView> working;
  for (StageFilterView const& filter : newer) {
    if (filter.kind != StageFilterType::none) working.push_back(filter);
  }
  return working;
}

std::optional<StageFilterView> StageView::bandpass() const {
  for (StageFilterView const& filter : filters()) {
    if (filter.kind == StageFilterType::bandpass) return filter;
  }
  return std::nullopt;
}

EffectiveValue const& StageView::damping() const {
  bool const is_newer = configured(newer_damping) || newer_damping.unusable ||
                        (uses_newer_filters() && !configured(older_damping));
  return is_newer ? newer_damping : older_damping;
}

PositionControlView::PositionControlView(EffectiveValues const& values)
    : enable(values.at("lr_param.improved_position_control.enable")),
      limit(values.at("lr_param.improved_position_control.v_add_max_fact")) {
  if (!enabled() && !enable.set() && !is_any_set(values)) return;
  stages.reserve(position_control_stages);
  for (std::uint32_t stage = 0; stage < position_control_stages; ++stage) stages.emplace_back(values, stage);
}

std::vector<StageView> PositionControlView::active_stages() const {
  std::vector<StageView> active;
  if (!enabled()) return active;
  for (StageView const& stage : stages) {
    if (stage.active_mode()) active.push_back(stage);
  }
  return active;
}

}  // namespace axisc::validator
