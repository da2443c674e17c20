#include "axisc/answers/execution/port_response.hpp"
#include "axisc/answers/figures/plots.hpp"
#include "axisc/answers/labels.hpp"
#include "design/filter_analysis.hpp"
#include "design/kernels/kernel_analysis.hpp"
#include "diagnostics/format_number.hpp"
#include "image/chain_figures.hpp"
#include "presentation/pictures/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

namespace axisc::says {

constexpr Sentence title{"Frequency response: {axes}", "Frequenzgang: {axes}"};
constexpr Sentence described{"{axis}: group delay at 0 Hz {delay} ms, {corner}",
                             "{axis}: Gruppenlaufzeit bei 0 Hz {delay} ms, {corner}"};
constexpr Sentence described_corner{"-3 dB at {frequency} Hz", "-3 dB bei {frequency} Hz"};
constexpr Sentence described_no_corner{"above -3 dB at all frequencies", "über -3 dB bei allen Frequenzen"};
constexpr Sentence whole_chain{"{axis}, whole chain", "{axis}, ganze Kette"};
constexpr Sentence chain_before{"{axis}, before", "{axis}, vorher"};
constexpr Sentence measured_curve{"measured", "gemessen"};
constexpr Sentence filtered_curve{"measured × {axis}", "gemessen × {axis}"};
constexpr Sentence no_filter{"No axis has a filter: setpoints pass unchanged.",
                             "Keine Achse hat einen Filter: Sollwerte gehen unverändert durch."};

}  // namespace axisc::says

namespace axisc {

namespace {

using Response = std::function<design::ResponsePoint(double)>;

/// Below it a picture shows nothing.
constexpr double floor_db = -80;

struct Source {
  std::string name;
  pictures::Role role = pictures::Role::whole;
  std::size_t colour = 0;
  Response response;
};

double decibels_of(design::ResponsePoint const& point) {
  return std::max(20 * std::log10(point.magnitude), floor_db);
}

double factor_of(double decibels) {
  return std::pow(10.0, decibels / 20);
}

/// Colours from here on belong to what was measured.
constexpr std::size_t measured_colour = 1000 * 6 + 3;

/// Turns jumps of more than half a turn into continuous phase.
void unwrap(std::vector<pictures::Point>& points) {
  constexpr double turn = 360;
  double added = 0;
  pictures::Point const* last = nullptr;
  for (auto& point : points) {
    if (std::isnan(point.y)) continue;
    if (last != nullptr) added -= turn * std::round((point.y + added - last->y) / turn);
    point.y += added;
    last = &point;
  }
}

/// Range of what the curves show, with some air.
void fit(pictures::Panel& panel, double least_span) {
  double low = 0;
  double high = 0;
  bool any = false;
  for (auto const& curve : panel.curves) {
    for (auto const& point : curve.points) {
      if (!std::isfinite(point.y)) continue;
      low = any ? std::min(low, point.y) : point.y;
      high = any ? std::max(high, point.y) : point.y;
      any = true;
    }
  }
  double const span = std::max(high - low, least_span);
  double const middle = (low + high) / 2;
  panel.y.low = middle - span * 0.55;
  panel.y.high = middle + span * 0.55;
}

class ResponseFigure {
 public:
  ResponseFigure(PlotSubject const& subject, ResponsePlot const& wanted)
      : subject_(subject), wanted_(wanted), contents_(subject.contents()) {}

  pictures::Figure make() {
    pictures::Figure figure;
    collect();
    figure.title = subject_.say(says::title, {{"axes", subject_.names()}});
    figure.description = description();
    figure.table = chain_table(subject_, wanted_.marks);
    double const nyquist = 0.5 / contents_.cycle_time.seconds();
    constexpr double decades = 1e-4;
    figure.x = {.quantity = subject_.say(labels::frequency),
                .unit = "Hz",
                .scale = wanted_.linear_frequency ? pictures::Scale::linear : pictures::Scale::logarithmic,
                .low = wanted_.linear_frequency ? 0 : nyquist * decades,
                .high = nyquist};
    if (sources_.empty() && wanted_.measured.empty()) {
      figure.nothing = subject_.say(says::no_filter);
      return figure;
    }
    figure.panels.push_back(magnitude_panel(figure.x));
    figure.panels.push_back(phase_panel(figure.x));
    figure.panels.push_back(delay_panel(figure.x));
    add_marks(figure);
    return figure;
  }

 private:
  [[nodiscard]] std::string description() const {
    std::string text;
    constexpr int digits = 4;
    for (auto const axis : subject_.axes) {
      PortResponse const response(contents_, subject_.now.host, axis, Port::setpoint);
      auto const corner = image::corner_frequency(contents_, axis);
      std::string const words = corner ? subject_.say(says::described_corner,
                                                      {{"frequency", format_rounded(corner->value, digits)}})
                                       : subject_.say(says::described_no_corner);
      text += (text.empty() ? "" : "; ") +
              subject_.say(says::described,
                           {{"axis", subject_.name(axis)},
                            {"delay", format_rounded(response.at({0}).group_delay_s * 1e3, digits)},
                            {"corner", words}});
    }
    return text;
  }

  void collect() {
    bool const is_alone = subject_.axes.size() == 1;
    for (std::size_t i = 0; i < subject_.axes.size(); ++i) {
      auto const index = subject_.axes[i];
      if (auto const old = subject_.axis_before(index)) {
        add_chain(*subject_.before, *old, i, pictures::Role::before,
                  subject_.say(says::chain_before, {{"axis", subject_.name(index)}}));
      }
      add_chain(subject_.now, index, i, pictures::Role::whole,
                subject_.say(says::whole_chain, {{"axis", subject_.name(index)}}));
      auto const& axis = contents_.axes[index];
      if (is_alone && axis.filters.size() + (axis.slot ? 1U : 0U) > 1) add_parts(index);
    }
  }

  void add_chain(PlottedImage const& image, std::size_t index, std::size_t colour, pictures::Role role,
                 std::string name) {
    auto const& contents = image.contents();
    if (contents.axes[index].filters.empty() && !contents.axes[index].slot && !subject_.before) return;
    note_frequencies(contents, index);
    auto const whole = std::make_shared<PortResponse>(contents, image.host, index, Port::setpoint);
    sources_.push_back(
        {.name = std::move(name), .role = role, .colour = colour, .response = [whole](double frequency) {
           return whole->at({frequency});
         }});
  }

  void add_parts(std::size_t index) {
    auto const cycle_time = contents_.cycle_time;
    for (auto const& filter : contents_.axes[index].filters) {
      sources_.push_back({.name = filter_label(filter, subject_.language),
                          .role = pictures::Role::part,
                          .colour = sources_.size(),
                          .response = [&filter, cycle_time](double frequency) {
                            return design::chain_response({&filter.design, 1}, {frequency}, cycle_time);
                          }});
    }
  }

  void note_frequencies(image::ImageContents const& contents, std::size_t index) {
    for (auto const frequency : image::characteristic_frequencies(contents, index)) {
      exact_.push_back(frequency.value);
    }
    auto const& slot = contents.axes[index].slot;
    if (!slot || !slot->kernel) return;
    auto const& kernel = contents.kernels[*slot->kernel].design;
    for (auto const zero : design::zero_frequencies(kernel, contents.cycle_time)) {
      exact_.push_back(zero.value);
    }
  }

  [[nodiscard]] std::vector<pictures::Curve> curves(
      pictures::Axis const& x, pictures::Axis const& y,
      std::function<double(design::ResponsePoint const&)> const& quantity) const {
    std::vector<pictures::Curve> curves;
    for (auto const& source : sources_) {
      curves.push_back({.name = source.name,
                        .role = source.role,
                        .colour = source.colour,
                        .points = pictures::sample(x, y, exact_, [&](double frequency) {
                          return quantity(source.response(frequency));
                        })});
    }
    // The whole chains lie on top.
    std::stable_partition(curves.begin(), curves.end(),
                          [](pictures::Curve const& curve) { return curve.role != pictures::Role::whole; });
    return curves;
  }

  [[nodiscard]] pictures::Panel magnitude_panel(pictures::Axis const& x) const {
    pictures::Panel panel;
    panel.y = {.quantity = subject_.say(labels::magnitude), .unit = wanted_.linear_magnitude ? "" : "dB"};
    double highest = 1;
    for (auto const& source : sources_) {
      for (auto const& point : pictures::sample(
               x, panel.y, exact_, [&](double frequency) { return source.response(frequency).magnitude; })) {
        if (std::isfinite(point.y)) highest = std::max(highest, point.y);
      }
    }
    panel.y.low = wanted_.linear_magnitude ? 0 : floor_db;
    panel.y.high = wanted_.linear_magnitude ? highest * 1.05 : 20 * std::log10(highest) + 4;
    for (auto const& point : wanted_.measured) {
      panel.y.high = std::max(panel.y.high, wanted_.linear_magnitude ? factor_of(point.magnitude_db) * 1.05
                                                                     : point.magnitude_db + 4);
    }
    bool const is_linear = wanted_.linear_magnitude;
    panel.curves = curves(x, panel.y, [is_linear](design::ResponsePoint const& point) {
      return is_linear ? point.magnitude : decibels_of(point);
    });
    add_measured(
        panel, x, [](MeasuredPoint const& point) { return std::optional(point.magnitude_db); },
        [](design::ResponsePoint const& point) { return 20 * std::log10(point.magnitude); });
    for (auto& curve : panel.curves) {
      bool const is_measured = curve.colour >= measured_colour && !curve.points.empty();
      for (auto& point : curve.points) {
        if (is_measured) point.y = is_linear ? factor_of(point.y) : std::max(point.y, floor_db);
      }
    }
    return panel;
  }

  /// What was measured, and for a single axis what it becomes behind the chain: both quantities add up.
  void add_measured(pictures::Panel& panel, pictures::Axis const& x,
                    std::function<std::optional<double>(MeasuredPoint const&)> const& measured,
                    std::function<double(design::ResponsePoint const&)> const& filter) const {
    pictures::Curve curve{.name = subject_.say(says::measured_curve),
                          .role = pictures::Role::measured,
                          .colour = measured_colour};
    pictures::Curve behind{.name = {}, .role = pictures::Role::part, .colour = measured_colour + 1};
    auto const whole = std::find_if(sources_.begin(), sources_.end(), [](Source const& source) {
      return source.role == pictures::Role::whole;
    });
    bool const is_alone = subject_.axes.size() == 1 && whole != sources_.end();
    if (is_alone) {
      behind.name = subject_.say(says::filtered_curve, {{"axis", subject_.name(subject_.axes.front())}});
    }
    for (auto const& point : wanted_.measured) {
      auto const value = measured(point);
      if (!value || point.frequency < x.low || point.frequency > x.high) continue;
      curve.points.push_back({.x = point.frequency, .y = *value});
      if (is_alone) {
        behind.points.push_back(
            {.x = point.frequency, .y = *value + filter(whole->response(point.frequency))});
      }
    }
    if (curve.points.empty()) return;
    panel.curves.push_back(std::move(curve));
    if (is_alone) panel.curves.push_back(std::move(behind));
  }

  [[nodiscard]] pictures::Panel phase_panel(pictures::Axis const& x) const {
    constexpr double half_turn = 180;
    pictures::Panel panel;
    panel.y = {.quantity = subject_.say(labels::phase), .unit = "°", .low = -half_turn, .high = half_turn};
    // Of nothing that passes there is no phase.
    constexpr double nothing = 1e-12;
    panel.curves = curves(x, panel.y, [](design::ResponsePoint const& point) {
      if (point.magnitude < nothing) return std::numeric_limits<double>::quiet_NaN();
      return point.phase_rad * half_turn / std::numbers::pi;
    });
    add_measured(
        panel, x, [](MeasuredPoint const& point) { return point.phase_deg; },
        [](design::ResponsePoint const& point) { return point.phase_rad * half_turn / std::numbers::pi; });
    if (wanted_.wraps_phase) {
      panel.y.ticks = {-180, -90, 0, 90, 180};
      return panel;
    }
    for (auto& curve : panel.curves) unwrap(curve.points);
    fit(panel, half_turn / 2);
    return panel;
  }

  [[nodiscard]] pictures::Panel delay_panel(pictures::Axis const& x) const {
    pictures::Panel panel;
    auto const quantity = [](design::ResponsePoint const& point) { return point.group_delay_s * 1e3; };
    panel.y = {.quantity = subject_.say(labels::group_delay), .unit = "ms", .low = -1, .high = 1};
    panel.curves = curves(x, panel.y, quantity);
    fit(panel, contents_.cycle_time.seconds() * 1e3);
    panel.curves = curves(x, panel.y, quantity);
    return panel;
  }

  void add_marks(pictures::Figure& figure) const {
    constexpr int digits = 4;
    std::vector<double> marks = wanted_.marks;
    for (auto const axis : subject_.axes) {
      for (auto const frequency : image::characteristic_frequencies(contents_, axis)) {
        marks.push_back(frequency.value);
      }
    }
    std::sort(marks.begin(), marks.end());
    marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
    for (double const mark : marks) {
      if (mark < figure.x.low || mark > figure.x.high) continue;
      figure.marks.push_back(
          {.at = mark, .label = format_rounded(mark, digits).in(subject_.language) + " Hz"});
    }
    figure.marks.push_back({.at = figure.x.high, .label = Wording::number("0.5/T").in(subject_.language)});
  }

  PlotSubject const& subject_;
  ResponsePlot const& wanted_;
  image::ImageContents const& contents_;
  std::vector<Source> sources_;
  std::vector<double> exact_;
};

}  // namespace

pictures::Figure response_figure(PlotSubject const& subject, ResponsePlot const& wanted) {
  subject.require_drawable();
  return ResponseFigure(subject, wanted).make();
}

}  // namespace axisc
