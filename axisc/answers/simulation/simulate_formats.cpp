#include "axisc/answers/simulation/simulate_formats.hpp"

#include "axisc/answers/json_text.hpp"
#include "axisc/answers/text_table.hpp"
#include "axisc/files/csv.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/terminal.hpp"

#include <fmt/format.h>

namespace axisc::says {

constexpr Sentence block{"block", "Satz"};
constexpr Sentence pass{"pass", "Durchgang"};
constexpr Sentence line{"line", "Zeile"};
constexpr Sentence time{"time [s]", "Zeit [s]"};
constexpr Sentence axis_error{"axis error [µm]", "Achsfehler [µm]"};
constexpr Sentence deviation{"deviation [µm]", "Abweichung [µm]"};
constexpr Sentence lag{"lag [µm]", "Nachlauf [µm]"};
constexpr Sentence start{"as at start-up", "wie beim Hochlauf"};
constexpr Sentence exceeds{"{command}: AX_DEV is not kept", "{command}: AX_DEV wird nicht eingehalten"};
constexpr Sentence total{"{blocks} blocks, {cycles} cycles of {cycle_time} µs, {time} s",
                         "{blocks} Sätze, {cycles} Zyklen zu {cycle_time} µs, {time} s"};

}  // namespace axisc::says

namespace axisc {

namespace {

using motion::PathSummary;
using motion::units_per_mm;
using motion::units_per_um;

constexpr std::size_t piece = std::size_t{1} << 16U;

/// Fields that blocks and passes share.
std::string figures_json(PathSummary const& summary, SimulatedPath const& path) {
  std::string text = "\"time_s\": " + json_number(summary.cycles * path.cycle_time.seconds()) +
                     ", \"max_axis_error_um\": " + json_number(summary.largest_axis_error() / units_per_um) +
                     ", \"axis_error_um\": {";
  for (std::size_t i = 0; i < path.axes.size(); ++i) {
    if (i > 0) text += ", ";
    text += json_string(path.axes[i]) + ": " + json_number(summary.axis_error[i] / units_per_um);
  }
  return text + "}, \"max_contour_deviation_um\": " + json_number(summary.deviation / units_per_um) +
         ", \"max_lag_um\": " + json_number(summary.lag / units_per_um);
}

class JsonSummary final : public SummaryWriter {
 public:
  JsonSummary(SimulatedPath const& path, TextSink sink) : path_(path), sink_(std::move(sink)) {
    text_ = "{\n  \"version\": 1,\n  \"cycle_time_us\": " + json_number(path.cycle_time.microseconds()) +
            ",\n  \"group\": " + json_string(path.group) + ",\n  \"axes\": [";
    for (auto const& axis : path.axes) text_ += (text_.back() == '[' ? "" : ", ") + json_string(axis);
    text_ += "],\n  \"blocks\": [";
  }

  void block(motion::BlockSummary const& summary) override {
    text_ += any_ ? ",\n    " : "\n    ";
    any_ = true;
    text_ += "{\"block\": " + json_string(summary.label) + ", \"line\": " + std::to_string(summary.line) +
             ", " + figures_json(summary, path_) + "}";
    if (text_.size() < piece) return;
    sink_(text_);
    text_.clear();
  }

  void pass(motion::PassSummary const& summary) override {
    std::string const kept = !summary.tolerance ? "null" : summary.keeps_tolerance() ? "true" : "false";
    passes_ += passes_.empty() ? "\n    " : ",\n    ";
    passes_ += "{\"pass\": " + std::to_string(++count_) +
               ", \"command\": " + (summary.command.empty() ? "null" : json_string(summary.command)) +
               ", \"line\": " + (summary.line == 0 ? "null" : std::to_string(summary.line)) +
               ", \"blocks\": " + std::to_string(summary.blocks) + ", " + figures_json(summary, path_) +
               ", \"tolerance_um\": " +
               (summary.tolerance ? json_number(*summary.tolerance / units_per_um) : "null") +
               ", \"tolerance_kept\": " + kept + "}";
  }

  void finish(std::uint64_t blocks, std::uint64_t cycles) override {
    text_ += std::string(any_ ? "\n  ]" : "]") + ",\n  \"passes\": [" + passes_ +
             (passes_.empty() ? "]" : "\n  ]") + ",\n  \"block_count\": " + std::to_string(blocks) +
             ",\n  \"cycles\": " + std::to_string(cycles) +
             ",\n  \"time_s\": " + json_number(static_cast<double>(cycles) * path_.cycle_time.seconds()) +
             "\n}\n";
    sink_(text_);
  }

 private:
  SimulatedPath const& path_;
  TextSink sink_;
  std::string text_, passes_;
  bool any_ = false;
  std::size_t count_ = 0;
};

class TextSummary final : public SummaryWriter {
 public:
  TextSummary(SimulatedPath const& path, Language language, TextSink sink)
      : path_(path), language_(language), sink_(std::move(sink)) {
    row(say(says::block), say(says::line), summary_headings(language_));
  }

  void block(motion::BlockSummary const& summary) override {
    row(summary.label, std::to_string(summary.line), cells(summary));
    if (text_.size() < piece) return;
    sink_(text_);
    text_.clear();
  }

  void pass(motion::PassSummary const& summary) override {
    std::swap(text_, passes_);
    if (text_.empty()) row(say(says::pass), say(says::line), summary_headings(language_));
    row(std::to_string(++count_), summary.line == 0 ? "" : std::to_string(summary.line), cells(summary));
    text_.insert(text_.size() - 1, "  " + printable(pass_name(summary, language_)));
    std::swap(text_, passes_);
  }

  void finish(std::uint64_t blocks, std::uint64_t cycles) override {
    double const seconds = static_cast<double>(cycles) * path_.cycle_time.seconds();
    text_ += "\n" + passes_ + "\n" +
             render({.sentence = says::total,
                     .arguments = {{"blocks", std::to_string(blocks)},
                                   {"cycles", std::to_string(cycles)},
                                   {"cycle_time", exact_number(path_.cycle_time.microseconds())},
                                   {"time", format_fixed(seconds, 3)}}},
                    language_) +
             "\n";
    sink_(text_);
  }

 private:
  [[nodiscard]] std::string say(SentenceRef text) const {
    return render({.sentence = text, .arguments = {}}, language_);
  }

  [[nodiscard]] std::vector<std::string> cells(PathSummary const& summary) const {
    return summary_cells(summary, path_.cycle_time, language_);
  }

  void row(std::string const& name, std::string const& line, std::vector<std::string> const& cells) {
    auto const right = [](std::string const& cell, std::size_t width) {
      auto const used = display_width(cell);
      return std::string(used < width ? width - used : 0, ' ') + cell;
    };
    text_ += padded(printable(name), 12) + right(line, 8);
    for (auto const& cell : cells) text_ += right(cell, 17);
    text_ += "\n";
  }

  SimulatedPath const& path_;
  Language language_;
  TextSink sink_;
  std::string text_, passes_;
  std::size_t count_ = 0;
};

}  // namespace

std::string pass_name(motion::PassSummary const& summary, Language language) {
  std::string command = summary.command;
  if (command.empty()) command = render({.sentence = says::start, .arguments = {}}, language);
  if (summary.keeps_tolerance()) return command;
  return render({.sentence = says::exceeds, .arguments = {{"command", command}}}, language);
}

std::vector<std::string> summary_headings(Language language) {
  std::vector<std::string> names;
  for (SentenceRef const name : {SentenceRef(says::time), SentenceRef(says::axis_error),
                                 SentenceRef(says::deviation), SentenceRef(says::lag)}) {
    names.push_back(render({.sentence = name, .arguments = {}}, language));
  }
  return names;
}

std::vector<std::string> summary_cells(PathSummary const& summary, design::CycleTime cycle_time,
                                       Language language) {
  return {format_fixed(summary.cycles * cycle_time.seconds(), 4).in(language),
          format_fixed(summary.largest_axis_error() / units_per_um, 4).in(language),
          format_fixed(summary.deviation / units_per_um, 4).in(language),
          format_fixed(summary.lag / units_per_um, 3).in(language)};
}

CycleWriter::CycleWriter(SimulatedPath const& path, TextSink sink) : path_(path), sink_(std::move(sink)) {
  text_ = "time_s,block,path_velocity_mm_per_min";
  for (auto const& axis : path.axes) {
    for (auto const* const what : {".setpoint_mm", ".filtered_mm", ".axis_error_um"}) {
      text_ += ',';
      append_csv_name(text_, axis + what);
    }
  }
  text_ += ",contour_deviation_um\n";
}

void CycleWriter::cycle(motion::MeasuredPoint const& point, motion::BlockSummary const& block) {
  double const seconds = path_.cycle_time.seconds();
  // Rounded to whole nanoseconds, so that times have no rounding digits.
  double const time = static_cast<double>(++cycles_ * path_.cycle_time.nanoseconds) / 1e9;
  fmt::format_to(std::back_inserter(text_), "{},", time);
  append_csv_name(text_, block.label);
  text_ += ',';
  row_.clear();
  row_.push_back(point.point.velocity / units_per_mm / seconds * 60);
  for (std::size_t i = 0; i < path_.axes.size(); ++i) {
    row_.push_back(point.point.nominal[i] / units_per_mm);
    row_.push_back(point.filtered[i] / units_per_mm);
    row_.push_back(point.axis_error[i] / units_per_um);
  }
  row_.push_back(point.deviation / units_per_um);
  append_csv_row(text_, row_);
  if (text_.size() < piece) return;
  sink_(text_);
  text_.clear();
}

void CycleWriter::finish() {
  sink_(text_);
  text_.clear();
}

std::unique_ptr<SummaryWriter> text_summary(SimulatedPath const& path, Language language, TextSink sink) {
  return std::make_unique<TextSummary>(path, language, std::move(sink));
}

std::unique_ptr<SummaryWriter> json_summary(SimulatedPath const& path, TextSink sink) {
  return std::make_unique<JsonSummary>(path, std::move(sink));
}

}  // namespace axisc
