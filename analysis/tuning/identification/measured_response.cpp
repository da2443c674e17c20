#include "analysis/tuning/identification/measured_response.hpp"

#include "analysis/tuning/identification/fourier.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axisc::tuning {
namespace {

using Complex = std::complex<double>;

std::vector<Complex> windowed(std::span<double const> signal) {
  auto const count = static_cast<double>(signal.size());
  double mean = 0;
  for (double const value : signal) mean += value / count;
  std::vector<Complex> values;
  values.reserve(signal.size());
  for (std::size_t n = 0; n < signal.size(); ++n) {
    double const window = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(n) / count);
    values.emplace_back(window * (signal[n] - mean));
  }
  transform(values);
  return values;
}

}  // namespace

double MeasuredResponse::resolution() const {
  return frequency.size() > 1
             ? (frequency.back() - frequency.front()) / static_cast<double>(frequency.size() - 1)
             : 0;
}

MeasuredResponse estimate_response(std::span<double const> in, std::span<double const> out,
                                   double sampling_rate, std::size_t length) {
  std::size_t const count = std::min(in.size(), out.size());
  std::size_t const bins = length / 2;
  std::vector<double> xx(bins), yy(bins);
  std::vector<Complex> xy(bins);
  for (std::size_t begin = 0; begin + length <= count; begin += length / 2) {
    auto const x = windowed(in.subspan(begin, length));
    auto const y = windowed(out.subspan(begin, length));
    for (std::size_t k = 0; k < bins; ++k) {
      xx[k] += std::norm(x[k]);
      yy[k] += std::norm(y[k]);
      xy[k] += std::conj(x[k]) * y[k];
    }
  }
  MeasuredResponse found;
  found.has_phase = true;
  for (std::size_t k = 1; k < bins; ++k) {
    double const power = xx[k] * yy[k];
    found.frequency.push_back(static_cast<double>(k) * sampling_rate / static_cast<double>(length));
    found.response.push_back(xx[k] > 0 ? xy[k] / xx[k] : 0);
    found.coherence.push_back(power > 0 ? std::norm(xy[k]) / power : 0);
    found.excitation.push_back(xx[k]);
  }
  return found;
}

}  // namespace axisc::tuning
