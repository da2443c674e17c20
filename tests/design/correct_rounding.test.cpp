// Exact designs are the nearest doubles of the mathematics: compared with a second evaluation in twice the
// digits.
#include "design/filter_analysis.hpp"
#include "design/filter_design_def.hpp"
#include "support/catch.hpp"
#include "tests/design/specifications.hpp"

#include <cmath>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace correct_rounding_test {

namespace {

using namespace axisc::design;
using Reference =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<110>, boost::multiprecision::et_off>;
using Complex = ComplexNumber<Reference>;

Complex response_of(IncrementSection const& section, bool blocks_constant, Complex const& u) {
  Complex const one{Reference(1), Reference(0)};
  auto const real = [](double x) { return Complex{Reference(x), Reference(0)}; };
  Reference const a1 = Reference(section.k) + Reference(section.b) - 2;
  Reference const a2 = 1 - Reference(section.b);
  Complex const a = one + Complex{a1, Reference(0)} * u + Complex{a2, Reference(0)} * u * u;
  Complex const g = (real(section.p) + real(section.q) * u) * (one - u) / a;
  return blocks_constant ? g : one + g;
}

}  // namespace

TEST_CASE("every stored number is correctly rounded") {
  RandomCases cases(20240611);
  for (int i = 0; i < 250; ++i) {
    Case const c = cases.next();
    INFO(c);
    FilterDesign const exact = design_filter(c.specification, c.cycle_time, Precision::exact);
    FilterDesign const reference = design_in<Reference>(c.specification, c.cycle_time);
    CHECK(exact.realisation == reference.realisation);
    CHECK(exact.sections == reference.sections);
    CHECK(exact.pole_radius == reference.pole_radius);
    CHECK(exact.dc_gain == reference.dc_gain);
    CHECK(exact.group_delay_cycles == reference.group_delay_cycles);
    CHECK(exact.share.filtered == reference.share.filtered);
    CHECK(exact.share.direct == reference.share.direct);
    CHECK(exact.share.direct_low == reference.share.direct_low);
  }
}

TEST_CASE("the conversion to double takes the nearest one") {
  for (int i = 1; i < 2000; ++i) {
    Reference const x = sin(Reference(i)) * pow(Reference(2), i % 200 - 150);
    auto const nearest = static_cast<double>(x);
    Reference const error = abs(x - nearest);
    CHECK(error <= abs(x - std::nextafter(nearest, 1e9)));
    CHECK(error <= abs(x - std::nextafter(nearest, -1e9)));
  }
}

TEST_CASE("the response is the stored sections', to 1e-13, down to 0 Hz") {
  RandomCases cases(7);
  Reference const two_pi = 2 * boost::math::constants::pi<Reference>();
  for (int i = 0; i < 150; ++i) {
    Case c = cases.next();
    c.specification.share_percent = 100;
    FilterDesign const design = design_filter(c.specification, c.cycle_time, Precision::exact);
    if (design.realisation != Realisation::sections) continue;
    double const nyquist = c.cycle_time.nyquist().value;
    double const f0 = uses_frequency(c.specification.type) ? c.specification.frequency.value : 0.1 * nyquist;
    for (double const frequency : {1e-6, 0.9 * f0, f0, 1.1 * f0, 0.7 * nyquist}) {
      if (frequency > nyquist) continue;
      Reference const angle = two_pi * c.cycle_time.periods_in<Reference>({frequency});
      Complex const u{cos(angle), -sin(angle)};
      Complex expected{Reference(1), Reference(0)};
      for (IncrementSection const& section : design.sections) {
        expected = expected * response_of(section, design.blocks_constant, u);
      }
      std::complex<double> const h = response(design, {frequency}, c.cycle_time);
      INFO(c << " at " << frequency << " Hz");
      CHECK(std::abs(h - std::complex<double>(static_cast<double>(expected.re),
                                              static_cast<double>(expected.im))) < 1e-13);
    }
  }
}

}  // namespace correct_rounding_test
