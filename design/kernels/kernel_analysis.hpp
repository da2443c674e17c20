// Analysis of a designed kernel: frequency response, delay, zeros, step response. Computed from the tail
// sums, which are what the image stores; a KernelDesign made of an image's tail_sums, half_width and
// delay_cycles is enough.
#pragma once

#include "design/filter_analysis.hpp"
#include "design/kernels/kernel_design.hpp"

#include <complex>
#include <vector>

namespace axisc::design {

/// Complex response at `frequency`, share included:
///     H = e^(-jhθ) A(θ),  A(θ) = 1 - 4 sin(θ/2) Σ_{i=0..h-1} S_(h+i) sin((i + ½)θ),  θ = 2π f T
/// Accurate to about 1e-14, next to 0 Hz to the last digit. Cost: about 1 µs.
[[nodiscard]] std::complex<double> response(KernelDesign const& kernel, Hertz frequency,
                                            CycleTime cycle_time);

/// The response as magnitude, phase and group delay. The group delay of a linear-phase kernel is h cycles at
/// every frequency (half as many as it has tail sums, with an even number of taps), also on its zeros, where
/// the phase jumps; that of a kernel that blends with the undelayed signal is NaN on its zeros.
[[nodiscard]] ResponsePoint kernel_response(KernelDesign const& kernel, Hertz frequency,
                                            CycleTime cycle_time);

/// Response of two systems in series: for chains of filters and a kernel.
[[nodiscard]] ResponsePoint in_series(ResponsePoint const& first, ResponsePoint const& second);

/// Frequencies in 0..0.5/T with gain 0, rising, double zeros once; zeros between side lobes below -120 dB are
/// left out, because rounding of the tail sums moves them. Of kernels that blend with the undelayed signal
/// those of a time delay alone. Cost: up to 2 ms.
[[nodiscard]] std::vector<Hertz> zero_frequencies(KernelDesign const& kernel, CycleTime cycle_time);

/// From the unit step response  y[n] = 1 - S_n.  The peak gain Σ|b| is exactly 1 where no tap is negative.
[[nodiscard]] StepFigures step_figures(KernelDesign const& kernel, double tolerance);

}  // namespace axisc::design
