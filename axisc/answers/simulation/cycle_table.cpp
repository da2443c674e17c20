#include "axisc/answers/simulation/cycle_table.hpp"

#include "analysis/motion/point.hpp"
#include "axisc/files/csv.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

namespace axisc {

namespace {

using motion::units_per_mm;
using motion::units_per_um;

constexpr std::size_t piece = std::size_t{1} << 16U;

}  // namespace

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

std::string plant_table(motion::LoopRecord const& without, motion::LoopRecord const& with,
                        double cycle_seconds) {
  std::string text =
      "time_s,setpoint_mm,load_without_mm,load_with_mm,load_acceleration_without_m_per_s2,"
      "load_acceleration_with_m_per_s2,additive_velocity_um_per_s\n";
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::size_t const count = std::max(without.cycles.size(), with.cycles.size());
  for (std::size_t n = 0; n < count; ++n) {
    bool const has_without = n < without.cycles.size();
    bool const has_with = n < with.cycles.size();
    auto const& a = has_without ? without.cycles[n] : with.cycles[n];
    auto const& b = has_with ? with.cycles[n] : without.cycles[n];
    append_csv_row(text,
                   std::array{static_cast<double>(n) * cycle_seconds, a.setpoint / motion::units_per_mm,
                              has_without ? a.load_position / motion::units_per_mm : nan,
                              has_with ? b.load_position / motion::units_per_mm : nan,
                              has_without ? a.load_acceleration : nan, has_with ? b.load_acceleration : nan,
                              has_with ? b.additive_velocity : nan});
  }
  return text;
}

}  // namespace axisc
