// An NC program's path, drawn.
#pragma once

#include "analysis/motion/simulation.hpp"
#include "diagnostics/message.hpp"
#include "presentation/pictures/figure.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace axisc {

/// What is drawn of a path: the setpoints, thinned evenly where there are many, without losing the largest
/// deviation.
class PathRecorder final : public motion::SimulationListener {
 public:
  /// Axes of the group that span the plane.
  PathRecorder(std::size_t across, std::size_t up) : plane_(across, up) {}

  void cycle(motion::MeasuredPoint const& point, motion::BlockSummary const& block) override;
  void block(motion::BlockSummary const& summary) override;
  void pass(motion::PassSummary const& summary) override;

  struct Sample {
    double cycle = 0;
    double x = 0, y = 0;                    ///< programmed, mm
    double filtered_x = 0, filtered_y = 0;  ///< mm
    double deviation = 0;                   ///< µm
    double velocity = 0;                    ///< of the path, units per cycle
    std::uint32_t line = 0;
  };

  struct Block {
    std::uint32_t line = 0;
    double deviation = 0;  ///< µm
    double x = 0, y = 0;   ///< where it is largest, mm
  };

  [[nodiscard]] std::vector<Sample> const& samples() const { return samples_; }
  /// The blocks that deviate most, the worst first.
  [[nodiscard]] std::vector<Block> worst_blocks(std::size_t count) const;

  /// The first passes, and how many there are.
  [[nodiscard]] std::vector<motion::PassSummary> const& passes() const { return passes_; }
  [[nodiscard]] std::size_t pass_count() const { return pass_count_; }

  static constexpr std::size_t most_samples = 8192;
  static constexpr std::size_t most_passes = 200;

 private:
  void thin();

  std::pair<std::size_t, std::size_t> plane_;
  std::vector<Sample> samples_;
  std::vector<Block> blocks_;
  Block current_;
  std::uint64_t stride_ = 1, seen_ = 0;
  std::vector<motion::PassSummary> passes_;
  std::size_t pass_count_ = 0;
};

/// What the picture is about.
struct PathPlot {
  std::string program;
  std::pair<std::string, std::string> axes;  ///< of the plane
  double cycle_seconds = 0;
  std::optional<double> tolerance_um;  ///< blocks that exceed it are marked
};

/// Programmed and filtered path in a plane, the filtered one coloured by its deviation; below it deviation,
/// path velocity and path acceleration over time: what `simulate` computes.
[[nodiscard]] pictures::Figure path_figure(PathRecorder const& recorder, PathPlot const& plot,
                                           Language language);

}  // namespace axisc
