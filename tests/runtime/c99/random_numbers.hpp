// Random numbers that are the same on every host: distributions of the standard library are not.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace axisc::test {

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  /// 0 to end - 1.
  std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(engine_() % end); }
  /// One in `n`.
  bool chance(std::uint32_t n) { return below(n) == 0; }
  double between(double least, double most) {
    return least + (most - least) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
  }
  /// 2^e, e from `least` to `most`, times 1 to 2.
  double magnitude(int least, int most) {
    return std::ldexp(between(1, 2),
                      least + static_cast<int>(below(static_cast<std::uint32_t>(most - least))));
  }
  double sign() { return chance(2) ? -1 : 1; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace axisc::test
