#include "axisc/answers/inspect/inspect_answer.hpp"
#include "axisc/answers/inspect/inspect_parts.hpp"
#include "axisc/answers/report/html.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "axisc/asked/filter_symbols.hpp"
#include "axisc/checking/path_machine.hpp"
#include "configuration/machine/part.hpp"
#include "diagnostics/format_number.hpp"
#include "image/chain_figures.hpp"
#include "presentation/pictures/page.hpp"
#include "presentation/writers.hpp"

#include <span>

namespace axisc::says {

constexpr Sentence axis_heading{"Axis {axis}", "Achse {axis}"};
constexpr Sentence no_axis_filter{"No filter: setpoints pass unchanged.",
                                  "Kein Filter: Sollwerte gehen unverändert durch."};
constexpr Sentence kernel_is_off{
    "As from start-up, where the FIR/HSC filter is off; what it does after #FILTER ON is under the contours.",
    "Wie ab Hochlauf, wo der FIR-/HSC-Filter aus ist; was er nach #FILTER ON tut, steht bei den Konturen."};
constexpr Sentence values_summary{"What its lists set, and where", "Was ihre Listen setzen, und wo"};
constexpr Sentence coefficients_summary{"Filters, coefficients and poles", "Filter, Koeffizienten und Pole"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::string values_of(ReportSubject const& subject, image::ImageAxis const& axis) {
  if (axis.values.empty()) return {};
  auto const table = values_table("values", axis.values, presentation::Audience::people);
  return details(subject.say(says::values_summary),
                 presentation::html_of({table}, 4, {.language = subject.language}));
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

/// What `inspect` says of the axis, without the head of the image.
std::string coefficients_of(ReportSubject const& subject, std::size_t axis,
                            image::ChainFigures const& figures) {
  auto const blocks = inspect_axes(subject.plots->contents(), std::span(&axis, 1), std::span(&figures, 1),
                                   presentation::Audience::people);
  return details(subject.say(says::coefficients_summary),
                 presentation::html_of(blocks, 4, {.language = subject.language}));
}

}  // namespace

std::string axes_section(ReportSubject const& subject) {
  if (!subject.plots || subject.machine == nullptr) return {};
  auto const& contents = subject.plots->contents();
  std::string text;
  for (auto const axis : subject.plots->axes) {
    auto const& compiled = contents.axes[axis];
    text += heading(3, "axis-" + std::to_string(axis),
                    subject.say(says::axis_heading, {{"axis", subject.plots->name(axis)}}));
    AxisAlone const alone(subject, axis);
    bool const has_filter = !compiled.filters.empty() || compiled.slot.has_value();
    bool const starts_off = compiled.slot && compiled.slot->kernel && !compiled.slot->on_at_start;
    if (starts_off) text += text_of("p", subject.say(says::kernel_is_off)) + "\n";
    if (has_filter || subject.plots->axis_before(axis)) {
      text += pictures::figure_element(response_figure(alone.plots(), {}), subject.language);
      auto step = step_figure(alone.plots());
      step.table = {};
      text += pictures::figure_element(step, subject.language);
    } else {
      text += text_of("p", subject.say(says::no_axis_filter)) + "\n";
    }
    if (has_filter || !compiled.interface_filters.empty() || compiled.control) {
      text += coefficients_of(subject, axis, alone.figures());
    }
    text += values_of(subject, compiled);
  }
  return text;
}

}  // namespace axisc
