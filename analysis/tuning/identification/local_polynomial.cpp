#include "analysis/tuning/identification/local_polynomial.hpp"

#include "analysis/tuning/identification/fourier.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace axisc::tuning {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t reach = local_reach;
constexpr std::size_t window_lines = 2 * reach + 1;
constexpr std::size_t terms = 3;

using Window = std::array<Complex, window_lines>;
using Powers = std::array<std::array<double, window_lines>, terms>;

/// (q/6)^o: another scale of h_1 and h_2, and better conditioned.
Powers powers() {
  Powers made{};
  for (std::size_t i = 0; i < window_lines; ++i) {
    double const q = (static_cast<double>(i) - reach) / reach;
    for (std::size_t o = 0; o < terms; ++o) made.at(o).at(i) = o == 0 ? 1 : made.at(o - 1).at(i) * q;
  }
  return made;
}

/// An orthonormal base of the leakage, by Gram and Schmidt.
Powers leakage_base() {
  auto base = powers();
  for (std::size_t o = 0; o < terms; ++o) {
    auto& one = base.at(o);
    for (std::size_t before = 0; before < o; ++before) {
      double product = 0;
      for (std::size_t i = 0; i < window_lines; ++i) product += one.at(i) * base.at(before).at(i);
      for (std::size_t i = 0; i < window_lines; ++i) one.at(i) -= product * base.at(before).at(i);
    }
    double square = 0;
    for (double const value : one) square += value * value;
    for (double& value : one) value /= std::sqrt(square);
  }
  return base;
}

/// Takes away what leakage explains: the t_po need not be solved for then.
void take_leakage(Window& window, Powers const& base) {
  for (auto const& one : base) {
    Complex product = 0;
    for (std::size_t i = 0; i < window_lines; ++i) product += window.at(i) * one.at(i);
    for (std::size_t i = 0; i < window_lines; ++i) window.at(i) -= product * one.at(i);
  }
}

/// Normal equations of h_0, h_1, h_2: left factor of the solution, and what the residual is.
struct Equations {
  std::array<std::array<Complex, terms>, terms> matrix{};
  std::array<Complex, terms> right{};
  double energy = 0;  ///< of Y

  void add(std::array<Window, terms> const& columns, Window const& output) {
    for (std::size_t a = 0; a < terms; ++a) {
      for (std::size_t i = 0; i < window_lines; ++i) {
        auto const conjugate = std::conj(columns.at(a).at(i));
        right.at(a) += conjugate * output.at(i);
        for (std::size_t b = 0; b < terms; ++b) matrix.at(a).at(b) += conjugate * columns.at(b).at(i);
      }
    }
    for (auto const& value : output) energy += std::norm(value);
  }
};

struct Solution {
  Complex response;
  double deviation = 0;
};

/// By Cholesky's decomposition, of which the columns are scaled to 1. None where the input is as smooth as
/// leakage, which it cannot be told from.
std::optional<Solution> solve(Equations const& equations, std::size_t freedom) {
  auto const& [matrix, right, energy] = equations;
  constexpr double smallest_pivot = 1e-10;
  std::array<double, terms> scale{};
  for (std::size_t i = 0; i < terms; ++i) {
    if (!(matrix.at(i).at(i).real() > 0)) return std::nullopt;
    scale.at(i) = 1 / std::sqrt(matrix.at(i).at(i).real());
  }
  // From the last unknown to the first: then h_0 and its variance are the last row's.
  std::array<std::array<Complex, terms>, terms> lower{};
  std::array<Complex, terms> forward{};
  double explained = 0;
  for (std::size_t row = 0; row < terms; ++row) {
    std::size_t const i = terms - 1 - row;
    auto rest = right.at(i) * scale.at(i);
    for (std::size_t column = 0; column <= row; ++column) {
      std::size_t const k = terms - 1 - column;
      auto sum = matrix.at(i).at(k) * scale.at(i) * scale.at(k);
      for (std::size_t m = 0; m < column; ++m) sum -= lower.at(row).at(m) * std::conj(lower.at(column).at(m));
      if (column < row) {
        lower.at(row).at(column) = sum / lower.at(column).at(column);
        rest -= lower.at(row).at(column) * forward.at(column);
      } else {
        if (!(sum.real() > smallest_pivot)) return std::nullopt;
        lower.at(row).at(row) = std::sqrt(sum.real());
      }
    }
    forward.at(row) = rest / lower.at(row).at(row);
    explained += std::norm(forward.at(row));
  }
  constexpr std::size_t last = terms - 1;
  double const diagonal = lower.at(last).at(last).real();
  double const residual = std::max(0.0, energy - explained) / static_cast<double>(freedom);
  return Solution{.response = forward.at(last) / diagonal * scale.front(),
                  .deviation = std::sqrt(residual) / diagonal * scale.front()};
}

std::vector<Complex> spectrum(std::span<double const> part) {
  double mean = 0;
  for (double const value : part) mean += value / static_cast<double>(part.size());
  std::vector<Complex> values;
  values.reserve(part.size());
  for (double const value : part) values.emplace_back(value - mean);
  transform(values);
  return values;
}

}  // namespace

LocalResponse local_response(std::span<double const> in, std::span<double const> out, double sampling_rate,
                             std::size_t count) {
  std::size_t const length = std::min(in.size(), out.size()) / count;
  std::vector<std::vector<Complex>> inputs, outputs;
  for (std::size_t part = 0; part < count; ++part) {
    inputs.push_back(spectrum(in.subspan(part * length, length)));
    outputs.push_back(spectrum(out.subspan(part * length, length)));
  }
  auto const power = powers();
  auto const base = leakage_base();
  std::size_t const freedom = count * window_lines - count * terms - terms;
  LocalResponse found;
  found.response.has_phase = true;
  for (std::size_t k = reach + 1; k + reach < length / 2; ++k) {
    Equations equations;
    double excitation = 0;
    for (std::size_t part = 0; part < count; ++part) {
      std::array<Window, terms> columns{};
      Window output{};
      for (std::size_t i = 0; i < window_lines; ++i) {
        output.at(i) = outputs[part][k + i - reach];
        for (std::size_t o = 0; o < terms; ++o) {
          columns.at(o).at(i) = inputs[part][k + i - reach] * power.at(o).at(i);
        }
      }
      excitation += std::norm(columns.front().at(reach));
      for (auto& column : columns) take_leakage(column, base);
      take_leakage(output, base);
      equations.add(columns, output);
    }
    auto const solution = solve(equations, freedom);
    found.response.frequency.push_back(static_cast<double>(k) * sampling_rate / static_cast<double>(length));
    found.response.response.push_back(solution ? solution->response : 0);
    found.response.excitation.push_back(excitation);
    found.deviation.push_back(solution ? solution->deviation : std::numeric_limits<double>::infinity());
  }
  return found;
}

}  // namespace axisc::tuning
