#include "axisc/answers/contour/cascade_line.hpp"

#include "analysis/motion/contour/contour_predictions.hpp"
#include "axisc/answers/execution/group_chains.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "design/units.hpp"
#include "diagnostics/format_number.hpp"
#include "validator/loading/loader.hpp"

#include <array>
#include <numbers>

namespace axisc::says {

constexpr Sentence cascade_line{"delay {delay} ms, {deviation} mm at a corner at {feed} mm/min",
                                "Verzögerung {delay} ms, {deviation} mm an einer Ecke bei {feed} mm/min"};
constexpr Sentence cascade_not_straight{
    "delay {delay} ms; no corner deviation in mm: the axis is not translatory",
    "Verzögerung {delay} ms; keine Eckenabweichung in mm: die Achse ist nicht translatorisch"};
constexpr Sentence cascade_no_feed{
    "delay {delay} ms; no corner deviation: the axis has no feed limit",
    "Verzögerung {delay} ms; keine Eckenabweichung: die Achse hat keine Vorschubgrenze"};
constexpr Sentence no_figures{"no figures: {machine} has errors, they are among the problems",
                              "keine Werte: {machine} hat Fehler, sie stehen unter den Problemen"};
constexpr Sentence no_channel{"no figures: the axis is in no channel of {machine}",
                              "keine Werte: die Achse ist in keinem Kanal von {machine}"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr int shown_digits = 3;
constexpr double quarter_turn = std::numbers::pi / 2;

/// The corner is between two axes with this chain.
std::string figures_of(motion::ChainAnswer const& answer, machine::AxisConfiguration const& axis,
                       design::CycleTime cycle_time, Language language) {
  std::vector<Argument> arguments{
      {"delay", format_rounded(answer.delay * cycle_time.microseconds() / 1000, shown_digits)}};
  double const feed = axis.velocity_limit * design::mm_per_min_of_um_per_s;
  if (axis.type != machine::AxisType::translatory) {
    return render({says::cascade_not_straight, arguments}, language);
  }
  if (feed <= 0) return render({says::cascade_no_feed, arguments}, language);
  std::array const both = {answer, answer};
  auto const corner = motion::predict_corner(both, path_velocity(feed, cycle_time), quarter_turn);
  arguments.push_back({"deviation", format_rounded(corner.deviation / motion::units_per_mm, shown_digits)});
  arguments.push_back({"feed", format_rounded(feed, shown_digits)});
  return render({says::cascade_line, arguments}, language);
}

}  // namespace

std::string cascade_line(Workspace& workspace, std::string const& path,
                         std::optional<std::string> const& axis, Language language) {
  auto const say = [&](SentenceRef text) {
    return render({text, {{"machine", std::string(validator::file_name(path))}}}, language);
  };
  auto const checked =
      checked_machine(workspace, {.input = path, .alone = true},
                      {.language = language, .take = [](std::vector<Finding> const&, SourceSet const&) {}});
  if (!checked) return say(says::no_figures);
  std::string text;
  auto const& machine = checked->machine;
  for (std::size_t i = 0; i < machine.groups.size(); ++i) {
    auto const& axes = machine.groups[i].axes;
    std::optional<std::vector<motion::ChainAnswer>> answers;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      auto const& member = machine.axes[axes[k]];
      if (axis && member.name != *axis) continue;
      if (!answers) answers = GroupChains(machine, i, filters_on(), path).answers(std::nullopt);
      if (!text.empty()) text += "; ";
      if (!axis) text += member.name + ": ";
      text += figures_of((*answers)[k], member, machine.cycle_time, language);
    }
  }
  return text.empty() ? say(says::no_channel) : text;
}

}  // namespace axisc
