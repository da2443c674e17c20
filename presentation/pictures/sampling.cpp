#include "presentation/pictures/sampling.hpp"

#include "presentation/pictures/projection.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::pictures {
namespace {

class Sampler {
 public:
  Sampler(Axis const& x, Axis const& y, std::function<double(double)> const& function)
      : scale_(x.scale),
        across_(x, panel_left, panel_right),
        up_(y, usual_panel_height, 0),
        function_(function) {}

  std::vector<Point> run(std::vector<double> const& starts) {
    points_.push_back(at(starts.front()));
    for (std::size_t i = 1; i < starts.size(); ++i) refine(points_.back(), at(starts[i]));
    return std::move(points_);
  }

 private:
  /// Where a jump is bracketed closely enough.
  static constexpr double narrow = 0.004;

  [[nodiscard]] Point at(double x) const { return {.x = x, .y = function_(x)}; }

  [[nodiscard]] double between(double a, double b, double share) const {
    if (scale_ == Scale::linear) return a + (b - a) * share;
    return a * std::pow(b / a, share);
  }

  /// Between two neighbours: at uneven places, so that no symmetry hides a bend.
  [[nodiscard]] bool is_straight(Point const& a, Point const& b, Point const& middle) const {
    bool const interrupted = std::isnan(a.y);
    if (interrupted != std::isnan(b.y) || interrupted != std::isnan(middle.y)) return false;
    if (interrupted) return true;
    for (double const share : {0.5, 0.21, 0.79}) {
      Point const point = share == 0.5 ? middle : at(between(a.x, b.x, share));
      if (std::isnan(point.y)) return false;
      double const drawn = up_(a.y) + (up_(b.y) - up_(a.y)) * share;
      if (std::abs(up_(point.y) - drawn) > largest_error) return false;
    }
    return true;
  }

  /// Adds all points after `a` up to `b`.
  void refine(Point const& a, Point const& b) {
    std::vector<Point> ends{b};
    Point begin = a;
    while (!ends.empty()) {
      Point const end = ends.back();
      Point const middle = at(between(begin.x, end.x, 0.5));
      if (across_(end.x) - across_(begin.x) > narrow && !is_straight(begin, end, middle)) {
        ends.push_back(middle);
        continue;
      }
      points_.push_back(end);
      begin = end;
      ends.pop_back();
    }
  }

  Scale scale_;
  Projection across_, up_;
  std::function<double(double)> const& function_;
  std::vector<Point> points_;
};

}  // namespace

std::vector<Point> sample(Axis const& x, Axis const& y, std::span<double const> exact,
                          std::function<double(double)> const& function) {
  constexpr int pieces = 352;
  std::vector<double> starts;
  for (int i = 0; i <= pieces; ++i) {
    double const share = static_cast<double>(i) / pieces;
    starts.push_back(x.scale == Scale::linear ? x.low + (x.high - x.low) * share
                                              : x.low * std::pow(x.high / x.low, share));
  }
  starts.back() = x.high;
  std::copy_if(exact.begin(), exact.end(), std::back_inserter(starts),
               [&](double value) { return value > x.low && value < x.high; });
  std::sort(starts.begin(), starts.end());
  starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
  return Sampler(x, y, function).run(starts);
}

}  // namespace axisc::pictures
