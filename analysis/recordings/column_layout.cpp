#include "analysis/recordings/column_layout.hpp"

#include "analysis/recordings/decimal_number.hpp"
#include "analysis/recordings/fields.hpp"
#include "analysis/recordings/objects.hpp"
#include "analysis/recordings/scaling.hpp"
#include "analysis/recordings/text_encoding.hpp"
#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axisc::recordings {

namespace {

bool is_time(std::string_view name) {
  auto const begin = name.substr(0, 4);
  return ascii::equal_ignoring_case(begin, "time") || ascii::equal_ignoring_case(begin, "zeit");
}

/// The last line of the header with as many fields.
std::vector<std::string> names_in(std::vector<TextLine> const& header, char separator, std::size_t count) {
  for (auto line = header.rbegin(); line != header.rend(); ++line) {
    auto const fields = fields_of(line->text, separator);
    if (fields.size() != count || usual_separator(line->text) != separator) continue;
    std::vector<std::string> names;
    for (auto const field : fields) names.push_back(utf8_text(field));
    return names;
  }
  return {};
}

/// Columns of the first rows; NaN where one has no number.
std::vector<std::vector<double>> columns_of(std::vector<TextLine> const& rows, char separator,
                                            std::size_t count) {
  std::vector<std::vector<double>> columns(count);
  for (auto const& row : rows) {
    auto const fields = fields_of(row.text, separator);
    for (std::size_t i = 0; i < count; ++i) {
      auto const number = i < fields.size() ? parse_number(fields[i]) : std::nullopt;
      columns[i].push_back(number ? number->value : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return columns;
}

struct Steps {
  bool rises = false;  ///< but for rows that are repeated
  double median = 0;
};

Steps steps_of(std::vector<double> const& values) {
  Steps found{.rises = true};
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size() && std::isfinite(values[i]); ++i) {
    double const step = values[i] - values[i - 1];
    if (!(step >= 0)) found.rises = false;
    if (step > 0) steps.push_back(step);
  }
  if (steps.empty()) return {};
  auto const middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  found.median = *middle;
  return found;
}

/// By column, of columns without names: times rise, and those of pairs begin together.
std::vector<bool> nameless_times(std::vector<TextLine> const& rows, char separator, std::size_t count) {
  std::vector<bool> times(count, false);
  if (count < 3) return times;
  auto const columns = columns_of(rows, separator, count);
  auto const first = steps_of(columns.front());
  times.front() = first.rises || rows.size() < 2;
  if (!times.front() || count % 2 != 0) return times;
  bool are_pairs = true;
  for (std::size_t i = 2; i < count; i += 2) {
    auto const steps = steps_of(columns[i]);
    double const apart = std::abs(columns[i].front() - columns.front().front());
    are_pairs =
        are_pairs && (rows.size() < 2 || (steps.rises && apart <= std::max(steps.median, first.median)));
  }
  for (std::size_t i = 2; are_pairs && i < count; i += 2) times[i] = true;
  return times;
}

std::optional<TimeUnit> unit_in(std::string_view name) {
  if (name.ends_with("_s") || name.ends_with("[s]") || name.ends_with("(s)")) return TimeUnit::seconds;
  if (ascii::lower_case(name).find("ms") != std::string::npos) return TimeUnit::milliseconds;
  return std::nullopt;
}

}  // namespace

Layout column_layout(std::vector<TextLine> const& header, std::vector<TextLine> const& rows) {
  Layout made;
  made.separator = usual_separator(rows.front().text);
  made.fields = fields_of(rows.front().text, made.separator).size();
  auto& recording = made.recording;
  auto names = names_in(header, made.separator, made.fields);
  recording.is_named = !names.empty();
  std::vector<bool> times(made.fields, false);
  if (recording.is_named) {
    std::transform(names.begin(), names.end(), times.begin(), is_time);
  } else {
    times = nameless_times(rows, made.separator, made.fields);
    for (std::size_t i = 0; i < made.fields; ++i) names.push_back(std::to_string(i + 1));
  }
  for (std::size_t i = 0; i < made.fields; ++i) {
    if (times[i] || i == 0) {
      made.groups.push_back({.first = i,
                             .clock = recording.clocks.size(),
                             .channel = recording.channels.size(),
                             .values = 0,
                             .has_time = times[i]});
      recording.clocks.push_back({.is_counted = !times[i]});
      made.units.push_back(recording.is_named ? unit_in(names[i]) : std::nullopt);
    }
    if (times[i]) continue;
    ++made.groups.back().values;
    auto const unit = unit_in_brackets(names[i]);
    recording.channels.push_back({.name = names[i],
                                  .column = i + 1,
                                  .clock = recording.clocks.size() - 1,
                                  .unit = std::string(thousandths_in(unit) ? unit : std::string_view())});
  }
  return made;
}

}  // namespace axisc::recordings
