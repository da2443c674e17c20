// Linear least squares with a few unknowns.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace axisc::motion {

/// Minimises  Σ w (row·x - right)²  by the normal equations: rows may be any number, and should be scaled so
/// that their entries are about 1.
template <std::size_t N>
class LeastSquares {
 public:
  void add(std::array<double, N> const& row, double right, double weight = 1) {
    for (std::size_t i = 0; i < N; ++i) {
      double const weighted = weight * row[i];
      for (std::size_t k = 0; k < N; ++k) matrix_[i][k] += weighted * row[k];
      matrix_[i][N] += weighted * right;
    }
  }

  /// As if its rows had been added here.
  void add(LeastSquares const& other) {
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t k = 0; k <= N; ++k) matrix_[i][k] += other.matrix_[i][k];
    }
  }

  /// The unknown is 0.
  void leave_out(std::size_t unknown) {
    for (std::size_t i = 0; i < N; ++i) matrix_[i][unknown] = 0;
    matrix_[unknown] = {};
    matrix_[unknown][unknown] = 1;
  }

  /// None where the equations are singular. Can be called once.
  [[nodiscard]] std::optional<std::array<double, N>> solve() {
    for (std::size_t column = 0; column < N; ++column) {
      auto const pivot = std::max_element(
          matrix_.begin() + static_cast<std::ptrdiff_t>(column), matrix_.end(),
          [&](auto const& a, auto const& b) { return std::abs(a[column]) < std::abs(b[column]); });
      if (!(std::abs((*pivot)[column]) > 1e-14)) return std::nullopt;
      std::swap(*pivot, matrix_[column]);
      for (std::size_t i = 0; i < N; ++i) {
        if (i == column) continue;
        double const factor = matrix_[i][column] / matrix_[column][column];
        for (std::size_t k = column; k <= N; ++k) matrix_[i][k] -= factor * matrix_[column][k];
      }
    }
    std::array<double, N> solution{};
    for (std::size_t i = 0; i < N; ++i) solution[i] = matrix_[i][N] / matrix_[i][i];
    return solution;
  }

 private:
  std::array<std::array<double, N + 1>, N> matrix_{};
};

}  // namespace axisc::motion
