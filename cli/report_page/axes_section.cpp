#include "cli/formats/inspect_formats.hpp"
#include "cli/options/filter_symbols.hpp"
#include "cli/report_page/html.hpp"
#include "cli/report_page/report_page.hpp"
#include "diagnostics/format_number.hpp"
#include "image/chain_figures.hpp"
#include "pictures/page.hpp"
#include "pictures/svg_text.hpp"

namespace axisc::cli::says {

constexpr Sentence axis_heading{"Axis {axis}", "Achse {axis}"};
constexpr Sentence no_axis_filter{"No filter: setpoints pass unchanged.",
                                  "Kein Filter: Sollwerte gehen unverändert durch."};
constexpr Sentence values_summary{"What its lists set, and where", "Was ihre Listen setzen, und wo"};
constexpr Sentence values_name{"parameter", "Parameter"};
constexpr Sentence values_value{"value", "Wert"};
constexpr Sentence values_place{"from", "aus"};
constexpr Sentence coefficients_summary{"Filters, coefficients and poles", "Filter, Koeffizienten und Pole"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

std::string values_of(ReportSubject const& subject, image::ImageAxis const& axis) {
  pictures::Table table;
  table.header = {subject.say(says::values_name), subject.say(says::values_value),
                  subject.say(says::values_place)};
  for (auto const& value : axis.values) {
    table.rows.push_back({value.name, value.value, value.list + ":" + std::to_string(value.line)});
  }
  return table.rows.empty() ? std::string()
                            : details(subject.say(says::values_summary), pictures::table_element(table));
}

/// What `inspect` says of the axis, without the head of the image.
std::string coefficients_of(ReportSubject const& subject, std::size_t axis) {
  auto const& plots = *subject.plots;
  Shown const shown{.file = subject.input,
                    .image = plots.contents(),
                    .axes = {axis},
                    .figures = {image::chain_figures(plots.now.file.bytes.bytes(), plots.contents(), axis)},
                    .memory = std::nullopt};
  std::string const text = inspect_text(shown, subject.language);
  auto const begin = text.find("\n\n");
  std::string const own = begin == std::string::npos ? text : text.substr(begin + 2);
  return details(subject.say(says::coefficients_summary),
                 "<pre tabindex=\"0\">" + pictures::escaped(own) + "</pre>\n");
}

}  // namespace

std::string axes_section(ReportSubject const& subject) {
  if (!subject.plots) return {};
  auto const& contents = subject.plots->contents();
  std::string text;
  for (auto const axis : subject.plots->axes) {
    auto const& compiled = contents.axes[axis];
    PlotSubject alone = *subject.plots;
    alone.axes = {axis};
    text += heading(3, "axis-" + std::to_string(axis),
                    subject.say(says::axis_heading, {{"axis", alone.name(axis)}}));
    bool const has_filter = !compiled.filters.empty() || compiled.slot.has_value();
    if (has_filter || alone.axis_before(axis)) {
      text += pictures::figure_element(response_figure(alone, {}), subject.language);
      auto step = step_figure(alone);
      step.table = {};
      text += pictures::figure_element(step, subject.language);
    } else {
      text += text_of("p", subject.say(says::no_axis_filter)) + "\n";
    }
    if (has_filter || !compiled.interface_filters.empty() || compiled.control) {
      text += coefficients_of(subject, axis);
    }
    text += values_of(subject, compiled);
  }
  return text;
}

}  // namespace axisc::cli
