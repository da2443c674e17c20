#include "presentation/pictures/projection.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::pictures {
namespace {

double scaled(Scale scale, double value) {
  return scale == Scale::linear ? value : std::log10(value);
}

}  // namespace

Projection::Projection(Axis const& axis, double begin, double end)
    : scale_(axis.scale),
      low_(scaled(axis.scale, axis.low)),
      high_(scaled(axis.scale, axis.high)),
      begin_(begin),
      end_(end) {}

double Projection::operator()(double value) const {
  double const share = (scaled(scale_, value) - low_) / (high_ - low_);
  // Also for -inf, of which a logarithmic quantity may well be.
  return begin_ + (end_ - begin_) * std::clamp(share, 0.0, 1.0);
}

void make_equal(Axis& x, Axis& y, double height) {
  double const across = (x.high - x.low) / (panel_right - panel_left);
  double const up = (y.high - y.low) / height;
  auto const widen = [](Axis& axis, double span) {
    double const middle = (axis.low + axis.high) / 2;
    axis.low = middle - span / 2;
    axis.high = middle + span / 2;
  };
  if (across > up) widen(y, across * height);
  if (up > across) widen(x, up * (panel_right - panel_left));
}

}  // namespace axisc::pictures
