// Discrete Fourier transform of any length.
#pragma once

#include <complex>
#include <vector>

namespace axisc::tuning {

/// X_k = Σ_n x_n e^(-2πj kn/N), in place. Powers of two by the radix-2 algorithm, other lengths as a
/// convolution of such a length (Bluestein 1970). Cost: N log N.
void transform(std::vector<std::complex<double>>& values);

}  // namespace axisc::tuning
