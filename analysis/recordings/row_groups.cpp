#include "analysis/recordings/row_groups.hpp"

#include "analysis/recordings/fields.hpp"
#include "analysis/recordings/text_encoding.hpp"
#include "analysis/recordings/time_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace axisc::recordings {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
/// A step of times without a unit that is shorter is in seconds: 15 ms; or else 15 µs, which no scope
/// samples.
constexpr double longest_step_in_seconds = 0.015;

bool is_same_or_missing(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

RowGroups::RowGroups(Layout layout) : layout_(std::move(layout)) {}

std::optional<DecimalNumber> RowGroups::number_of(std::string_view field) {
  auto const number = parse_number(field);
  if (number) {
    has_point_ = has_point_ || number->mark == DecimalMark::point;
    has_comma_ = has_comma_ || number->mark == DecimalMark::comma;
  }
  return number;
}

void RowGroups::break_clock(Clock& clock, ClockProblem problem, std::uint64_t number, std::string_view text) {
  clock.problem = problem;
  clock.place = {.line = number, .text = shown_text(text)};
}

bool RowGroups::is_blank(FieldGroup const& group) const {
  auto const begin = fields_.begin() + static_cast<std::ptrdiff_t>(group.first);
  auto const end = std::min(fields_.size(), group.first + group.fields());
  return std::all_of(begin, fields_.begin() + static_cast<std::ptrdiff_t>(end),
                     [](std::string_view field) { return field.empty(); });
}

std::optional<BadRecording> RowGroups::add(std::string_view line, std::uint64_t number) {
  split_fields(line, layout_.separator, fields_);
  while (fields_.size() > layout_.fields && fields_.back().empty()) fields_.pop_back();
  auto const refused = [&](RecordingProblem problem) {
    return BadRecording{
        .problem = problem, .line = number, .fields = fields_.size(), .expected = layout_.fields};
  };
  if (fields_.size() > layout_.fields) {
    bool const has_commas = layout_.separator == ',' && layout_.recording.form == Form::scope_text;
    return refused(has_commas ? RecordingProblem::comma_separator : RecordingProblem::field_count);
  }
  ++rows_;
  last_line_ = number;
  for (auto const& group : layout_.groups) {
    if (group.first >= fields_.size() || is_blank(group)) {
      has_ended_ = true;
      continue;
    }
    if (group.first + group.fields() > fields_.size()) return refused(RecordingProblem::field_count);
    if (auto bad = add_group(group, number)) return bad;
  }
  return std::nullopt;
}

std::optional<BadRecording> RowGroups::add_group(FieldGroup const& group, std::uint64_t number) {
  auto& clock = layout_.recording.clocks[group.clock];
  if (clock.problem) return std::nullopt;
  std::size_t field = group.first;
  double time = 0;
  if (group.has_time) {
    auto const text = fields_[field++];
    auto const parsed = number_of(text);
    if (!parsed || !std::isfinite(parsed->value)) {
      break_clock(clock, text.empty() ? ClockProblem::no_time : ClockProblem::not_a_number, number, text);
      return std::nullopt;
    }
    time = parsed->value;
  }
  values_.clear();
  for (std::size_t i = 0; i < group.values; ++i) {
    auto const text = fields_[field + i];
    auto const parsed = text.empty() ? std::nullopt : number_of(text);
    values_.push_back(parsed ? parsed->value : missing);
    bool const is_bad = !text.empty() && !(parsed && std::isfinite(parsed->value));
    auto& channel = layout_.recording.channels[group.channel + i];
    if (is_bad && !channel.bad) channel.bad = BadField{.line = number, .text = shown_text(text)};
  }
  if (has_point_ && has_comma_) {
    return BadRecording{.problem = RecordingProblem::mixed_marks, .line = number};
  }
  add_sample(group, number, time);
  return std::nullopt;
}

void RowGroups::add_sample(FieldGroup const& group, std::uint64_t number, double time) {
  auto& recording = layout_.recording;
  auto& clock = recording.clocks[group.clock];
  if (group.has_time && clock.samples > 0 && time <= clock.times.back()) {
    bool is_repeated = time == clock.times.back();
    for (std::size_t i = 0; i < group.values; ++i) {
      is_repeated =
          is_repeated && is_same_or_missing(values_[i], recording.channels[group.channel + i].values.back());
    }
    if (is_repeated) {
      ++clock.repeated;
      return;
    }
    bool const falls = time < clock.times.back();
    break_clock(clock, falls ? ClockProblem::falls : ClockProblem::two_values, number, fields_[group.first]);
    return;
  }
  if (group.has_time) clock.times.push(time);
  clock.lines.push(static_cast<double>(number));
  ++clock.samples;
  for (std::size_t i = 0; i < group.values; ++i) {
    recording.channels[group.channel + i].values.push(values_[i]);
  }
}

std::optional<BadRecording> RowGroups::different_spans() const {
  if (has_ended_) return std::nullopt;
  std::vector<Clock const*> timed;
  for (auto const& clock : layout_.recording.clocks) {
    if (!clock.is_counted && !clock.problem && clock.samples > 1) timed.push_back(&clock);
  }
  for (auto const* const clock : timed) {
    auto const& first = *timed.front();
    // A slower group begins before the others, and ends before them.
    constexpr double slightly_more = 1.01;
    double const apart = slightly_more * std::max(usual_step(first.times), usual_step(clock->times));
    if (std::abs(clock->times.front() - first.times.front()) > apart ||
        std::abs(clock->times.back() - first.times.back()) > apart) {
      return BadRecording{.problem = RecordingProblem::different_spans, .line = last_line_};
    }
  }
  return std::nullopt;
}

std::variant<Recording, BadRecording> RowGroups::finish() {
  if (auto bad = different_spans()) return *std::move(bad);
  auto& recording = layout_.recording;
  for (std::size_t i = 0; i < recording.clocks.size(); ++i) {
    auto& clock = recording.clocks[i];
    bool const is_short = clock.samples > 1 && usual_step(clock.times) < longest_step_in_seconds;
    auto const guessed = is_short ? TimeUnit::seconds : TimeUnit::milliseconds;
    if (!clock.is_counted) clock.unit = layout_.units[i].value_or(guessed);
  }
  return std::move(recording);
}

}  // namespace axisc::recordings
