#include "design/prototypes_def.hpp"
#include "support/catch.hpp"
#include "tests/design/specifications.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace prototypes_test {

namespace {

using namespace axisc::design;
using Exact =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Complex = ComplexNumber<Exact>;

/// |H(j)|² = Π |p|²/|j - p|² over all poles.
Exact power_at_one(Poles<Exact> const& poles) {
  Complex const j{Exact(0), Exact(1)};
  Exact power{1};
  for (Complex const& p : poles) {
    power *= square_of_magnitude(p) / square_of_magnitude(j - p);
    if (p.im != 0) power *= square_of_magnitude(p) / square_of_magnitude(j - Complex{p.re, -p.im});
  }
  return power;
}

std::size_t order_of(Poles<Exact> const& poles) {
  std::size_t order = 0;
  for (Complex const& p : poles) order += p.im == 0 ? 1 : 2;
  return order;
}

}  // namespace

TEST_CASE("every prototype has half the power at s = j, to 48 digits, and its order's poles on the left") {
  for (Prototype const prototype : every_prototype) {
    for (std::uint32_t order = 1; order <= 6; ++order) {
      auto const poles = prototype_poles<Exact>(prototype, order);
      INFO("prototype " << int(prototype) << " order " << order);
      CHECK(order_of(poles) == order);
      CHECK(abs(power_at_one(poles) - Exact(0.5)) < Exact("1e-48"));
      for (Complex const& p : poles) {
        CHECK(p.re < 0);
        CHECK(p.im >= 0);
      }
    }
  }
}

TEST_CASE("a Bessel prototype's poles are roots of the reverse Bessel polynomial, evenly delayed at 0 Hz") {
  CHECK(reverse_bessel_polynomial<double>(3) == Polynomial<double>{15, 15, 6, 1});
  CHECK(reverse_bessel_polynomial<double>(6) == Polynomial<double>{10395, 10395, 4725, 1260, 210, 21, 1});
  for (std::uint32_t order = 1; order <= 6; ++order) {
    auto const theta = reverse_bessel_polynomial<Exact>(order);
    Exact const frequency = bessel_half_power_frequency(theta);
    for (Complex const& p : bessel_poles<Exact>(order)) {
      Complex value, derivative;
      evaluate(theta, Complex{p.re * frequency, p.im * frequency}, value, derivative);
      CHECK(square_of_magnitude(value) < Exact("1e-92") * theta[0] * theta[0]);
    }
  }
}

TEST_CASE("published poles, to the digits printed") {
  auto const bessel = bessel_poles<double>(2);
  REQUIRE(bessel.size() == 1);
  CHECK(bessel[0].re == Approx(-1.1016013306).epsilon(1e-10));
  CHECK(bessel[0].im == Approx(0.6360098248).epsilon(1e-10));
  CHECK(critical_damping_poles<double>(1)[0].re == Approx(-1));
  CHECK(critical_damping_poles<double>(2)[0].re == Approx(-1.553773974));
  CHECK(butterworth_poles<double>(2)[0].re == Approx(-0.7071067812));
}

TEST_CASE("roots of a polynomial: real and complex, small and large") {
  // (x - 1/1024)(x + 4)(x² - 2x + 26)
  Polynomial<Exact> a{Exact(1)};
  for (Polynomial<Exact> const& factor :
       {Polynomial<Exact>{-Exact(1) / 1024, 1}, Polynomial<Exact>{4, 1}, Polynomial<Exact>{26, -2, 1}}) {
    Polynomial<Exact> product(a.size() + factor.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < factor.size(); ++j) product[i + j] += a[i] * factor[j];
    }
    a = product;
  }
  auto const roots = polynomial_roots(a);
  REQUIRE(roots.size() == 3);
  for (Complex const& expected :
       {Complex{Exact(1) / 1024, Exact(0)}, Complex{Exact(-4), Exact(0)}, Complex{Exact(1), Exact(5)}}) {
    bool found = false;
    for (Complex const& root : roots) {
      found = found || square_of_magnitude(root - expected) < Exact("1e-96") * square_of_magnitude(expected);
    }
    CHECK(found);
  }
}

}  // namespace prototypes_test
