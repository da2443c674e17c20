// Output formats of `axisc simulate`, written during the simulation.
#pragma once

#include "analysis/motion/simulation.hpp"
#include "design/units.hpp"
#include "diagnostics/message.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// Receives text piece by piece.
using TextSink = std::function<void(std::string_view)>;

enum class SimulateFormat : std::uint8_t { text, csv, json };

struct SimulatedPath {
  std::string group;
  std::vector<std::string> axes;
  design::CycleTime cycle_time;
};

/// Every NC cycle as CSV: time, block, path velocity, per axis setpoint, filtered setpoint and axis error,
/// contour deviation.
class CycleWriter {
 public:
  CycleWriter(SimulatedPath const& path, TextSink sink);
  void cycle(motion::MeasuredPoint const& point, motion::BlockSummary const& block);
  void finish();

 private:
  SimulatedPath const& path_;
  TextSink sink_;
  std::string text_;
  std::vector<double> row_;
  std::uint64_t cycles_ = 0;
};

/// Names and values of a block's or pass' figures: time, axis error, contour deviation, lag.
[[nodiscard]] std::vector<std::string> summary_headings(Language language);
[[nodiscard]] std::vector<std::string> summary_cells(motion::PathSummary const& summary,
                                                     design::CycleTime cycle_time, Language language);

/// The command that a pass begins with, and whether it exceeds its tolerance.
[[nodiscard]] std::string pass_name(motion::PassSummary const& summary, Language language);

/// Blocks as they end, followed by the passes.
class SummaryWriter {
 public:
  virtual ~SummaryWriter() = default;
  SummaryWriter(SummaryWriter const&) = delete;
  SummaryWriter& operator=(SummaryWriter const&) = delete;
  virtual void block(motion::BlockSummary const& summary) = 0;
  virtual void pass(motion::PassSummary const& summary) = 0;
  virtual void finish(std::uint64_t blocks, std::uint64_t cycles) = 0;

 protected:
  SummaryWriter() = default;
};

[[nodiscard]] std::unique_ptr<SummaryWriter> text_summary(SimulatedPath const& path, Language language,
                                                          TextSink sink);
[[nodiscard]] std::unique_ptr<SummaryWriter> json_summary(SimulatedPath const& path, TextSink sink);

}  // namespace axisc
