#include "axisc/answers/figures/robustness_figure.hpp"
#include "axisc/answers/inspect/inspect_answer.hpp"
#include "axisc/answers/inspect/inspect_parts.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "axisc/asked/filter_symbols.hpp"
#include "axisc/checking/path_machine.hpp"
#include "configuration/machine/part.hpp"
#include "image/chain_figures.hpp"

#include <span>

namespace axisc::says {

constexpr Sentence axis_heading{"Axis {axis}", "Achse {axis}"};
constexpr Sentence no_axis_filter{"No filter: setpoints pass unchanged.",
                                  "Kein Filter: Sollwerte gehen unverändert durch."};
constexpr Sentence kernel_is_off{
    "As from start-up, before a program switches its filter on; what it does then is under the contours.",
    "Wie ab Hochlauf, bevor ein Programm ihren Filter einschaltet; was er dann tut, steht bei den Konturen."};
constexpr Sentence values_summary{"What its lists set, and where", "Was ihre Listen setzen, und wo"};
constexpr Sentence coefficients_summary{"Filters, coefficients and poles", "Filter, Koeffizienten und Pole"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

Section folded(SentenceRef title, std::vector<Block> blocks) {
  auto section = part(title, std::move(blocks));
  section.is_folded = true;
  return section;
}

/// One axis, compiled and executed alone: otherwise each axis would cost as much as the machine.
class AxisAlone {
 public:
  AxisAlone(ReportSubject const& subject, std::size_t axis)
      : file_(image_of(machine::part_of(*subject.machine, std::span(&axis, 1)).machine, subject.input)),
        host_(start_runtime(subject.input, file_)),
        plots_{.now = {.file = file_, .host = host_},
               .before = subject.plots->before,
               .axes = {0},
               .language = subject.language} {}

  [[nodiscard]] PlotSubject const& plots() const { return plots_; }
  [[nodiscard]] image::ChainFigures figures() const {
    return image::chain_figures(file_.bytes.bytes(), file_.contents, std::size_t{0});
  }

 private:
  ImageFile file_;
  image::RuntimeHost host_;
  PlotSubject plots_;
};

/// Of an axis that has a Vibration Guard, or had one.
void add_robustness(std::vector<Block>& blocks, PlotSubject const& plots, std::size_t axis) {
  auto const old = plots.axis_before(axis);
  if (!has_guard(plots.contents(), axis) && !(old && has_guard(plots.before->contents(), *old))) return;
  PlotSubject one = plots;
  one.axes = {axis};
  blocks.emplace_back(Picture{robustness_figure(one)});
}

/// From rest to rest, beside the earlier state where that is a machine. Nothing of an axis that no channel
/// moves.
void add_dynamics(std::vector<Block>& blocks, PlotSubject const& plots, std::size_t axis) {
  if (!driven_axis(*plots.now.machine, axis)) return;
  PlotSubject one = plots;
  one.axes = {axis};
  if (one.before && one.before->machine == nullptr) one.before.reset();
  blocks.emplace_back(Picture{dynamics_figure(one, {})});
}

}  // namespace

ReportBlocks axes_section(ReportSubject const& subject) {
  if (!subject.plots || subject.machine == nullptr) return {};
  auto const& contents = subject.plots->contents();
  ReportBlocks sections;
  for (auto const axis : subject.plots->axes) {
    auto const& compiled = contents.axes[axis];
    Section section{.key = {},
                    .title = Words(says::axis_heading, {{"axis", subject.plots->name(axis)}}),
                    .blocks = {},
                    .id = "axis-" + std::to_string(axis)};
    auto& blocks = section.blocks;
    AxisAlone const alone(subject, axis);
    bool const has_filter = !compiled.filters.empty() || compiled.slot.has_value();
    bool const starts_off = compiled.slot && compiled.slot->kernel && !compiled.slot->on_at_start;
    if (starts_off) blocks.emplace_back(Paragraph{says::kernel_is_off});
    if (has_filter || subject.plots->axis_before(axis)) {
      blocks.emplace_back(Picture{response_figure(alone.plots(), {})});
      auto step = step_figure(alone.plots());
      step.table = {};
      blocks.emplace_back(Picture{std::move(step)});
    } else {
      blocks.emplace_back(Paragraph{says::no_axis_filter});
    }
    add_robustness(blocks, *subject.plots, axis);
    add_dynamics(blocks, *subject.plots, axis);
    if (has_filter || !compiled.interface_filters.empty() || compiled.control) {
      // What `inspect` says of the axis, without the head of the image.
      auto const figures = alone.figures();
      blocks.emplace_back(
          folded(says::coefficients_summary,
                 inspect_axes(contents, std::span(&axis, 1), std::span(&figures, 1), Audience::people)));
    }
    if (!compiled.values.empty()) {
      blocks.emplace_back(
          folded(says::values_summary, {values_table("values", compiled.values, Audience::people)}));
    }
    sections.emplace_back(std::move(section));
  }
  return sections;
}

}  // namespace axisc
