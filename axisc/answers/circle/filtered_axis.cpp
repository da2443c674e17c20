#include "axisc/answers/circle/filtered_axis.hpp"

#include "axisc/asked/filter_symbols.hpp"
#include "design/filter_analysis.hpp"
#include "design/kernels/kernel_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace axisc {

namespace {

std::string name_of(image::ImageSlot const& slot, design::KernelType type) {
  switch (slot.family) {
    case machine::KernelFamily::hsc: return "filter[" + std::to_string(slot.index) + "] HSC";
    case machine::KernelFamily::fir: return "filter_fir " + std::to_string(static_cast<int>(type) + 1);
    case machine::KernelFamily::guard: break;
  }
  return "vib_guard";
}

/// The phase delay is the one next to the delay at 0 Hz.
FilterShare share_of(std::string name, std::complex<double> response, double delay_s, double omega) {
  double const rest = std::arg(response * std::polar(1.0, omega * delay_s));
  return {.filter = std::move(name), .gain = std::abs(response), .delay_s = delay_s - rest / omega};
}

/// Whole cycles, and the lag that motion::PositionDelays executes.
FilterShare share_of(machine::PositionDelay const& later, double cycle_s, double omega) {
  double const part = 1 / (1 + later.lag);
  auto const back = std::polar(1.0, -omega * cycle_s);
  auto const response = std::polar(1.0, -omega * cycle_s * later.cycles) * part / (1.0 - (1 - part) * back);
  return share_of("drive", response, (later.cycles + later.lag) * cycle_s, omega);
}

}  // namespace

double FilteredAxis::gain() const {
  double product = 1;
  for (auto const& share : shares) product *= share.gain;
  return product;
}

double FilteredAxis::delay_s() const {
  double sum = 0;
  for (auto const& share : shares) sum += share.delay_s;
  return sum;
}

FilteredAxis filtered_axis(image::ImageContents const& image, std::size_t axis,
                           machine::PositionDelay const& later, double radians_per_second) {
  auto const& contents = image.axes[axis];
  auto const cycle_time = image.cycle_time;
  design::Hertz const frequency{radians_per_second / (2 * std::numbers::pi)};
  FilteredAxis found;
  for (auto const& filter : contents.filters) {
    auto name = filter_path(filter, false) + " " + std::string(type_word(filter.specification.type));
    found.shares.push_back(share_of(std::move(name), design::response(filter.design, frequency, cycle_time),
                                    filter.design.group_delay_cycles * cycle_time.seconds(),
                                    radians_per_second));
  }
  if (contents.slot && contents.slot->kernel) {
    auto const& kernel = image.kernels[*contents.slot->kernel];
    found.shares.push_back(share_of(name_of(*contents.slot, kernel.specification.type),
                                    design::response(kernel.design, frequency, cycle_time),
                                    kernel.design.group_delay_cycles * cycle_time.seconds(),
                                    radians_per_second));
  }
  if (later != machine::PositionDelay{}) {
    found.shares.push_back(share_of(later, cycle_time.seconds(), radians_per_second));
  }
  return found;
}

bool blocks_constant(image::ImageAxis const& axis) {
  return std::any_of(axis.filters.begin(), axis.filters.end(), [](image::ImageFilter const& filter) {
    return filter.design.blocks_constant && filter.design.share.filtered > 0;
  });
}

}  // namespace axisc
