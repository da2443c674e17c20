#include "editor/meaning/filter_figures.hpp"

#include "design/filter_analysis.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/repository_path.hpp"
#include "editor/meaning/guard_figures.hpp"
#include "editor/reading/requests.hpp"
#include "presentation/pictures/svg.hpp"
#include "validator/views/axis_views.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace axisc::editor::says {

constexpr Sentence figures{"Delay {delay} ms at 0 Hz, a step overshoots by {overshoot} %",
                           "Verzögerung {delay} ms bei 0 Hz, ein Sprung schwingt um {overshoot} % über"};
constexpr Sentence corner{"{figures}, -3 dB at {frequency} Hz.", "{figures}, -3 dB bei {frequency} Hz."};
constexpr Sentence no_corner{"{figures}.", "{figures}."};
constexpr Sentence switched_off{"No figures: this filter is switched off.",
                                "Keine Kennwerte: Dieser Filter ist ausgeschaltet."};
constexpr Sentence not_usable{"No figures: a value of this filter cannot be used.",
                              "Keine Kennwerte: Ein Wert dieses Filters ist nicht verwendbar."};
constexpr Sentence frequency{"frequency", "Frequenz"};
constexpr Sentence magnitude{"magnitude", "Betrag"};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

constexpr double floor_db = -60;
constexpr std::size_t points = 160;

validator::FilterView const* filter_named(std::vector<validator::FilterView> const& filters,
                                          std::string_view name) {
  static constexpr std::array families = {"filter[", "lr_param.add_interface.filter["};
  auto const is_named = [name](validator::FilterView const& filter) {
    auto const family =
        std::string(families[static_cast<std::size_t>(filter.port)]) + std::to_string(filter.index) + "].";
    return name.starts_with(family);
  };
  auto const found = std::find_if(filters.begin(), filters.end(), is_named);
  return found == filters.end() ? nullptr : &*found;
}

class Magnitude {
 public:
  Magnitude(design::FilterDesign const& filter, design::CycleTime cycle_time) {
    constexpr double lowest = 1;
    double const highest = 0.5e6 / cycle_time.microseconds();
    for (std::size_t i = 0; i < points; ++i) {
      double const part = static_cast<double>(i) / (points - 1);
      double const at = lowest * std::pow(highest / lowest, part);
      double const value = std::abs(design::response(filter, {at}, cycle_time));
      curve_.push_back({.x = at, .y = std::max(20 * std::log10(value), floor_db)});
    }
  }

  /// The lowest frequency at which the magnitude crosses -3 dB.
  [[nodiscard]] std::optional<double> corner() const {
    double const limit = 10 * std::log10(0.5);
    bool const is_below = curve_.front().y < limit;
    for (std::size_t i = 1; i < curve_.size(); ++i) {
      if ((curve_[i].y < limit) == is_below) continue;
      double const part = (limit - curve_[i - 1].y) / (curve_[i].y - curve_[i - 1].y);
      return curve_[i - 1].x * std::pow(curve_[i].x / curve_[i - 1].x, part);
    }
    return std::nullopt;
  }

  [[nodiscard]] pictures::Figure figure(std::string const& described, Language language) const {
    constexpr double height = 110;
    double highest = 0;
    for (auto const& point : curve_) highest = std::max(highest, point.y);
    pictures::Figure figure;
    figure.title = described;
    figure.description = described;
    figure.x = {.quantity = say(says::frequency, language),
                .unit = "Hz",
                .scale = pictures::Scale::logarithmic,
                .low = curve_.front().x,
                .high = curve_.back().x};
    pictures::Panel panel;
    panel.y = {.quantity = say(says::magnitude, language),
               .unit = "dB",
               .low = floor_db,
               .high = std::max(5.0, std::ceil(highest / 5) * 5)};
    panel.height = height;
    panel.curves.push_back({.points = curve_});
    figure.panels.push_back(std::move(panel));
    return figure;
  }

 private:
  std::vector<pictures::Point> curve_;
};

}  // namespace

std::string filter_figures(OpenList const& list, std::string_view name, bool markdown, Language language) {
  if (list.axis() == nullptr) return {};
  auto const cycle_time = list.cycle_time();
  if (name.starts_with("vib_guard.")) {
    return "\n" + listed_guard_text(*list.axis(), cycle_time, language) + "\n";
  }
  validator::AxisViews const views(list.axis()->merged.values, cycle_time);
  auto const* const filter = filter_named(views.filters, name);
  auto const* const design = filter == nullptr ? nullptr : views.designs.of(*filter);
  if (filter == nullptr || filter->is_hsc()) return {};
  if (design == nullptr) {
    bool const is_off = !filter->active() && !filter->unusable();
    return "\n" + say(is_off ? says::switched_off : says::not_usable, language) + "\n";
  }
  constexpr std::uint64_t longest = 100'000;
  double const delay = design::chain_delay_cycles({design, 1}) * cycle_time.microseconds() / 1000;
  Magnitude const magnitude(*design, cycle_time);
  auto const figures =
      say(says::figures, language,
          {{"delay", format_rounded(delay, shown_digits)},
           {"overshoot", format_rounded(100 * design::step_overshoot({design, 1}, longest), shown_digits)}});
  auto const corner = magnitude.corner();
  auto const text = corner ? say(says::corner, language,
                                 {{"figures", figures}, {"frequency", format_rounded(*corner, shown_digits)}})
                           : say(says::no_corner, language, {{"figures", figures}});
  if (!markdown) return "\n" + text + "\n";
  auto const title = std::string(name.substr(0, name.rfind('.')));
  return "\n" + text + "\n\n![" + title + "](data:image/svg+xml," +
         as_uri(pictures::svg(magnitude.figure(title, language), language)) + ")\n";
}

}  // namespace axisc::editor
