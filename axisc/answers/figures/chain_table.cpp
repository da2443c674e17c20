#include "axisc/answers/difference/difference_answer.hpp"
#include "axisc/answers/execution/port_response.hpp"
#include "axisc/answers/figures/plots.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/format_number.hpp"
#include "image/chain_figures.hpp"

#include <algorithm>
#include <map>

namespace axisc::says {

constexpr Sentence table_quantity{"quantity", "Größe"};
constexpr Sentence table_now{"now", "jetzt"};
constexpr Sentence table_delay{"group delay at 0 Hz [ms]", "Gruppenlaufzeit bei 0 Hz [ms]"};
constexpr Sentence table_corner{"-3 dB frequency [Hz]", "-3-dB-Frequenz [Hz]"};
constexpr Sentence table_magnitude{"magnitude at {frequency} Hz [dB]", "Betrag bei {frequency} Hz [dB]"};
constexpr Sentence table_settling{"settled to 0.01 % after [ms]", "auf 0,01 % eingeschwungen nach [ms]"};
constexpr Sentence table_overshoot{"overshoot [%]", "Überschwingen [%]"};
constexpr Sentence table_deviation{"corner of 90° at 1000 mm/min [µm]", "Ecke von 90° bei 1000 mm/min [µm]"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr int table_digits = 4;

/// Values in the order of the rows; none where there is nothing to say.
std::vector<std::optional<double>> values_of(PlottedImage const& image, std::size_t axis,
                                             image::ChainFigures const& chain,
                                             std::vector<double> const& frequencies) {
  auto const& contents = image.contents();
  double const milliseconds = contents.cycle_time.seconds() * 1e3;
  PortResponse const response(contents, image.host, axis, Port::setpoint);
  auto const corner = image::corner_frequency(contents, axis);
  std::vector<std::optional<double>> values = {response.at({0}).group_delay_s * 1e3,
                                               corner ? std::optional(corner->value) : std::nullopt};
  for (double const frequency : frequencies) {
    values.push_back(image::decibels(response.at({frequency}).magnitude));
  }
  values.push_back(chain.settling_cycles
                       ? std::optional(static_cast<double>(*chain.settling_cycles) * milliseconds)
                       : std::nullopt);
  values.emplace_back(chain.overshoot * 100);
  constexpr double feed = 1000;
  values.push_back(corner_deviation_um(chain, feed, contents.cycle_time));
  return values;
}

std::vector<double> frequencies_of(PlotSubject const& subject, std::size_t axis,
                                   std::vector<double> const& marks) {
  auto frequencies = marks;
  auto const add = [&](image::ImageContents const& contents, std::size_t index) {
    for (auto const frequency : image::characteristic_frequencies(contents, index)) {
      frequencies.push_back(frequency.value);
    }
  };
  add(subject.contents(), axis);
  if (auto const old = subject.axis_before(axis)) add(subject.before->contents(), *old);
  std::sort(frequencies.begin(), frequencies.end());
  frequencies.erase(std::unique(frequencies.begin(), frequencies.end()), frequencies.end());
  return frequencies;
}

std::map<std::size_t, image::ChainFigures> figures_by_axis(PlottedImage const& image,
                                                           std::vector<std::size_t> const& axes) {
  auto const figures = figures_of(image, axes);
  std::map<std::size_t, image::ChainFigures> by_axis;
  for (std::size_t i = 0; i < axes.size(); ++i) by_axis.emplace(axes[i], figures[i]);
  return by_axis;
}

}  // namespace

pictures::Table chain_table(PlotSubject const& subject, std::vector<double> const& marks) {
  pictures::Table table;
  table.header = {subject.say(labels::axis), subject.say(says::table_quantity)};
  if (subject.before) {
    table.header.push_back(subject.say(labels::before));
    table.header.push_back(subject.say(says::table_now));
    table.header.push_back(subject.say(labels::difference));
  } else {
    table.header.push_back(subject.say(labels::value));
  }
  auto const figures = figures_by_axis(subject.now, subject.axes);
  std::vector<std::size_t> old_axes;
  for (auto const axis : subject.axes) {
    if (auto const old = subject.axis_before(axis)) old_axes.push_back(*old);
  }
  auto const old_figures = subject.before ? figures_by_axis(*subject.before, old_axes)
                                          : std::map<std::size_t, image::ChainFigures>();
  auto const cell = [&](std::optional<double> const& value) {
    return value ? format_rounded(*value, table_digits).in(subject.language) : "-";
  };
  for (auto const axis : subject.axes) {
    auto const frequencies = frequencies_of(subject, axis, marks);
    std::vector<std::string> quantities = {subject.say(says::table_delay), subject.say(says::table_corner)};
    for (double const frequency : frequencies) {
      quantities.push_back(
          subject.say(says::table_magnitude, {{"frequency", format_rounded(frequency, table_digits)}}));
    }
    for (SentenceRef const quantity : {SentenceRef(says::table_settling), SentenceRef(says::table_overshoot),
                                       SentenceRef(says::table_deviation)}) {
      quantities.push_back(subject.say(quantity));
    }
    auto const now = values_of(subject.now, axis, figures.at(axis), frequencies);
    auto const index = subject.axis_before(axis);
    auto const old = index ? values_of(*subject.before, *index, old_figures.at(*index), frequencies)
                           : std::vector<std::optional<double>>(now.size());
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      std::vector<std::string> row{subject.name(axis), quantities[i]};
      if (subject.before) row.push_back(cell(old[i]));
      row.push_back(cell(now[i]));
      if (subject.before) {
        row.push_back(cell(now[i] && old[i] ? std::optional(*now[i] - *old[i]) : std::nullopt));
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace axisc
