// The arithmetic of a cycle: numbers that are next to zero are taken as zero inside, and the caller's control
// word comes back.
#include "tests/runtime/control_word.hpp"

#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

using namespace axisc::test;

namespace {

/// One call of every function that steps.
class SteppedRuntime {
 public:
  SteppedRuntime() : runtime_(write_image(channel_image())) {
    REQUIRE(runtime_.status == AXISRT_OK);
    runtime_.reset_all(0);
    for (std::uint32_t axis = 0; axis < axes; ++axis) {
      REQUIRE(axisrt_reset_velocity(runtime_.runtime, axis, 0, 0, 0) == AXISRT_OK);
    }
  }
  void step(double in) {
    for (double& setpoint : in_) setpoint = in;
    axisrt_step(runtime_.runtime, in_, out_, status_);
  }
  void step_interface(double in) {
    for (double& setpoint : in_) setpoint = in;
    axisrt_step_interface(runtime_.runtime, in_, out_, status_);
  }
  void step_velocity(double in) {
    for (double& velocity : in_) velocity = in;
    axisrt_step_velocity(runtime_.runtime, &velocities_, out_, increments_, status_);
  }

 private:
  static constexpr std::uint32_t axes = 3;
  TestRuntime runtime_;
  double in_[axes] = {};
  double out_[axes] = {};
  double increments_[axes] = {};
  std::uint8_t status_[axes] = {};
  axisrt_velocities velocities_{
      .size = sizeof(axisrt_velocities), .reserved = 0, .v_set = in_, .v_motor = in_, .v_direct = in_};
};

}  // namespace

TEST_CASE("the caller's control word comes back from every step") {
  SteppedRuntime runtime;
  for (ControlWord const word : callers_control_words()) {
    INFO(std::hex << word);
    for (double const in : {1.0, 0x1p-1060, 1e9, 0.1}) {
      ControlWord const callers = read_control_word();
      write_control_word(word);
      runtime.step(in);
      ControlWord const behind_step = read_control_word();
      write_control_word(word);
      runtime.step_interface(in);
      ControlWord const behind_interface = read_control_word();
      write_control_word(word);
      runtime.step_velocity(in);
      ControlWord const behind_velocity = read_control_word();
      write_control_word(callers);
      CHECK(without_flags(behind_step) == without_flags(word));
      CHECK(without_flags(behind_interface) == without_flags(word));
      CHECK(without_flags(behind_velocity) == without_flags(word));
    }
  }
}

#if defined(AXISC_TEST_CONTROL_WORD)

namespace {

double first_step_from_rest(std::vector<ExactFilter> const& filters, double in) {
  TestRuntime runtime(one_axis_image(filters));
  REQUIRE(runtime.status == AXISRT_OK);
  runtime.reset_all(0);
  return runtime.step(in);
}

constexpr Quad T = Quad{1} / 1000;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("of the cycle's exceptions a caller sees only that a result was rounded") {
  SteppedRuntime runtime;
  ControlWord const callers = read_control_word();
  write_control_word(callers_control_words().front());
  std::uint32_t const before = exception_flags();
  for (double const in : {0x1p-1060, 0.1, 0x1p-1022, 1e300, not_a_number}) {
    runtime.step(in);
    runtime.step_interface(in);
    runtime.step_velocity(in);
  }
  std::uint32_t const after = exception_flags();
  write_control_word(callers);
  if (exceptions_are_restored) CHECK((after & ~inexact_flag) == before);
}

TEST_CASE("a setpoint below 2^-500 is zero inside the step") {
  for (double const in :
       {0x1p-1060, -0x1p-1060, 0x1p-1074, -0x0.fffffffffffffp-1022, 0x1.fffffffffffffp-501}) {
    CHECK(first_step_from_rest({exact::pt1(30, T)}, in) == 0);
    CHECK(first_step_from_rest({exact::bandstop(30, T, 2), exact::lowpass(60, T, 1)}, in) == 0);
    CHECK(first_step_from_rest({exact::delay(3)}, in) == 0);
  }
}

TEST_CASE("the smallest setpoints are filtered as all others") {
  // The first output of a delay with a share of s is (1 - s) in.
  ExactFilter const quarter = exact::with_share(exact::delay(5), 0.75);
  CHECK(first_step_from_rest({quarter}, 0x1p-500) == 0x1p-502);
  CHECK(first_step_from_rest({quarter}, -0x1.8p-490) == -0x1.8p-492);
}

TEST_CASE("a filter that dies away among the smallest numbers ends at zero") {
  TestRuntime runtime(one_axis_image({exact::highpass(30, T, 1), exact::pt2(20, T)}));
  REQUIRE(runtime.status == AXISRT_OK);
  runtime.reset_all(0);
  double out = 0;
  for (int cycle = 0; cycle < 20'000; ++cycle) {
    out = runtime.step(cycle < 3 ? std::ldexp(1.7, -497 - cycle) : 0);
    REQUIRE(std::fpclassify(out) != FP_SUBNORMAL);
  }
  CHECK(out == 0);
}

namespace {

/// Words that a caller may have set, on x86-64 with no exception seen so far and with all of them.
std::vector<ControlWord> words_and_flags() {
  std::vector<ControlWord> words = callers_control_words();
  if (exceptions_are_restored) {
    std::vector<ControlWord> const plain = words;
    for (ControlWord const word : plain) {
      // An exception that was seen traps on some processors as soon as it is unmasked.
      if ((word & 0x1F80) == 0x1F80) words.push_back(word | 0x3F);
    }
  }
  return words;
}

/// Calls that are not a step, with numbers that round, are subnormal, overflow or are not finite: what they
/// return, and the states and outputs behind them.
class Calls {
 public:
  explicit Calls(ControlWord word) : word_(word) {}

  std::vector<std::uint64_t> results() {
    image_ = std::make_unique<AlignedMemory>(write_image(image()));
    axisrt_config config{};
    config.size = sizeof config;
    config.cycle_time_ns = 1'000'000;
    config.image = image_->data();
    config.image_size = image_->size();
    config.level = AXISRT_LEVEL_PORTABLE;
    std::size_t size = 0;
    std::size_t alignment = 0;
    axisrt* runtime = nullptr;
    call("verify", [&] { return axisrt_verify(image_->data(), image_->size()); });
    call("memory_size", [&] { return axisrt_memory_size(&config, &size, &alignment); });
    keep(size);
    AlignedMemory memory(size);
    config.memory = memory.data();
    config.memory_size = size;
    call("create", [&] { return axisrt_create(&config, &runtime); });
    for (double const position : {1234567.7, 0x1p-1060, 0.1}) use(*runtime, position);
    for (double const time : {1e306, 0x1p-1060, 2499.9999999999, 2500.0}) {
      call("order_of_time", [&] { return axisrt_order_of_time(runtime, time); });
    }
    change(*runtime, config);
    return results_;
  }

 private:
  static ImageRecord image() {
    ImageRecord image = channel_image();
    image.axes[1].filters.push_back(exact::with_share(exact::highpass(7, T, 1), 0.3).record());
    image.axes[1].filters.back().index = 2;
    image.axes[2].filters = {exact::with_share(exact::delay(3), 0.3).record()};
    image.axes[2].interface_filters = {exact::with_share(exact::highpass(7, T, 1), 0.3).record()};
    return image;
  }

  template <class Function>
  void call(char const* name, Function function) {
    ControlWord const own = read_control_word();
    write_control_word(word_);
    auto const answer = function();
    ControlWord const behind = read_control_word();
    write_control_word(own);
    INFO(name << " " << std::hex << word_ << " " << behind);
    // That a result was rounded may be left by what runs in the cycle.
    bool const cycle = std::string_view(name) == "shadow_step";
    REQUIRE((cycle ? without_flags(behind) : behind) == (cycle ? without_flags(word_) : word_));
    keep(static_cast<std::uint64_t>(answer));
  }
  void keep(std::uint64_t value) { results_.push_back(value); }
  void keep(double value) { results_.push_back(std::bit_cast<std::uint64_t>(value)); }

  void use(axisrt& runtime, double position) {
    double const offset = position == 0.1 ? 0x1p-1050 : -1.1;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      call("reset", [&] { return axisrt_reset(&runtime, axis, position); });
      call("reset_interface", [&] { return axisrt_reset_interface(&runtime, axis, position); });
      call("reset_velocity",
           [&] { return axisrt_reset_velocity(&runtime, axis, position, -position, position); });
      see(runtime, axis);
      call("rebase", [&] { return axisrt_rebase(&runtime, axis, offset); });
      see(runtime, axis);
      double bound = 0;
      call("axis_error_bound", [&] { return axisrt_axis_error_bound(&runtime, axis, 0x1p-1060, &bound); });
      keep(bound);
    }
    for (double const number : {0.3, 0x1p-1060, not_finite}) {
      axisrt_filter_command command{};
      command.size = sizeof command;
      command.action = AXISRT_ACTION_ON;
      command.keywords = AXISRT_KEYWORD_SHARE | AXISRT_KEYWORD_ORDER;
      command.order = 3;
      command.share = number;
      call("command", [&] { return axisrt_command(&runtime, 0, &command); });
    }
    step(runtime, position);
  }

  void see(axisrt const& runtime, std::uint32_t axis) {
    axisrt_axis_state state{};
    call("get_axis_state", [&] { return axisrt_get_axis_state(&runtime, axis, &state); });
    keep(state.unfiltered);
    keep(state.filtered);
    for (double const output : state.filter_output) keep(output);
    keep(std::uint64_t{state.settled});
  }

  void step(axisrt& runtime, double position) {
    for (int cycle = 0; cycle < 50; ++cycle) {
      std::vector<double> const in(3, position + cycle * cycle * 0.37);
      std::vector<double> out(3);
      axisrt_step(&runtime, in.data(), out.data(), nullptr);
      for (double const y : out) keep(y);
      axisrt_step_interface(&runtime, in.data(), out.data(), nullptr);
      for (double const y : out) keep(y);
    }
  }

  void change(axisrt& runtime, axisrt_config config) {
    std::size_t size = 0;
    call("recorder_size", [&] { return axisrt_recorder_size(&runtime, &config, 10, &size); });
    AlignedMemory memory(size);
    config.memory = memory.data();
    config.memory_size = size;
    axisrt_recorder* recorder = nullptr;
    call("recorder_start", [&] { return axisrt_recorder_start(&runtime, &config, 10, &recorder); });
    step(runtime, 5.3);
    std::vector<std::uint8_t> dump(1 << 16);
    std::size_t needed = 0;
    call("recorder_dump", [&] { return axisrt_recorder_dump(recorder, dump.data(), dump.size(), &needed); });
    axisrt_recorder_stop(recorder);
    axisrt* made = nullptr;
    call("restore", [&] { return axisrt_restore(&config, dump.data(), needed, &made); });
    step(*made, 0.7);
    call("prepare", [&] { return axisrt_prepare(&runtime, &config, 0, &made); });
    for (int cycle = 0; cycle < 10; ++cycle) {
      step(runtime, 0.1 * cycle);
      call("shadow_step", [&] { return axisrt_shadow_step(made); });
      call("swap", [&] { return axisrt_swap(made); });
    }
    step(*made, 77.7);
  }

  static constexpr double not_finite = std::numeric_limits<double>::quiet_NaN();
  ControlWord word_;
  std::unique_ptr<AlignedMemory> image_;
  std::vector<std::uint64_t> results_;
};

}  // namespace

TEST_CASE("no call depends on the caller's control word or changes it") {
  std::vector<std::uint64_t> const expected = Calls(callers_control_words().front()).results();
  REQUIRE(expected.size() > 1000);
  for (ControlWord const word : words_and_flags()) {
    std::vector<std::uint64_t> const results = Calls(word).results();
    INFO(std::hex << word);
    CHECK(results == expected);
  }
}

#endif
