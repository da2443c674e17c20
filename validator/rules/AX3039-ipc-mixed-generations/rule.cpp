#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/position_control_words.hpp"
#include "validator/views/position_control_view.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax3039::says {

constexpr Sentence headline{"stage {stage} mixes the older and the newer spelling",
                            "Stufe {stage} mischt die ältere und die neuere Schreibweise"};
constexpr Sentence older{"older spelling: `filter.…`, `filter.damping`",
                         "ältere Schreibweise: `filter.…`, `filter.damping`"};
constexpr Sentence newer{"newer spelling: `filter[k].…`, `osc_damping`",
                         "neuere Schreibweise: `filter[k].…`, `osc_damping`"};
constexpr Sentence help{"keep one of them in each stage; the newer one needs build V3.1.3132.0",
                        "in jeder Stufe eine davon behalten; die neuere braucht den Stand V3.1.3132.0"};

}  // namespace axisc::validator::checks::ax3039::says

namespace axisc::validator::checks::ax3039 {
namespace {

void add_configured(SetValues& values, std::initializer_list<EffectiveValue const*> candidates) {
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(values),
               [](EffectiveValue const* value) { return configured(*value) && value->value_place(); });
}

/// The settings of one feature of a stage, in the older and in the newer spelling.
struct Mixture {
  SetValues older;
  SetValues newer;
  [[nodiscard]] bool mixed() const { return !older.empty() && !newer.empty(); }
};

Mixture mixture_of(StageView const& stage) {
  Mixture filters;
  add_configured(filters.older,
                 {&stage.older.order, &stage.older.frequency, &stage.older.quality, &stage.older_damping});
  for (StageFilterView const& filter : stage.newer) {
    if (filter.type->set() && filter.type->value_place()) filters.newer.push_back(filter.type);
    add_configured(filters.newer, {&filter.order, &filter.frequency, &filter.quality});
  }
  Mixture damping;
  add_configured(damping.older, {&stage.older_damping});
  add_configured(damping.newer, {&stage.newer_damping});
  if (!filters.mixed()) return damping;
  if (damping.mixed()) filters.newer.push_back(&stage.newer_damping);
  return filters;
}

void ipc_mixed_generations(AxisContext const& axis, Report& report) {
  for (StageView const& stage : axis.position_control.stages) {
    Mixture const mixture = mixture_of(stage);
    if (!mixture.mixed()) continue;
    EffectiveValue const& older = *last_of(mixture.older);
    EffectiveValue const& newer = *last_of(mixture.newer);
    bool const newer_last = *older.value_place() < *newer.value_place();
    EffectiveValue const& last = newer_last ? newer : older;
    EffectiveValue const& first = newer_last ? older : newer;
    Finding& finding = report.add(last, {says::headline, {{"stage", number(stage.index)}}});
    finding.label = Message{newer_last ? says::newer : says::older, {}};
    finding.related.push_back({*first.value_place(), {newer_last ? says::older : says::newer, {}}});
    finding.help.push_back({says::help, {}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .parameters = "ipc.stage[].filter.* ipc.stage[].filter[].* ipc.stage[].osc_damping",
    .check = ipc_mixed_generations,
};

}  // namespace axisc::validator::checks::ax3039
