#include "axisc/asked/frequencies.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace axisc::says {

constexpr Sentence bad_frequency{"\"{value}\" is not a frequency from 0 to {nyquist} Hz (0.5/T)",
                                 "\"{value}\" ist keine Frequenz von 0 bis {nyquist} Hz (0,5/T)"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr int default_points = 200;
constexpr double default_decades = 4;

}  // namespace

std::vector<double> parse_frequencies(std::string const& text, design::CycleTime cycle_time) {
  std::vector<double> frequencies;
  double const nyquist = cycle_time.nyquist().value;
  for (auto const& word : split_list(text)) {
    auto const frequency = parse_finite(word);
    if (!frequency || *frequency < 0 || *frequency > nyquist) {
      throw Failure({says::bad_frequency, {{"value", word}, {"nyquist", exact_number(nyquist)}}});
    }
    frequencies.push_back(*frequency);
  }
  if (frequencies.empty()) {
    throw Failure({says::bad_frequency, {{"value", text}, {"nyquist", exact_number(nyquist)}}});
  }
  return frequencies;
}

std::vector<double> default_frequencies(design::CycleTime cycle_time,
                                        std::vector<double> const& characteristic) {
  std::vector<double> frequencies;
  double const nyquist = cycle_time.nyquist().value;
  for (int i = 0; i < default_points; ++i) {
    double const decades = default_decades * (i + 1 - default_points) / (default_points - 1);
    frequencies.push_back(nyquist * std::pow(10.0, decades));
  }
  std::copy_if(characteristic.begin(), characteristic.end(), std::back_inserter(frequencies),
               [nyquist](double frequency) { return frequency > 0 && frequency < nyquist; });
  std::sort(frequencies.begin(), frequencies.end());
  frequencies.erase(std::unique(frequencies.begin(), frequencies.end()), frequencies.end());
  return frequencies;
}

}  // namespace axisc
