// The model of an axis, fitted to windows of its motion:
//
//     F = m a + b v + c sgn v + g               rigid
//     F = m a + b v + c sgn v + g + e x''''     elastic
// The elastic term is the first one of what a spring between motor and load adds: e is m_M m_L / k where the
// load is measured, -m_L²/k where the motor is. b and c are not negative.
#pragma once

#include "analysis/tuning/rigid_model/motion_windows.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace axisc::tuning {

enum class ModelForm : std::uint8_t { rigid, elastic };

/// Indices of m, b, c, g and e.
struct Term {
  enum Index : std::size_t { mass, viscous, coulomb, constant, elastic };
};
inline constexpr std::size_t model_terms = 5;
using ModelValues = std::array<double, model_terms>;

struct ModelFit {
  ModelValues values{};       ///< m, b, c, g, e
  ModelValues half_widths{};  ///< of the 95 % intervals, by resampling blocks of windows
  int dead_time = 0;          ///< samples by which the force comes after the motion: least median residual
  double explained = 0;       ///< of the force of every other window, by the fit to the other; the worse one
  double accelerating = 0;    ///< root mean square of m a, as a share of that of the varying force
  std::size_t length = 0, windows = 0;
};

/// Least squares with Huber's weights. None for fewer than fewest_blocks · windows_per_block windows, for too
/// few of a direction, and where the equations are singular. Cost: some 100 operations a window for each dead
/// time.
[[nodiscard]] std::optional<ModelFit> fit_model(std::span<MotionRecord const> records,
                                                std::vector<WindowMotion> const& motion, Window const& window,
                                                ModelForm form);

}  // namespace axisc::tuning
