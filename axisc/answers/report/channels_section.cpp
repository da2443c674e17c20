#include "analysis/motion/point.hpp"
#include "axisc/answers/figures/plotted_groups.hpp"
#include "axisc/answers/report/html.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/format_number.hpp"
#include "presentation/pictures/page.hpp"

namespace axisc::says {

constexpr Sentence channel_heading{"Channel {group}", "Kanal {group}"};
constexpr Sentence only_channel{"All axes", "Alle Achsen"};
constexpr Sentence feed_column{"feed [mm/min]", "Vorschub [mm/min]"};
constexpr Sentence corner_column{"corner of {angle}° [µm]", "Ecke von {angle}° [µm]"};
constexpr Sentence circle_column{"circle of {radius} mm [µm]", "Kreis von {radius} mm [µm]"};
constexpr Sentence line_column{"line between axes [µm]", "Gerade zwischen Achsen [µm]"};
constexpr Sentence parallel_column{"there and back [µm]", "hin und zurück [µm]"};
constexpr Sentence filters_are_on{
    "Contour deviation with FIR and HSC filters on, as after #FILTER ON.",
    "Bahnabweichung mit eingeschalteten FIR- und HSC-Filtern, wie nach #FILTER ON."};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr int table_digits = 4;

std::string in_um(double units, Language language) {
  // What is left of nothing by rounding.
  constexpr double nothing = 1e-6;
  return units < nothing ? "0" : format_rounded(units / motion::units_per_um, table_digits).in(language);
}

std::string feed_table(ReportSubject const& subject, std::size_t group) {
  auto const predicted = predict_contour(
      {.machine = *subject.machine, .group = group, .commands = filters_on(), .path = subject.input},
      subject.contour);
  pictures::Table table;
  table.header = {
      subject.say(says::feed_column),
      subject.say(says::corner_column, {{"angle", format_rounded(subject.contour.angle_deg, table_digits)}}),
      subject.say(says::circle_column, {{"radius", format_rounded(subject.contour.radius_mm, table_digits)}}),
      subject.say(says::line_column), subject.say(says::parallel_column)};
  for (auto const& row : predicted.cases) {
    std::vector<std::string> cells{format_rounded(row.feed_mm_per_min, table_digits).in(subject.language)};
    for (double const units :
         {row.corner.deviation, row.circle.deviation, row.line.deviation, row.parallel}) {
      cells.push_back(in_um(units, subject.language));
    }
    table.rows.push_back(std::move(cells));
  }
  return text_of("p", subject.say(says::filters_are_on)) + "\n" + pictures::table_element(table);
}

std::string group_pictures(ReportSubject const& subject, std::size_t group) {
  auto chains = GroupChains(*subject.machine, group, filters_on(), subject.input);
  ContourSubject const contour{.now = chains,
                               .before = nullptr,
                               .cycle_time = subject.machine->cycle_time,
                               .axes = axis_names(subject.plots->contents(), chains.group()),
                               .language = subject.language};
  PlotSubject delays = *subject.plots;
  delays.axes = subject.machine->groups[group].axes;
  return pictures::figure_element(delay_figure(delays), subject.language) +
         pictures::figure_element(corner_figure(contour, subject.contour), subject.language) +
         pictures::figure_element(circle_figure(contour, subject.contour), subject.language);
}

}  // namespace

std::string channels_section(ReportSubject const& subject) {
  if (!subject.plots || subject.machine == nullptr) return {};
  std::string text;
  for (std::size_t i = 0; i < subject.machine->groups.size(); ++i) {
    auto const& group = subject.machine->groups[i];
    if (group.axes.empty()) continue;
    text += heading(3, "channel-" + std::to_string(i),
                    group.name.empty() ? subject.say(says::only_channel)
                                       : subject.say(says::channel_heading, {{"group", group.name}}));
    try {
      text += feed_table(subject, i) + group_pictures(subject, i);
    } catch (Failure const& failure) {
      // A chain without a constant part, or more axes than a path has: the sentence takes the pictures'
      // place.
      text += text_of("p", failure.sentence(subject.language)) + "\n";
    }
  }
  return text;
}

}  // namespace axisc
