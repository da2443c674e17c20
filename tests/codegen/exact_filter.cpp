#include "exact_filter.hpp"

#include "design/filter_design_def.hpp"

#include <cmath>
#include <utility>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace axisc::test {
namespace {

namespace mp = boost::multiprecision;
using Exact = mp::number<mp::cpp_bin_float<128, mp::digit_base_2>, mp::et_off>;
using design::FilterSpecification;
using Sections = std::vector<design::Section<Exact>>;

struct Signal {
  Exact value, increment;
};

class ExactFilter {
 public:
  /// A delay is meant to be fractional.
  ExactFilter(FilterSpecification const& specification, design::CycleTime cycle_time)
      : sections_(design::realise<Exact>(specification, cycle_time).sections),
        states_(sections_.size()),
        blocks_constant_(design::kind_of(specification.type).blocks_constant),
        share_(Exact(specification.share_percent) / 100) {}

  Signal step(Signal const& x) {
    Exact d = x.increment;
    Exact sum = 0;
    for (std::size_t i = 0; i < sections_.size(); ++i) {
      auto const& [p, q, k, b, slope] = sections_[i];
      auto& [r, e] = states_[i];
      Exact const de = p * d + r;
      e += de;
      r = de + q * d - k * e - b * de;
      d = blocks_constant_ ? de : Exact(d + de);
      sum = blocks_constant_ ? e : Exact(sum + e);
    }
    if (!blocks_constant_) sum += x.value;
    return {share_ * sum + (1 - share_) * x.value, share_ * d + (1 - share_) * x.increment};
  }

 private:
  struct State {
    Exact r{0}, e{0};
  };
  Sections sections_;
  std::vector<State> states_;
  bool blocks_constant_;
  Exact share_;
};

}  // namespace

struct ExactChain::Implementation {
  std::vector<ExactFilter> filters;
  Exact previous;
};

ExactChain::ExactChain(std::vector<FilterSpecification> const& filters, design::CycleTime cycle_time,
                       double position)
    : implementation_(std::make_unique<Implementation>()) {
  for (FilterSpecification const& filter : filters) implementation_->filters.emplace_back(filter, cycle_time);
  implementation_->previous = position;
}

ExactChain::~ExactChain() = default;

double ExactChain::error_of(double against, double setpoint, double& exact_output) {
  Signal signal{setpoint, Exact(setpoint) - std::exchange(implementation_->previous, Exact(setpoint))};
  for (ExactFilter& filter : implementation_->filters) signal = filter.step(signal);
  exact_output = static_cast<double>(signal.value);
  return static_cast<double>(Exact(against - signal.value));
}

}  // namespace axisc::test
