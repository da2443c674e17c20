// Nothing of the cycle calls the operating system: it runs in a process that may only leave.
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace axisc::test;

namespace {

constexpr std::uint32_t axes = 3;
constexpr int cycles = 10'000;

/// What the forbidden process reports by its exit status.
enum : int { all_done = 0, no_command_taken = 1, no_command_refused = 2, wrong_state = 3, cannot_forbid = 9 };

/// Neither exit nor _exit: both call what strict mode forbids.
[[noreturn]] void leave(int status) {
  syscall(SYS_exit, status);
  __builtin_trap();
}

/// Every function that may be called in the cycle, with good and bad values.
int run_cycles(TestRuntime& test) {
  axisrt* const runtime = test.runtime;
  double in[axes] = {};
  double out[axes] = {};
  double increments[axes] = {};
  std::uint8_t status[axes] = {};
  axisrt_velocities const velocities{
      .size = sizeof velocities, .reserved = 0, .v_set = in, .v_motor = in, .v_direct = in};
  axisrt_axis_state state{};
  unsigned taken = 0;
  unsigned refused = 0;
  for (int cycle = 0; cycle < cycles; ++cycle) {
    for (std::uint32_t axis = 0; axis < axes; ++axis) in[axis] = cycle * 0.75 * axis;
    if (cycle % 97 == 0) in[1] = __builtin_nan("");
    if (cycle % 101 == 0) in[2] = 0x1p-1060;
    auto const action = static_cast<axisrt_action>(cycle / 7 % 4);
    axisrt_status const answer = test.command(action, cycle % 3 == 0 ? AXISRT_KEYWORD_HSC : 0);
    taken += answer == AXISRT_OK ? 1 : 0;
    refused += answer == AXISRT_OK ? 0 : 1;
    if (cycle % 1000 == 999) {
      axisrt_reset(runtime, 0, cycle);
      axisrt_reset_interface(runtime, 0, cycle);
      axisrt_reset_velocity(runtime, 0, 1, 2, 3);
      axisrt_rebase(runtime, 1, -100);
    }
    axisrt_step(runtime, in, out, status);
    axisrt_step_interface(runtime, in, out, status);
    axisrt_step_velocity(runtime, &velocities, out, increments, status);
    axisrt_get_axis_state(runtime, 0, &state);
  }
  if (taken == 0) return no_command_taken;
  if (refused == 0) return no_command_refused;
  return state.reset_done == 1 ? all_done : wrong_state;
}

}  // namespace

TEST_CASE("10,000 cycles with every system call forbidden") {
  if (sanitized) {
    WARN("skipped: sanitizers make system calls of their own");
    return;
  }
  ImageRecord image = channel_image();
  image.axes[0].interface_filters = {exact::pt1(8, Quad{1} / 1000).record()};
  TestRuntime test(write_image(image));
  REQUIRE(test.status == AXISRT_OK);
  test.reset_all(0);
  axisrt_reset_interface(test.runtime, 0, 0);
  for (std::uint32_t axis = 0; axis < axes; ++axis) axisrt_reset_velocity(test.runtime, axis, 0, 0, 0);

  pid_t const child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) leave(cannot_forbid);
    leave(run_cycles(test));
  }
  int ended = 0;
  REQUIRE(waitpid(child, &ended, 0) == child);
  if (WIFEXITED(ended) && WEXITSTATUS(ended) == cannot_forbid) {
    WARN(
        "skipped: system calls cannot be forbidden here (an emulator or a container that does not allow it)");
    return;
  }
  INFO("a signal means a system call: " << (WIFSIGNALED(ended) ? WTERMSIG(ended) : 0));
  REQUIRE(WIFEXITED(ended));
  CHECK(WEXITSTATUS(ended) == all_done);
}

TEST_CASE("a forbidden system call is noticed") {
  pid_t const child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) leave(cannot_forbid);
    syscall(SYS_getpid);
    leave(all_done);
  }
  int ended = 0;
  REQUIRE(waitpid(child, &ended, 0) == child);
  bool const skipped = WIFEXITED(ended) && WEXITSTATUS(ended) == cannot_forbid;
  if (skipped) WARN("skipped: system calls cannot be forbidden here");
  CHECK((skipped || WIFSIGNALED(ended)));
}
