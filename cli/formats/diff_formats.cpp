#include "cli/formats/diff_formats.hpp"

#include "cli/formats/parameter_facts.hpp"
#include "cli/formats/sentences.hpp"
#include "cli/report/text_table.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/terminal.hpp"

#include <cmath>
#include <vector>

namespace axisc::cli::says {

constexpr Sentence nothing{"{before} and {after} mean the same", "{before} und {after} bedeuten dasselbe"};
constexpr Sentence axis{"axis {axis}", "Achse {axis}"};
constexpr Sentence present{"present", "vorhanden"};
constexpr Sentence diff_default{"{value} (default)", "{value} (Standardwert)"};
constexpr Sentence old_place{"old {place}", "alt {place}"};
constexpr Sentence new_place{"new {place}", "neu {place}"};
constexpr Sentence what{"what", "was"};
constexpr Sentence parameter{"parameter", "Parameter"};
constexpr Sentence effect{"effect", "Wirkung"};
constexpr Sentence before{"before", "vorher"};
constexpr Sentence after{"after", "nachher"};
constexpr Sentence delay{"delay", "Verzögerung"};
constexpr Sentence settling{"settling time (0.01 %)", "Einschwingzeit (0,01 %)"};
constexpr Sentence longer{"longer than {time}", "länger als {time}"};
constexpr Sentence overshoot{"overshoot of a step", "Überschwingen eines Sprungs"};
constexpr Sentence gain{"gain at {frequency} Hz", "Verstärkung bei {frequency} Hz"};
constexpr Sentence corner{"deviation at a 90° corner, {feed} mm/min",
                          "Abweichung an einer 90°-Ecke, {feed} mm/min"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

constexpr int figures = 4;

/// One line: what, before, after, and where.
struct Line {
  std::string what, before, after, where;
};

class Lines {
 public:
  Lines(ShownDifference const& shown, Language language) : shown_(shown), language_(language) {}

  [[nodiscard]] std::string say(SentenceRef text, std::vector<Argument> arguments = {}) const {
    return render({.sentence = text, .arguments = std::move(arguments)}, language_);
  }

  /// Changes of the machine as a whole.
  [[nodiscard]] std::vector<Line> machine() const {
    auto const& difference = shown_.difference;
    std::vector<Line> lines;
    if (difference.cycle_time_before != difference.cycle_time_after) {
      lines.push_back({say(says::inspect_cycle_time),
                       cycle_time(difference.cycle_time_before),
                       cycle_time(difference.cycle_time_after),
                       {}});
    }
    for (auto const& axis : difference.axes_removed) {
      lines.push_back({say(says::axis, {{"axis", axis}}), say(says::present), "-", {}});
    }
    for (auto const& axis : difference.axes_added) {
      lines.push_back({say(says::axis, {{"axis", axis}}), "-", say(says::present), {}});
    }
    return lines;
  }

  [[nodiscard]] std::vector<Line> parameters(image::AxisChange const& axis) const {
    std::vector<Line> lines;
    for (auto const& change : axis.parameters) {
      auto const otherwise = default_of(change);
      lines.push_back(
          {change.name, value(change.before, otherwise), value(change.after, otherwise), places(change)});
    }
    return lines;
  }

  [[nodiscard]] std::string places(image::ParameterChange const& change) const {
    if (change.place_before.empty()) return say(says::new_place, {{"place", change.place_after}});
    auto const before = say(says::old_place, {{"place", change.place_before}});
    return change.place_after.empty() ? before
                                      : before + ", " + say(says::new_place, {{"place", change.place_after}});
  }

  [[nodiscard]] std::vector<Line> effects(image::AxisChange const& axis) const {
    if (!axis.filtering_changed) return {};
    auto const& difference = shown_.difference;
    std::vector<Line> lines;
    lines.push_back({say(says::delay),
                     time(axis.before.delay_cycles, difference.cycle_time_before),
                     time(axis.after.delay_cycles, difference.cycle_time_after),
                     {}});
    lines.push_back({say(says::settling),
                     settling(axis.before, difference.cycle_time_before),
                     settling(axis.after, difference.cycle_time_after),
                     {}});
    lines.push_back({say(says::overshoot),
                     format_rounded(axis.before.overshoot * 100, figures) + " %",
                     format_rounded(axis.after.overshoot * 100, figures) + " %",
                     {}});
    for (auto const& gain : axis.gains) {
      lines.push_back({say(says::gain, {{"frequency", format_rounded(gain.frequency.value, figures)}}),
                       decibel(gain.before),
                       decibel(gain.after),
                       {}});
    }
    lines.push_back({say(says::corner, {{"feed", format_exact(shown_.feed_mm_per_min)}}),
                     corner(axis.before, difference.cycle_time_before),
                     corner(axis.after, difference.cycle_time_after),
                     {}});
    return lines;
  }

 private:
  static std::string cycle_time(design::CycleTime time) { return format_exact(time.microseconds()) + " µs"; }

  [[nodiscard]] std::string value(std::optional<std::string> const& text,
                                  std::optional<std::string> const& otherwise) const {
    if (text) return *text;
    if (!otherwise) return "-";
    return say(says::diff_default, {{"value", otherwise->empty() ? "\"\"" : *otherwise}});
  }
  static std::string time(double cycles, design::CycleTime cycle_time) {
    return format_rounded(cycles * cycle_time.seconds() * 1e3, figures) + " ms";
  }
  [[nodiscard]] std::string settling(image::ChainFigures const& figures_of_chain,
                                     design::CycleTime cycle_time) const {
    if (!figures_of_chain.settling_cycles) {
      return say(says::longer, {{"time", time(static_cast<double>(image::longest_settling), cycle_time)}});
    }
    return time(static_cast<double>(*figures_of_chain.settling_cycles), cycle_time);
  }
  static std::string decibel(double magnitude) {
    constexpr double nothing = 1e-10;
    if (magnitude < nothing) return "< -200 dB";
    return format_rounded(std::round(2000 * std::log10(magnitude)) / 100, figures + 1) + " dB";
  }
  [[nodiscard]] std::string corner(image::ChainFigures const& figures_of_chain,
                                   design::CycleTime cycle_time) const {
    auto const deviation = corner_deviation_um(figures_of_chain, shown_.feed_mm_per_min, cycle_time);
    return deviation ? format_rounded(*deviation, figures) + " µm" : "-";
  }

  ShownDifference const& shown_;
  Language language_;
};

std::string text_block(std::vector<Line> const& lines) {
  std::vector<std::vector<std::string>> rows;
  for (auto const& line : lines) {
    rows.push_back({line.what, line.before, "→", line.after});
    if (!line.where.empty()) rows.back().push_back(line.where);
  }
  return text_table(rows, 2);
}

/// A cell of a Markdown table: one line, without markup, links and names of users.
std::string cell(std::string const& text) {
  constexpr std::string_view markup = "|\\`*<~";
  std::string escaped;
  for (char const character : printable(text)) {
    if (markup.find(character) != std::string_view::npos) escaped += '\\';
    escaped += character;
    if (character == '@') escaped += "<!-- -->";
    bool const begins_link = escaped.ends_with("](") || escaped.ends_with("://") || escaped.ends_with("www.");
    if (begins_link) escaped.insert(escaped.size() - 1, 1, '\\');
  }
  return escaped;
}

std::string markdown_table(Lines const& words, std::vector<Line> const& lines, SentenceRef first_column) {
  if (lines.empty()) return {};
  std::string text = "\n| " + words.say(first_column) + " | " + words.say(says::before) + " | " +
                     words.say(says::after) + " |\n|---|---|---|\n";
  for (auto const& line : lines) {
    auto const where = line.where.empty() ? std::string() : " (" + line.where + ")";
    text += "| " + cell(line.what + where) + " | " + cell(line.before) + " | " + cell(line.after) + " |\n";
  }
  return text;
}

}  // namespace

std::optional<std::string> default_of(image::ParameterChange const& change) {
  auto const* const row = schema::find(change.name).row;
  return row != nullptr && change.default_text ? std::optional(default_text(*row)) : change.default_text;
}

std::optional<double> corner_deviation_um(image::ChainFigures const& figures_of_chain, double feed,
                                          design::CycleTime cycle_time) {
  if (!figures_of_chain.corner_deviation) return std::nullopt;
  constexpr double um_per_mm = 1000;
  constexpr double seconds_per_minute = 60;
  return *figures_of_chain.corner_deviation * feed * um_per_mm / seconds_per_minute * cycle_time.seconds();
}

std::string diff_text(ShownDifference const& shown, Language language) {
  Lines const words(shown, language);
  if (shown.difference.empty()) {
    return words.say(says::nothing, {{"before", shown.before}, {"after", shown.after}}) + "\n";
  }
  std::string text = printable(shown.before + " → " + shown.after) + "\n" + text_block(words.machine());
  for (auto const& axis : shown.difference.axes) {
    text += "\n" + words.say(says::axis, {{"axis", axis.name}}) + "\n" + text_block(words.parameters(axis));
    if (axis.filtering_changed) text += "\n" + text_block(words.effects(axis));
  }
  return text;
}

std::string diff_markdown(ShownDifference const& shown, Language language) {
  Lines const words(shown, language);
  if (shown.difference.empty()) {
    return words.say(says::nothing, {{"before", cell(shown.before)}, {"after", cell(shown.after)}}) + "\n";
  }
  std::string text = "**" + cell(shown.before) + " → " + cell(shown.after) + "**\n";
  text += markdown_table(words, words.machine(), says::what);
  for (auto const& axis : shown.difference.axes) {
    text += "\n### " + words.say(says::axis, {{"axis", cell(axis.name)}}) + "\n";
    text += markdown_table(words, words.parameters(axis), says::parameter);
    text += markdown_table(words, words.effects(axis), says::effect);
  }
  return text;
}

}  // namespace axisc::cli
