// The filtered path of the last cycles, and where it comes nearest to a point.
#pragma once

#include "analysis/motion/contour/nearest_point.hpp"
#include "analysis/motion/point.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace axisc::motion {

class FilteredPath {
 public:
  explicit FilteredPath(std::size_t axes) : axes_(axes) {}

  /// Forgets all points, and keeps at least the last `points` from now on; the next point is that of `cycle`.
  void begin(std::size_t points, std::uint64_t cycle);
  void append(Point const& point);

  /// Cycles of the points that are kept: from `oldest()` up to, not including, `end()`.
  [[nodiscard]] std::uint64_t oldest() const { return end_ - first_ > mask_ ? end_ - (mask_ + 1) : first_; }
  [[nodiscard]] std::uint64_t end() const { return end_; }
  [[nodiscard]] Point const& at(std::uint64_t cycle) const { return passed_[cycle & mask_].point; }

  struct Nearest {
    NearestPoint point;
    std::uint64_t cycle = 0;  ///< after which it lies
  };

  /// The nearest point of the path between two cycles. Exact wherever `likely` lies between them, and quick
  /// where the nearest point is close to it: distances are computed for a logarithm of the cycles.
  [[nodiscard]] Nearest nearest(Point const& point, std::uint64_t first, std::uint64_t likely,
                                std::uint64_t last) const;

 private:
  struct Passed {
    Point point{};
    double way = 0;  ///< along the path up to here, position units
  };
  struct Search;

  [[nodiscard]] Passed const& passed(std::uint64_t cycle) const { return passed_[cycle & mask_]; }

  std::size_t axes_;
  std::vector<Passed> passed_;
  std::uint64_t mask_ = 0;
  std::uint64_t first_ = 0;
  std::uint64_t end_ = 0;
};

}  // namespace axisc::motion
