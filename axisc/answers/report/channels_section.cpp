#include "axisc/answers/contour/contour_answer.hpp"
#include "axisc/answers/figures/plotted_groups.hpp"
#include "axisc/answers/report/html.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "presentation/pictures/page.hpp"
#include "presentation/writers.hpp"

namespace axisc::says {

constexpr Sentence channel_heading{"Channel {group}", "Kanal {group}"};
constexpr Sentence only_channel{"All axes", "Alle Achsen"};
constexpr Sentence filters_are_on{
    "Contour deviation with FIR and HSC filters on, as after #FILTER ON.",
    "Bahnabweichung mit eingeschalteten FIR- und HSC-Filtern, wie nach #FILTER ON."};

}  // namespace axisc::says

namespace axisc {

namespace {

std::string contours(ReportSubject const& subject, std::size_t group) {
  auto const predicted = predict_contour(
      {.machine = *subject.machine, .group = group, .commands = filters_on(), .path = subject.input},
      subject.contour);
  constexpr int level = 4;
  return text_of("p", subject.say(says::filters_are_on)) + "\n" +
         presentation::html_of(contour_blocks(predicted, subject.contour), level,
                               {.language = subject.language});
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
      text += contours(subject, i) + group_pictures(subject, i);
    } catch (Failure const& failure) {
      // A chain without a constant part, or more axes than a path has: the sentence takes the pictures'
      // place.
      text += text_of("p", failure.sentence(subject.language)) + "\n";
    }
  }
  return text;
}

}  // namespace axisc
