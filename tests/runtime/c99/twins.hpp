// axisrt at level portable and axisrt_c with the same image: every output, status and state is compared, bit
// for bit.
#pragma once

#include "axisrt_c.h"
#include "tests/runtime/test_runtime.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace axisc::test {

/// The runtime in C of an image, with its memory; the image is gone after create.
class CRuntime {
 public:
  explicit CRuntime(Bytes const& image);
  [[nodiscard]] std::vector<std::uint8_t> block() const;
  void restore(std::vector<std::uint8_t> const& block);

  axisrt_c* runtime = nullptr;
  axisrt_c_status status = AXISRT_C_OK;

 private:
  std::unique_ptr<AlignedMemory> memory_;
};

class Twins {
 public:
  explicit Twins(Bytes const& image);
  [[nodiscard]] std::uint32_t axes() const { return static_cast<std::uint32_t>(out_.size()); }
  [[nodiscard]] std::uint32_t groups() const { return axisrt_c_group_count(c.runtime); }

  void reset(std::uint32_t axis, double position);
  void reset_interface(std::uint32_t axis, double value);
  void reset_velocity(std::uint32_t axis, double v_set, double v_motor, double v_direct);
  void rebase(std::uint32_t axis, double offset);
  /// A cycle of each port.
  void step(std::vector<double> const& in);
  void command(std::uint32_t group, axisrt_c_action action, std::uint32_t bank);

  std::uint64_t values = 0;  ///< that were compared
  std::uint64_t commands_done = 0;
  std::string difference;  ///< the first one; empty while there is none

  TestRuntime cxx;
  CRuntime c;

 private:
  void compare(char const* what, double cxx, double c);
  void compare(char const* what, std::uint64_t cxx, std::uint64_t c);
  void compare_ports(char const* what, axisrt_status cxx, axisrt_c_status c);
  void step_velocity(std::vector<double> const& in);

  std::vector<double> out_, out_c_, increments_, increments_c_;
  std::vector<std::uint8_t> status_, status_c_;
  std::vector<std::uint32_t> bank_;  ///< of each group, which SET adds to
};

}  // namespace axisc::test
