#include "axisc/answers/figures/axis_delays.hpp"
#include "axisc/answers/figures/plots.hpp"
#include "axisc/answers/labels.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <optional>

namespace axisc::says {

constexpr Sentence delay_title{"Group delay at 0 Hz: {axes}", "Gruppenlaufzeit bei 0 Hz: {axes}"};
constexpr Sentence delay_title_on{"Group delay at 0 Hz, all filters on: {axes}",
                                  "Gruppenlaufzeit bei 0 Hz, alle Filter an: {axes}"};
constexpr Sentence delay_was{"before [ms]", "vorher [ms]"};
constexpr Sentence delay_is{"now [ms]", "jetzt [ms]"};
constexpr Sentence delay_with_velocity{"{title} (v: velocity feedforward)",
                                       "{title} (v: Geschwindigkeitsvorsteuerung)"};
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

/// Of one way, with what it was before.
void add_rows(pictures::Table& table, PlotSubject const& subject, DelayPair const& pair) {
  AxisDelay const& shown = pair.is ? *pair.is : *pair.was;
  auto const row = [&](std::string const& share, std::optional<double> old, std::optional<double> value) {
    auto const text = [&](std::optional<double> const& number) {
      return number ? format_rounded(*number, delay_digits).in(subject.language) : "-";
    };
    std::vector<std::string> cells{shown.name, share};
    if (subject.before) cells.push_back(text(old));
    cells.push_back(text(value));
    if (subject.before) cells.push_back(text(old && value ? std::optional(*value - *old) : std::nullopt));
    table.rows.push_back(std::move(cells));
  };
  auto const share_of = [](std::optional<AxisDelay> const& delay,
                           std::string const& name) -> std::optional<double> {
    if (!delay) return std::nullopt;
    auto const found = std::find_if(delay->shares.begin(), delay->shares.end(),
                                    [&](DelayShare const& share) { return share.name == name; });
    return found == delay->shares.end() ? std::nullopt : std::optional(found->milliseconds);
  };
  auto const figure_of = [](std::optional<AxisDelay> const& delay, auto const& figure) {
    return delay ? std::optional<double>(figure(*delay)) : std::nullopt;
  };
  if (pair.is) {
    for (auto const& share : pair.is->shares) {
      row(share.name, share_of(pair.was, share.name), share.milliseconds);
    }
  }
  if (pair.was) {
    for (auto const& share : pair.was->shares) {
      if (!share_of(pair.is, share.name)) row(share.name, share.milliseconds, std::nullopt);
    }
  }
  auto const total = [](AxisDelay const& delay) { return delay.total; };
  row(subject.say(says::delay_total), figure_of(pair.was, total), figure_of(pair.is, total));
  bool const starts_otherwise = (pair.is && pair.is->at_start) || (pair.was && pair.was->at_start);
  if (!starts_otherwise) return;
  auto const at_start = [](AxisDelay const& delay) { return delay.at_start.value_or(delay.total); };
  row(subject.say(says::delay_at_start), figure_of(pair.was, at_start), figure_of(pair.is, at_start));
}

pictures::Table delay_table(PlotSubject const& subject, std::vector<DelayPair> const& delays) {
  pictures::Table table;
  table.header = {subject.say(labels::axis), subject.say(labels::share)};
  if (subject.before) {
    table.header.push_back(subject.say(says::delay_was));
    table.header.push_back(subject.say(says::delay_is));
    table.header.push_back(subject.say(labels::difference));
  } else {
    table.header.push_back(subject.say(labels::group_delay) + " [ms]");
  }
  for (auto const& pair : delays) add_rows(table, subject, pair);
  return table;
}

}  // namespace

pictures::Figure delay_figure(PlotSubject const& subject) {
  subject.require_drawable();
  auto const pairs = delays_of(subject);
  std::vector<AxisDelay> delays;
  for (auto const& pair : pairs) {
    if (pair.was) delays.push_back(*pair.was);
    if (pair.is) delays.push_back(*pair.is);
  }
  pictures::Figure figure;
  bool const starts_otherwise = std::any_of(delays.begin(), delays.end(),
                                            [](AxisDelay const& axis) { return axis.at_start.has_value(); });
  figure.title =
      subject.say(starts_otherwise ? SentenceRef(says::delay_title_on) : SentenceRef(says::delay_title),
                  {{"axes", subject.names()}});
  if (pairs.size() > subject.axes.size()) {
    figure.title = subject.say(says::delay_with_velocity, {{"title", figure.title}});
  }
  for (auto const& axis : delays) {
    figure.description +=
        (figure.description.empty() ? "" : "; ") +
        subject.say(axis.at_start ? SentenceRef(says::delay_said_both) : SentenceRef(says::delay_said),
                    {{"axis", axis.name},
                     {"delay", format_rounded(axis.total, delay_digits)},
                     {"start", format_rounded(axis.at_start.value_or(axis.total), delay_digits)}});
  }
  figure.table = delay_table(subject, pairs);
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
