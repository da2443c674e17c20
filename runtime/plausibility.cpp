#include "runtime/creation/building.hpp"
#include "runtime/lane.hpp"
#include "runtime/limits.hpp"

namespace axisc::runtime {
namespace {

/// The largest peak gain of the kernels that a slot may work with; none at all has 1.
class KernelGains {
 public:
  explicit KernelGains(ImageView const& view) {
    for (double& gain : largest_) gain = 1;
    for (uint32_t i = 0; i < view.kernels.count; ++i) {
      Record<record::kernel> const kernel = view.kernels[i];
      double const gain = kernel[field::kernel::peak_gain];
      double& largest = largest_[place_of(kernel[field::kernel::tail_count])];
      if (gain > largest) largest = gain;
    }
    for (uint32_t i = 1; i <= longer; ++i) {
      if (largest_[i - 1] > largest_[i]) largest_[i] = largest_[i - 1];
    }
  }
  [[nodiscard]] double largest_of(Slot const& slot) const { return largest_[place_of(slot.history_length)]; }

 private:
  /// All guards that are longer than other kernels, so that the stack stays small.
  static constexpr uint32_t longer = axim_most_tails + 1;
  static uint32_t place_of(uint32_t tails) { return tails < longer ? tails : longer; }

  double largest_[longer + 1];  ///< of those with as many tails, then of those with at most as many
};

/// P of the chain with whichever kernel. The image states that of the chain as it starts.
double peak_gain(ImageView const& view, axisrt const& runtime, KernelGains const& gains, uint32_t axis) {
  double const at_start = view.axes[axis][field::axis::peak_gain];
  LineChain const& line = runtime.setpoint.lines[axis];
  Slot const* const slot = line.before != nullptr ? line.before : line.behind;
  if (slot == nullptr) return at_start;
  double const largest = gains.largest_of(*slot);
  auto const number = static_cast<uint32_t>(slot->listed - runtime.kernels);
  if (slot->on_at_start == 0 || number >= view.kernels.count) return at_start * largest;
  double const listed = view.kernels[number][field::kernel::peak_gain];
  return at_start / listed * largest;
}

}  // namespace

/// (P + 1/4) v: with setpoints within v no output moves farther, a quarter of v is left to fades. On the
/// grid, like everything in a recording.
void limit_increments(ImageView const& view, axisrt const& runtime) {
  KernelGains const gains(view);
  uint32_t next = 0;
  for (uint32_t axis = 0; axis < runtime.axis_count; ++axis) {
    double const v = runtime.axes[axis].velocity_limit;
    double const proved = largest_bound(view, axis, field::bound::gain_high, next);
    double const gain = proved > 0 ? proved : peak_gain(view, runtime, gains, axis);
    if (!(v > 0)) continue;
    Lane(runtime.setpoint, runtime.setpoint.lines[axis]).part(GroupParts::largest_increment) =
        on_grid((gain + 0.25) * v, grid);
  }
}

}  // namespace axisc::runtime
