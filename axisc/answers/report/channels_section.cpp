#include "axisc/answers/circle/circle_answer.hpp"
#include "axisc/answers/circle/circular_figure.hpp"
#include "axisc/answers/contour/contour_answer.hpp"
#include "axisc/answers/figures/plotted_groups.hpp"
#include "axisc/answers/report/overview.hpp"
#include "axisc/checking/path_machine.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence channel_heading{"Channel {group}", "Kanal {group}"};
constexpr Sentence only_channel{"All axes", "Alle Achsen"};
constexpr Sentence circular_test{"Circular test {circle}", "Kreisformtest {circle}"};
constexpr Sentence filters_are_on{
    "Contour deviation with all filters on, as after #FILTER ON or #VIB GUARD ON.",
    "Bahnabweichung mit allen Filtern, wie nach #FILTER ON oder #VIB GUARD ON."};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

/// The circular tests at the highest feed of the planes that deviate most, their numbers folded; of many
/// channels fewer planes, because their pictures are large.
void add_circles(ReportBlocks& blocks, ReportSubject const& subject, std::size_t group) {
  auto const& feeds = subject.contour.feeds;
  constexpr std::size_t most_planes = 3;
  constexpr std::size_t most_pictures = 6;
  auto const planes = std::clamp<std::size_t>(most_pictures / subject.contours.size(), 1, most_planes);
  auto test = channel_circles(
      {.path = subject.input, .machine = *subject.machine, .image = subject.plots->contents()}, group,
      *std::max_element(feeds.begin(), feeds.end()), subject.contour.radius_mm);
  std::stable_sort(test.cases.begin(), test.cases.end(),
                   [](auto const& a, auto const& b) { return a.deviation() > b.deviation(); });
  test.cases.resize(std::min(test.cases.size(), planes));
  for (auto const& one : test.cases) {
    CircularTest const alone{.cycle_time = test.cycle_time, .cases = {one}, .tolerance_um = {}, .files = {}};
    auto shown = circle_blocks(alone, one);
    shown.emplace_back(Picture{circular_figure(alone, subject.language)});
    blocks.emplace_back(
        folded(Words(says::circular_test, {{"circle", circle_title(one)}}), std::move(shown)));
  }
}

/// Each of the channel's axes once that are alike.
PlotSubject distinct_axes(ReportSubject const& subject, machine::MachineGroup const& group) {
  PlotSubject some = *subject.plots;
  some.axes = group.axes;
  auto const equal = equal_axes(some);
  some.axes.clear();
  for (auto const& axes : equal) {
    some.axes.push_back(axes.axes.front());
    some.called[axes.axes.front()] = axes.names;
  }
  return some;
}

/// Contours in numbers and pictures.
ReportBlocks contours(ReportSubject const& subject, std::size_t group, GroupContour const& predicted) {
  ReportBlocks blocks{Paragraph{says::filters_are_on}};
  for (auto& block : contour_blocks(predicted, subject.contour)) blocks.push_back(std::move(block));
  auto chains = GroupChains(*subject.machine, group, filters_on(), subject.input);
  ContourSubject const contour{.now = chains,
                               .before = nullptr,
                               .cycle_time = subject.machine->cycle_time,
                               .axes = axis_names(subject.plots->contents(), chains.group()),
                               .language = subject.language};
  blocks.emplace_back(Picture{delay_figure(distinct_axes(subject, subject.machine->groups[group]))});
  for (auto const& figure :
       {corner_figure(contour, subject.contour), circle_figure(contour, subject.contour)}) {
    // The table of contours has these figures.
    blocks.emplace_back(Picture{figure});
    std::get<Picture>(blocks.back()).figure.table = {};
  }
  add_circles(blocks, subject, group);
  return blocks;
}

}  // namespace

ReportBlocks channels_section(ReportSubject const& subject) {
  ReportBlocks sections;
  for (std::size_t i = 0; i < subject.contours.size(); ++i) {
    auto const& [figures, reason] = subject.contours[i];
    if (!figures && reason.empty()) continue;
    auto const& group = subject.machine->groups[i];
    Section section{.key = {},
                    .title = group.name.empty() ? says::only_channel
                                                : Words(says::channel_heading, {{"group", group.name}}),
                    .blocks = {},
                    .id = "channel-" + std::to_string(i)};
    section.blocks = figures ? contours(subject, i, *figures) : ReportBlocks{Paragraph{as_given(reason)}};
    sections.emplace_back(std::move(section));
  }
  return sections;
}

}  // namespace axisc
