#include "runtime/step_distance.hpp"

#include "runtime/format/image_format.h"
#include "runtime/lane.hpp"

namespace axisc::runtime {
namespace {

constexpr uint32_t longest = 1U << 21U;
constexpr double settled = 0x1p-20;
/// The rest that states may hold when the computation ends: it adds next to nothing to the sums.
constexpr double rest = 0x1p-40;

constexpr uint32_t most_chain_sections = axim_most_filters * axim_most_sections;

struct Step {
  double value, increment;
};

/// States of a chain of filters, apart from those of the cycle.
struct States {
  double e[most_chain_sections];
  double r[most_chain_sections];
  Step ring[axim_most_filters][axim_most_delay];
  uint32_t position[axim_most_filters];
};

Step run_sections(Lane const& lane, Filter const& filter, double* e, double* r, Step x) {
  double sum = 0;
  double d = x.increment;
  for (uint32_t i = 0; i < filter.section_count; ++i) {
    SectionCoefficients const section = lane.section(filter, i);
    double const de = section.p * d + r[i];
    e[i] += de;
    r[i] += section.g * d - section.k * e[i] - section.b * de;
    d += de;
    sum += e[i];
  }
  double const share = filter.kind == FilterKind::shared ? lane.share(filter, 0) : 1;
  return {.value = x.value + share * sum, .increment = x.increment + share * (d - x.increment)};
}

Step run_delay(Lane const& lane, Filter const& filter, Step* ring, uint32_t& position, Step x) {
  Step const delayed = ring[position];
  ring[position] = x;
  position = position + 1 == filter.delay_cycles ? 0 : position + 1;
  double const share = lane.share(filter, 0);
  double const direct = lane.share(filter, 1);
  return {.value = share * delayed.value + direct * x.value,
          .increment = share * delayed.increment + direct * x.increment};
}

/// An oscillator left alone has the energy r^2 + k e^2.
bool rests(Lane const& lane, Filter const& filter, double const* e, double const* r) {
  for (uint32_t i = 0; i < filter.section_count; ++i) {
    double const k = lane.section(filter, i).k;
    if (r[i] * r[i] + k * e[i] * e[i] > k * (rest * rest)) return false;
  }
  return true;
}

bool passes_constants(axisrt const& runtime, LineChain const& line) {
  for (uint32_t i = 0; i < line.filter_count; ++i) {
    if (runtime.filters[line.first_filter + i].kind == FilterKind::blocking) return false;
  }
  return true;
}

/// Step n of the step response of a kernel: 1 - S_n.
Step kernel_step(Kernel const& kernel, uint32_t n) {
  double const tail = n < kernel.tail_count ? *(kernel.zero - n) : 0;
  double const before = n == 0 ? 1 : n - 1 < kernel.tail_count ? *(kernel.zero - (n - 1)) : 0;
  return {.value = 1 - tail, .increment = before - tail};
}

/// Calls `visit(s[n], h[n])` with the step and the impulse response of a kernel and a line's filters, for n =
/// 0, 1, ... until they have settled. False if they do not.
template <class Visit>
bool respond(axisrt const& runtime, Lane const& lane, LineChain const& line, Kernel const& kernel,
             Visit visit) {
  if (!passes_constants(runtime, line)) return false;
  States states{};
  uint32_t delays = kernel.tail_count;
  for (uint32_t i = 0; i < line.filter_count; ++i) {
    delays += runtime.filters[line.first_filter + i].delay_cycles;
  }
  for (uint32_t n = 0; n < longest; ++n) {
    Step y = kernel_step(kernel, n);
    bool at_rest = n > delays;
    uint32_t section = 0;
    for (uint32_t i = 0; i < line.filter_count; ++i) {
      Filter const& filter = runtime.filters[line.first_filter + i];
      double* const e = states.e + section;
      double* const r = states.r + section;
      section += filter.section_count;
      if (filter.kind == FilterKind::delay) {
        y = run_delay(lane, filter, states.ring[i], states.position[i], y);
      } else if (filter.section_count > 0) {
        y = run_sections(lane, filter, e, r, y);
        at_rest = at_rest && rests(lane, filter, e, r);
      }
    }
    visit(y.value, y.increment);
    if (at_rest) return true;
  }
  return false;
}

StepDistance distance_of_filters(axisrt const& runtime, Lane const& lane, LineChain const& line) {
  StepDistance distance{.is_bounded = true, .sum = 0, .peak_gain = 0, .settling = 0};
  uint32_t n = 0;
  Kernel const& none = runtime.kernels[runtime.kernel_count];
  distance.is_bounded = respond(runtime, lane, line, none, [&](double s, double h) {
    n += 1;
    distance.sum += magnitude(s - 1);
    distance.peak_gain += magnitude(h);
    if (magnitude(s - 1) > settled) distance.settling = n;
  });
  return distance.is_bounded ? distance : StepDistance{};
}

/// The largest of every kernel that the slot has room for.
StepDistance distance_of_slot(axisrt const& runtime, Slot const& slot) {
  StepDistance largest{.is_bounded = true, .sum = 0, .peak_gain = 1, .settling = slot.history_length};
  for (uint32_t i = 0; i < runtime.kernel_count; ++i) {
    Kernel const& kernel = runtime.kernels[i];
    if (kernel.tail_count > slot.history_length) continue;
    double sum = 0;
    double gain = 0;
    double before = 1;
    for (uint32_t j = 0; j < kernel.tail_count; ++j) {
      double const tail = *(kernel.zero - j);
      sum += magnitude(tail);
      gain += magnitude(before - tail);
      before = tail;
    }
    gain += magnitude(before);
    if (sum > largest.sum) largest.sum = sum;
    if (gain > largest.peak_gain) largest.peak_gain = gain;
  }
  return largest;
}

}  // namespace

/// y - x = F(K x) - K x + K x - x for filters F and a kernel K, in either order.
StepDistance step_distance(axisrt const& runtime, LinePort const& port, uint32_t index) {
  LineChain const& line = port.lines[index];
  StepDistance distance = distance_of_filters(runtime, Lane(port, line), line);
  Slot const* const slot = line.before != nullptr ? line.before : line.behind;
  if (slot == nullptr || !distance.is_bounded) return distance;
  StepDistance const kernel = distance_of_slot(runtime, *slot);
  distance.sum = distance.sum * kernel.peak_gain + kernel.sum;
  distance.peak_gain *= kernel.peak_gain;
  distance.settling += kernel.settling;
  return distance;
}

namespace {

double larger(double a, double b) {
  return a > b ? a : b;
}

/// The largest  |r[n] - max(0, n - D)|  of the answer r to a ramp of one unit per cycle; between two cycles r
/// is a straight line, so that apart from the cycles only the ramp's own bend at D matters.
class RampError {
 public:
  explicit RampError(double delay) : delay_(delay) {}
  void take(double s) {
    double const next = r_ + s;
    if (n_ <= delay_ && delay_ < n_ + 1) largest_ = larger(largest_, magnitude(r_ + (delay_ - n_) * s));
    r_ = next;
    n_ += 1;
    largest_ = larger(largest_, magnitude(r_ - larger(0, n_ - delay_)));
  }
  [[nodiscard]] double largest() const { return largest_; }

 private:
  double delay_;
  double n_ = 0;
  double r_ = 0;
  double largest_ = 0;
};

}  // namespace

bool corner_error(axisrt const& runtime, LinePort const& port, uint32_t index, double& cycles) {
  LineChain const& line = port.lines[index];
  Lane const lane(port, line);
  Slot const* const slot = line.before != nullptr ? line.before : line.behind;
  Kernel const& kernel =
      slot != nullptr ? *slot->group->kernel[slot->lane] : runtime.kernels[runtime.kernel_count];
  double delay = 0;
  bool const follows = respond(runtime, lane, line, kernel, [&](double s, double) { delay += 1 - s; });
  if (!follows) return false;
  RampError error(delay);
  respond(runtime, lane, line, kernel, [&](double s, double) { error.take(s); });
  cycles = error.largest();
  return true;
}

}  // namespace axisc::runtime
