// Compares a path with what the filters make of it, point by point and in constant memory.
//
// Contour deviation of a point of the path is its distance from the filtered path, axis error each component
// of the vector to the nearest point there. A point is measured as soon as the filtered path has left its
// surroundings.
#pragma once

#include "analysis/motion/chain_answer.hpp"
#include "analysis/motion/contour/filtered_path.hpp"
#include "analysis/motion/point.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace axisc::motion {

/// A point of the path: a setpoint, or a corner between two of them.
struct ContourPoint {
  bool is_corner = false;
  std::uint64_t cycle = 0;       ///< of the setpoint, or of the one before the corner
  std::uint64_t block = 0;       ///< that the point lies on
  std::uint64_t next_block = 0;  ///< of a corner: the block that begins there
  double velocity = 0;           ///< of the path, units per cycle
  Point nominal{};               ///< position units
};

/// The measurement of a point; position units.
struct MeasuredPoint {
  ContourPoint point;
  Point filtered{};    ///< output of the runtime in the cycle of the setpoint
  Point axis_error{};  ///< absolute values
  double deviation = 0;
  /// How far the filtered setpoint, its constant delay taken off, runs behind (or ahead) along a straight
  /// stretch.
  std::optional<double> lag;
};

class MeasuredSink {
 public:
  virtual ~MeasuredSink() = default;
  virtual void measured(MeasuredPoint const& point) = 0;

 protected:
  MeasuredSink() = default;
  MeasuredSink(MeasuredSink const&) = default;
  MeasuredSink& operator=(MeasuredSink const&) = default;
};

class ContourMeter {
 public:
  ContourMeter(std::size_t axes, MeasuredSink& sink) : sink_(sink), path_(axes) {}

  /// Chains of the axes from now on; the path has rested at `position` for long.
  void begin(std::span<ChainAnswer const> answers, Point const& position);
  /// The setpoint of the next cycle, and the runtime's output in that cycle.
  void cycle(ContourPoint point, Point const& filtered);
  /// A setpoint that is not measured itself, and the output.
  void pass(Point const& nominal, Point const& filtered);
  /// A corner after the last setpoint. Filters that only delay, all axes alike, leave it where it is: it is
  /// not measured.
  void corner(ContourPoint point);
  /// Measures a point next to the one that was measured last: `point.cycle` is the cycle of that one.
  [[nodiscard]] MeasuredPoint look(ContourPoint const& point);
  /// Setpoints so far, that of begin() included: the cycle of the next one.
  [[nodiscard]] std::uint64_t cycles() const { return cycles_; }
  /// Measures the remaining points.
  void finish();

  /// Chains longer than this are searched through this far only.
  static constexpr double longest_reach = 400;

 private:
  struct Setpoint {
    Point nominal{};
    std::uint64_t straight = 0;  ///< setpoints on one straight line up to this one
    Point direction{};
  };

  void measure(ContourPoint const& point);
  [[nodiscard]] std::optional<double> lag_of(ContourPoint const& point) const;
  [[nodiscard]] Setpoint const& at(std::uint64_t cycle) const { return setpoints_[cycle & mask_]; }

  MeasuredSink& sink_;
  std::uint64_t cycles_ = 0;  ///< setpoints so far
  FilteredPath path_;
  std::vector<Setpoint> setpoints_;  ///< as many as the path keeps
  std::uint64_t mask_ = 0;
  std::int64_t ahead_ = 0;              ///< cycles from a point to where the path is likely to be nearest
  std::int64_t from_ = 0, to_ = 1;      ///< surroundings of a point in the filtered path, in cycles after it
  bool alike_delays_ = true;            ///< the chains do nothing but delay all axes alike
  std::optional<std::uint64_t> delay_;  ///< the same whole number in all axes
  std::uint64_t reach_ = 0;
  std::deque<ContourPoint> pending_;
};

}  // namespace axisc::motion
