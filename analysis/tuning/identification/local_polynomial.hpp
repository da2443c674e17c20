// Frequency response with its uncertainty, by local polynomials (Pintelon and Schoukens, System
// Identification: A Frequency Domain Approach, 2nd ed. 2012, section 7.2).
//
// Response and leakage are smooth over a few lines of the spectrum, the input is not. At line k, with the
// lines k + q, q = -6 … 6, of each part p of the recording, transformed without a window,
//
//     Y_p(k+q) = Σ_o (h_o U_p(k+q) + t_po) q^o + V_p(k+q),  o = 0 … 2,
//
// h common to the parts, t (leakage: what moved before the part, and still moves after it) of each its own,
// is solved by least squares. h_0 is the response, and the residual says how well it is known:
//
//     sd² = s² [(KᴴK)⁻¹]_00,  s² = Σ |V|² / (lines - unknowns).
#pragma once

#include "analysis/tuning/identification/measured_response.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::tuning {

inline constexpr std::size_t local_reach = 6;  ///< lines on either side

struct LocalResponse {
  MeasuredResponse response;      ///< without coherence
  std::vector<double> deviation;  ///< standard deviation of each entry; infinite where nothing is excited
};

/// Of `count` parts of the same length (from 1), at lines from 7 on. Cost: a transform and some 1000
/// operations a line and part.
[[nodiscard]] LocalResponse local_response(std::span<double const> in, std::span<double const> out,
                                           double sampling_rate, std::size_t count);

}  // namespace axisc::tuning
