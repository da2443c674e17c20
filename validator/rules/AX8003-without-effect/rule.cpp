#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/motion_blocks.hpp"

#include <algorithm>
#include <array>

namespace axisc::validator::checks::ax8003::says {

constexpr Sentence with_step{"`{parameter}` has no effect: the slope of the channel is STEP",
                             "`{parameter}` hat keine Wirkung: der Slope des Kanals ist STEP"};
constexpr Sentence without_curvature{
    "`{parameter}` has no effect: P-CHAN-00009 (`corr_v_trans_jerk`) is 0",
    "`{parameter}` hat keine Wirkung: P-CHAN-00009 (`corr_v_trans_jerk`) ist 0"};
constexpr Sentence jerks_count{
    "`{parameter}` has no effect: with P-CHAN-00117 = 2 P-AXIS-00339 and 00340 count instead",
    "`{parameter}` hat keine Wirkung: bei P-CHAN-00117 = 2 gelten stattdessen P-AXIS-00339 und 00340"};
constexpr Sentence weights_count{
    "`{parameter}` has no effect: only with P-CHAN-00117 = 2 it counts instead of P-AXIS-00013 and 00154",
    "`{parameter}` hat keine Wirkung: nur bei P-CHAN-00117 = 2 gilt es anstelle von P-AXIS-00013 und 00154"};
constexpr Sentence too{"neither has `{parameter}`", "ebenso wenig `{parameter}`"};
constexpr Sentence help{"leave it where the channel list is to change; else remove the line",
                        "stehen lassen, wenn sich die Kanalliste noch ändert; sonst die Zeile entfernen"};

}  // namespace axisc::validator::checks::ax8003::says

namespace axisc::validator::checks::ax8003 {
namespace {

constexpr std::string_view a_weight = "getriebe[].dynamik.a_trans_weight";
constexpr std::string_view r_weight = "getriebe[].dynamik.r_trans_weight";
constexpr std::string_view c0 = "getriebe[].dynamik.j_trans_c0";
constexpr std::string_view c1 = "getriebe[].dynamik.j_trans_c1";
constexpr std::array of_other_slopes = {std::string_view("getriebe[].slope_profil.tr_beschl_zu"),
                                        std::string_view("getriebe[].slope_profil.tr_beschl_ab"),
                                        std::string_view("getriebe[].slope_profil.tr_brems_zu"),
                                        std::string_view("getriebe[].slope_profil.tr_brems_ab"),
                                        std::string_view("getriebe[].slope_profil.tr_grenz"),
                                        std::string_view("getriebe[].dynamik.tr_geom"),
                                        r_weight,
                                        c0,
                                        c1,
                                        a_weight};
constexpr std::array weights = {a_weight, r_weight};
constexpr std::array jerks = {c0, c1};

/// One finding at the first of them that a list sets to something else than its default.
void report_unused(LoadedAxis const& axis, std::span<std::string_view const> names, SentenceRef headline,
                   Report& report) {
  std::vector<EffectiveValue const*> unused;
  for (std::string_view const name : names) {
    EffectiveValue const& value = axis.merged.values.at(name);
    if (configured(value) && value.value_place() && !value.unusable) unused.push_back(&value);
  }
  if (unused.empty()) return;
  std::sort(unused.begin(), unused.end(),
            [](EffectiveValue const* a, EffectiveValue const* b) { return stands_before(*a, *b); });
  report.axis = axis.name;
  EffectiveValue const& first = *unused.front();
  Finding& finding = report.add(first, message(headline, {{"parameter", parameter_name(first)}}));
  finding.help.push_back(message(says::help));
  for (EffectiveValue const* const other : std::span(unused).subspan(1)) {
    finding.related.push_back({.place = *other->value_place(),
                               .message = message(says::too, {{"parameter", parameter_name(*other)}})});
  }
}

/// ACC_FACT needs P-AXIS-00013, whatever the slope is.
bool programs_use_factor(GroupContext const& context) {
  return std::any_of(context.group.programs.begin(), context.group.programs.end(), [&](std::size_t index) {
    LoadedProgram const& program = context.whole.machine.programs[index];
    std::string_view const text = context.whole.sources[program.source].bytes();
    return std::any_of(program.tree.commands.begin(), program.tree.commands.end(),
                       [text](grammar::NcCommand const& command) {
                         return find_keyword(command, text, "ACC_FACT") != nullptr;
                       });
  });
}

/// Without a channel list nothing is known, and where programs choose the slope, any may be in force.
void without_effect(GroupContext const& context, Report& report) {
  auto const& dynamics = context.group.dynamics;
  if (!dynamics.is_from_list) return;
  bool const is_step = dynamics.slope == machine::Slope::step && !programs_choose_slope(context);
  for (std::size_t const index : context.group.axes) {
    LoadedAxis const& axis = context.whole.machine.axes[index];
    if (is_step) {
      auto const all = std::span(of_other_slopes);
      report_unused(axis, programs_use_factor(context) ? all.first(all.size() - 1) : all, says::with_step,
                    report);
    } else if (dynamics.transition_mode == 2) {
      report_unused(axis, weights, says::jerks_count, report);
    } else {
      report_unused(axis, jerks, says::weights_count, report);
    }
    if (!is_step && !dynamics.limits_curvature_steps) {
      std::string_view const counting = dynamics.transition_mode == 2 ? c1 : r_weight;
      report_unused(axis, std::span(&counting, 1), says::without_curvature, report);
    }
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters =
        "getriebe[].slope_profil.tr_beschl_zu getriebe[].slope_profil.tr_beschl_ab "
        "getriebe[].slope_profil.tr_brems_zu getriebe[].slope_profil.tr_brems_ab "
        "getriebe[].slope_profil.tr_grenz getriebe[].dynamik.tr_geom "
        "getriebe[].dynamik.a_trans_weight getriebe[].dynamik.r_trans_weight "
        "getriebe[].dynamik.j_trans_c0 getriebe[].dynamik.j_trans_c1",
    .check = without_effect,
};

}  // namespace axisc::validator::checks::ax8003
