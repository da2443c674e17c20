#include "axisc/answers/execution/port_response.hpp"
#include "axisc/answers/figures/plots.hpp"
#include "axisc/answers/labels.hpp"
#include "design/filter_analysis.hpp"
#include "design/kernels/kernel_analysis.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace axisc::says {

constexpr Sentence delay_title{"Group delay at 0 Hz: {axes}", "Gruppenlaufzeit bei 0 Hz: {axes}"};
constexpr Sentence delay_title_on{"Group delay at 0 Hz, all filters on: {axes}",
                                  "Gruppenlaufzeit bei 0 Hz, alle Filter an: {axes}"};
constexpr Sentence delay_before{"{axis}, before", "{axis}, vorher"};
constexpr Sentence delay_was{"before [ms]", "vorher [ms]"};
constexpr Sentence delay_is{"now [ms]", "jetzt [ms]"};
constexpr Sentence delay_kernel{"FIR/HSC filter", "FIR-/HSC-Filter"};
constexpr Sentence delay_guard{"Vibration Guard", "Vibration Guard"};
constexpr Sentence delay_total{"sum", "Summe"};
constexpr Sentence delay_at_start{"sum at start-up", "Summe ab Hochlauf"};
constexpr Sentence delay_said{"{axis} {delay} ms", "{axis} {delay} ms"};
constexpr Sentence delay_said_both{"{axis} {delay} ms, at start-up {start} ms",
                                   "{axis} {delay} ms, ab Hochlauf {start} ms"};
constexpr Sentence delay_none{"No axis has a delay.", "Keine Achse hat eine Verzögerung."};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr int delay_digits = 4;

struct DelayShare {
  std::string name;
  double milliseconds = 0;
};

struct AxisDelay {
  std::string name;
  bool was = false;  ///< of the earlier state
  std::vector<DelayShare> shares;
  double total = 0;
  std::optional<double> at_start = {};  ///< the total as long as no command switched the kernel on
};

/// Of the kernel in ms: of what --at switched on, else of the listed one, which programs switch on.
double kernel_delay(PlotSubject const& subject, PlottedImage const& image, std::size_t axis,
                    double filters_ms) {
  auto const& contents = image.contents();
  if (subject.is_switched) {
    PortResponse const response(contents, image.host, axis, Port::setpoint);
    // A kernel that is off leaves what the sum was rounded by.
    constexpr double nothing_ms = 1e-9;
    double const rest = response.at({0}).group_delay_s * 1e3 - filters_ms;
    return std::abs(rest) < nothing_ms ? 0 : rest;
  }
  auto const& listed = contents.axes[axis].slot->kernel;
  if (!listed) return 0;
  return design::kernel_response(contents.kernels[*listed].design, {0}, contents.cycle_time).group_delay_s *
         1e3;
}

AxisDelay delay_of(PlotSubject const& subject, PlottedImage const& image, std::size_t axis,
                   std::string name) {
  auto const& contents = image.contents();
  AxisDelay delay{.name = std::move(name), .was = &image != &subject.now, .shares = {}};
  for (auto const& filter : contents.axes[axis].filters) {
    double const share =
        design::chain_response({&filter.design, 1}, {0}, contents.cycle_time).group_delay_s * 1e3;
    delay.shares.push_back({.name = filter_label(filter, subject.language), .milliseconds = share});
    delay.total += share;
  }
  auto const& slot = contents.axes[axis].slot;
  if (!slot) return delay;
  double const kernel = kernel_delay(subject, image, axis, delay.total);
  if (!subject.is_switched && !slot->on_at_start && kernel != 0) delay.at_start = delay.total;
  bool const is_guard = slot->family == machine::KernelFamily::guard;
  delay.shares.push_back(
      {.name = subject.say(is_guard ? says::delay_guard : says::delay_kernel), .milliseconds = kernel});
  delay.total += kernel;
  return delay;
}

std::vector<AxisDelay> delays_of(PlotSubject const& subject) {
  std::vector<AxisDelay> delays;
  for (auto const axis : subject.axes) {
    if (auto const old = subject.axis_before(axis)) {
      delays.push_back(delay_of(subject, *subject.before, *old,
                                subject.say(says::delay_before, {{"axis", subject.name(axis)}})));
    }
    delays.push_back(delay_of(subject, subject.now, axis, subject.name(axis)));
  }
  return delays;
}

/// Of one axis, with what it was before.
void add_rows(pictures::Table& table, PlotSubject const& subject, AxisDelay const& now,
              AxisDelay const* before) {
  auto const row = [&](std::string const& share, std::optional<double> old, std::optional<double> value) {
    auto const text = [&](std::optional<double> const& shown) {
      return shown ? format_rounded(*shown, delay_digits).in(subject.language) : "-";
    };
    std::vector<std::string> cells{now.name, share};
    if (subject.before) cells.push_back(text(old));
    cells.push_back(text(value));
    if (subject.before) cells.push_back(text(old && value ? std::optional(*value - *old) : std::nullopt));
    table.rows.push_back(std::move(cells));
  };
  auto const share_of = [](AxisDelay const* delay, std::string const& name) -> std::optional<double> {
    if (delay == nullptr) return std::nullopt;
    auto const found = std::find_if(delay->shares.begin(), delay->shares.end(),
                                    [&](DelayShare const& share) { return share.name == name; });
    return found == delay->shares.end() ? std::nullopt : std::optional(found->milliseconds);
  };
  for (auto const& share : now.shares) row(share.name, share_of(before, share.name), share.milliseconds);
  if (before != nullptr) {
    for (auto const& share : before->shares) {
      if (!share_of(&now, share.name)) row(share.name, share.milliseconds, std::nullopt);
    }
  }
  row(subject.say(says::delay_total), before != nullptr ? std::optional(before->total) : std::nullopt,
      now.total);
  bool const was_off = before != nullptr && before->at_start;
  if (!now.at_start && !was_off) return;
  auto const at_start = [](AxisDelay const& delay) { return delay.at_start.value_or(delay.total); };
  row(subject.say(says::delay_at_start), before != nullptr ? std::optional(at_start(*before)) : std::nullopt,
      at_start(now));
}

pictures::Table delay_table(PlotSubject const& subject, std::vector<AxisDelay> const& delays) {
  pictures::Table table;
  table.header = {subject.say(labels::axis), subject.say(labels::share)};
  if (subject.before) {
    table.header.push_back(subject.say(says::delay_was));
    table.header.push_back(subject.say(says::delay_is));
    table.header.push_back(subject.say(labels::difference));
  } else {
    table.header.push_back(subject.say(labels::group_delay) + " [ms]");
  }
  for (std::size_t i = 0; i < delays.size(); ++i) {
    if (delays[i].was) continue;
    add_rows(table, subject, delays[i], i > 0 && delays[i - 1].was ? &delays[i - 1] : nullptr);
  }
  return table;
}

}  // namespace

pictures::Figure delay_figure(PlotSubject const& subject) {
  subject.require_drawable();
  auto const delays = delays_of(subject);
  pictures::Figure figure;
  bool const starts_otherwise = std::any_of(delays.begin(), delays.end(),
                                            [](AxisDelay const& axis) { return axis.at_start.has_value(); });
  figure.title =
      subject.say(starts_otherwise ? SentenceRef(says::delay_title_on) : SentenceRef(says::delay_title),
                  {{"axes", subject.names()}});
  for (auto const& axis : delays) {
    figure.description +=
        (figure.description.empty() ? "" : "; ") +
        subject.say(axis.at_start ? SentenceRef(says::delay_said_both) : SentenceRef(says::delay_said),
                    {{"axis", axis.name},
                     {"delay", format_rounded(axis.total, delay_digits)},
                     {"start", format_rounded(axis.at_start.value_or(axis.total), delay_digits)}});
  }
  figure.table = delay_table(subject, delays);
  constexpr double row_height = 26;
  pictures::Panel panel{.y = {.quantity = subject.say(labels::axis),
                              .low = -0.5,
                              .high = static_cast<double>(delays.size()) - 0.5},
                        .curves = {},
                        .height = row_height * static_cast<double>(std::max<std::size_t>(delays.size(), 2))};
  double lowest = 0;
  double highest = 0;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < delays.size(); ++i) {
    auto const y = static_cast<double>(delays.size() - 1 - i);
    panel.y.ticks.push_back(y);
    panel.y.names.push_back(delays[i].name);
    // What leads is drawn to the left of 0.
    double left = 0;
    double right = 0;
    for (auto const& share : delays[i].shares) {
      if (share.milliseconds == 0) continue;
      double& end = share.milliseconds < 0 ? left : right;
      auto const known = std::find(names.begin(), names.end(), share.name);
      auto const colour = static_cast<std::size_t>(known - names.begin());
      if (known == names.end()) names.push_back(share.name);
      panel.curves.push_back({.name = share.name,
                              .role = pictures::Role::bar,
                              .colour = colour,
                              .points = {{.x = end, .y = y}, {.x = end + share.milliseconds, .y = y}}});
      end += share.milliseconds;
    }
    lowest = std::min(lowest, left);
    highest = std::max(highest, right);
  }
  if (lowest == highest) {
    figure.nothing = subject.say(says::delay_none);
    return figure;
  }
  double const air = (highest - lowest) * 0.04;
  figure.x = {.quantity = subject.say(labels::group_delay),
              .unit = "ms",
              .low = lowest < 0 ? lowest - air : 0,
              .high = highest + air};
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace axisc
