#include "tests/runtime/c99/motion.hpp"

#include <bit>
#include <iterator>
#include <limits>
#include <vector>

namespace axisc::test {
namespace {

/// A setpoint that moves, jumps, stands still for long, or is none at all. Tiny ones are of the size at which
/// states are cleared and numbers come back to the grid.
class Setpoint {
 public:
  explicit Setpoint(bool is_tiny) : is_tiny_(is_tiny) {}
  double next(Random& random) {
    if (random.chance(is_tiny_ ? 40 : 150)) begin(random);
    x_ += v_;
    if (hostile_ && random.chance(4)) return hostile(random);
    return x_;
  }

 private:
  void begin(Random& random) {
    if (is_tiny_) {
      v_ = random.chance(2) ? 0 : random.sign() * random.magnitude(-502, -480);
      x_ = random.chance(2) ? v_ = 0 : random.sign() * random.magnitude(-502, -460);
      return;
    }
    hostile_ = random.chance(5);
    v_ = random.chance(2) ? 0 : random.sign() * random.magnitude(-30, 12);
    if (random.chance(4)) x_ = random.chance(3) ? 0 : random.sign() * random.magnitude(-40, 40);
    if (random.chance(12)) x_ = random.sign() * random.magnitude(-1070, -400);
  }
  static double hostile(Random& random) {
    constexpr double numbers[] = {std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity(),
                                  0x1p53,
                                  -0x1p53,
                                  0x1.0000000000001p53,
                                  0x1p-1074,
                                  -0x1p-1022,
                                  0x1p-500,
                                  -0x1.fffffffffffffp-501,
                                  0.0,
                                  -0.0,
                                  std::numeric_limits<double>::max()};
    if (random.chance(4)) {
      return std::bit_cast<double>(std::uint64_t{random.below(0xFFFFFFFF)} << 32U | random.below(0xFFFFFFFF));
    }
    return numbers[random.below(std::size(numbers))];
  }
  double x_ = 0, v_ = 0;
  bool hostile_ = false;
  bool is_tiny_;
};

void call(Random& random, Twins& twins) {
  std::uint32_t const axis = random.below(twins.axes());
  double const x = random.chance(4) ? 0 : random.sign() * random.magnitude(-30, random.chance(9) ? 54 : 30);
  switch (random.below(8)) {
    case 0: twins.reset(axis, x); break;
    case 1: twins.reset_interface(axis, x); break;
    case 2: twins.reset_velocity(axis, x, -x, x / 2); break;
    case 3: twins.rebase(axis, x); break;
    default:
      if (twins.groups() == 0) break;
      std::uint32_t const group = random.below(twins.groups());
      auto const action = static_cast<axisrt_c_action>(random.chance(2) ? 1 : random.below(5));
      std::uint32_t const banks = axisrt_c_bank_count(twins.c.runtime, group);
      twins.command(group, action, random.below(banks));
  }
}

}  // namespace

void move(Random& random, Twins& twins, int cycles) {
  if (!twins.difference.empty() || twins.c.runtime == nullptr) return;
  // Where not all forms of chains are grouped, only tiny numbers show it.
  bool const is_tiny = twins.axes() > 30 || random.chance(3);
  std::vector<Setpoint> setpoints(twins.axes(), Setpoint(is_tiny));
  std::vector<double> in(twins.axes());
  for (std::uint32_t axis = 0; axis < twins.axes(); ++axis) {
    if (random.chance(8)) continue;  // some axes are not reset at the beginning
    twins.reset(axis, 0);
    twins.reset_interface(axis, 0);
    twins.reset_velocity(axis, 0, 0, 0);
  }
  for (int cycle = 0; cycle < cycles && twins.difference.empty(); ++cycle) {
    if (random.chance(20)) call(random, twins);
    for (std::size_t i = 0; i < in.size(); ++i) in[i] = setpoints[i].next(random);
    twins.step(in);
  }
}

}  // namespace axisc::test
