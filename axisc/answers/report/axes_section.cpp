#include "axisc/answers/figures/robustness_figure.hpp"
#include "axisc/answers/inspect/inspect_answer.hpp"
#include "axisc/answers/inspect/inspect_parts.hpp"
#include "axisc/answers/report/overview.hpp"
#include "axisc/asked/filter_symbols.hpp"
#include "axisc/checking/path_machine.hpp"
#include "configuration/machine/part.hpp"
#include "image/chain_figures.hpp"

#include <map>
#include <span>

namespace axisc::says {

constexpr Sentence axis_heading{"Axis {axis}", "Achse {axis}"};
constexpr Sentence axes_heading{"Axes {axes}", "Achsen {axes}"};
constexpr Sentence no_axis_filter{"No filter: setpoints pass unchanged.",
                                  "Kein Filter: Sollwerte gehen unverändert durch."};
constexpr Sentence kernel_is_off{
    "As from start-up, before a program switches its filter on; what it does then is under the contours.",
    "Wie ab Hochlauf, bevor ein Programm ihren Filter einschaltet; was er dann tut, steht bei den Konturen."};
constexpr Sentence values_summary{"{axis}: what its lists set, and where",
                                  "{axis}: was ihre Listen setzen, und wo"};
constexpr Sentence coefficients_summary{"{axis}: filters, coefficients and poles",
                                        "{axis}: Filter, Koeffizienten und Pole"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

/// The first of some equal axes, compiled and executed alone: otherwise each would cost as much as the
/// machine.
class AxisAlone {
 public:
  AxisAlone(ReportSubject const& subject, EqualAxes const& equal)
      : file_(image_of(machine::part_of(*subject.machine, std::span(equal.axes).first(1)).machine,
                       subject.input)),
        host_(start_runtime(subject.input, file_)),
        plots_{.now = {.file = file_, .host = host_},
               .before = subject.plots->before,
               .axes = {0},
               .language = subject.language,
               .called = {{0, equal.names}}} {}

  [[nodiscard]] PlotSubject const& plots() const { return plots_; }
  [[nodiscard]] image::ChainFigures figures() const {
    return image::chain_figures(file_.bytes.bytes(), file_.contents, std::size_t{0});
  }

 private:
  ImageFile file_;
  image::RuntimeHost host_;
  PlotSubject plots_;
};

/// Two pictures of three panels fit on a page, and the names of their axes beside them.
constexpr double panel_height = 130;

Picture flattened(pictures::Figure figure) {
  for (auto& panel : figure.panels) panel.height = panel_height;
  return {std::move(figure)};
}

/// Of axes that have a Vibration Guard, or had one.
void add_robustness(std::vector<Block>& blocks, PlotSubject const& plots, EqualAxes const& equal) {
  auto const axis = equal.axes.front();
  auto const old = plots.axis_before(axis);
  if (!has_guard(plots.contents(), axis) && !(old && has_guard(plots.before->contents(), *old))) return;
  PlotSubject some = plots;
  some.axes = equal.axes;
  blocks.emplace_back(Picture{robustness_figure(some)});
}

/// From rest to rest, beside the earlier state where that is a machine; axes that are driven alike once.
/// Nothing of axes that no channel moves.
void add_dynamics(std::vector<Block>& blocks, PlotSubject const& plots, EqualAxes const& equal) {
  PlotSubject some = plots;
  some.axes.clear();
  if (some.before && some.before->machine == nullptr) some.before.reset();
  using Figures = std::vector<std::vector<std::string>>;
  std::map<Figures, std::size_t> alike;
  for (auto const axis : equal.axes) {
    if (!driven_axis(*plots.now.machine, axis)) continue;
    PlotSubject one = some;
    one.axes = {axis};
    auto figures = dynamics_figure(one, {}).table.rows;
    for (auto& row : figures) row.front().clear();
    auto const [first, is_new] = alike.emplace(std::move(figures), axis);
    if (is_new) {
      some.axes.push_back(axis);
      some.called[axis] = plots.name(axis);
    } else {
      some.called[first->second] += ", " + plots.name(axis);
    }
  }
  if (some.axes.empty()) return;
  blocks.emplace_back(flattened(dynamics_figure(some, {})));
}

/// What `inspect` says of the axes, without the head of the image, and what each list sets. What is not about
/// setpoints may differ.
void add_details(std::vector<Block>& blocks, PlotSubject const& plots, EqualAxes const& equal,
                 image::ChainFigures const& figures) {
  auto const& contents = plots.contents();
  for (auto const axis : equal.axes) {
    auto const& compiled = contents.axes[axis];
    bool const is_first = axis == equal.axes.front();
    bool const has_setpoint_filter = !compiled.filters.empty() || compiled.slot;
    bool const has_other = !compiled.interface_filters.empty() || compiled.control;
    if (!has_other && !(is_first && has_setpoint_filter)) continue;
    auto const names = is_first && !has_other ? equal.names : plots.name(axis);
    blocks.emplace_back(
        folded(Words(says::coefficients_summary, {{"axis", names}}),
               inspect_axes(contents, std::span(&axis, 1), std::span(&figures, 1), Audience::people)));
  }
  for (auto const axis : equal.axes) {
    auto const& values = contents.axes[axis].values;
    if (values.empty()) continue;
    blocks.emplace_back(folded(Words(says::values_summary, {{"axis", plots.name(axis)}}),
                               {values_table("values", values, Audience::people)}));
  }
}

}  // namespace

ReportBlocks axes_section(ReportSubject const& subject) {
  if (!subject.plots) return {};
  auto const& plots = *subject.plots;
  ReportBlocks sections;
  for (auto const& equal : equal_axes(plots)) {
    auto const first = equal.axes.front();
    auto const& compiled = plots.contents().axes[first];
    bool const is_one = equal.axes.size() == 1;
    Section section{.key = {},
                    .title = Words(is_one ? says::axis_heading : says::axes_heading,
                                   {{"axis", equal.names}, {"axes", equal.names}}),
                    .blocks = {},
                    .id = "axis-" + std::to_string(first)};
    auto& blocks = section.blocks;
    AxisAlone const alone(subject, equal);
    if (compiled.slot && compiled.slot->kernel && !compiled.slot->on_at_start) {
      blocks.emplace_back(Paragraph{says::kernel_is_off});
    }
    if (!compiled.filters.empty() || compiled.slot || plots.axis_before(first)) {
      blocks.emplace_back(flattened(response_figure(alone.plots(), {})));
      auto step = step_figure(alone.plots());
      step.table = {};
      blocks.emplace_back(flattened(std::move(step)));
    } else {
      blocks.emplace_back(Paragraph{says::no_axis_filter});
    }
    add_robustness(blocks, plots, equal);
    add_dynamics(blocks, plots, equal);
    add_details(blocks, plots, equal, alone.figures());
    sections.emplace_back(std::move(section));
  }
  return sections;
}

}  // namespace axisc
