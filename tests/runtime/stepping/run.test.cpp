// A block of cycles is the cycles one by one, bit for bit, and nothing is executed where its arrays cannot
// be.
#include "support/catch.hpp"
#include "tests/runtime/test_runtime.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace run_test {

using namespace axisc::test;

namespace {

constexpr std::size_t cycles = 150;

std::vector<double> setpoints(std::size_t axes) {
  std::vector<double> in;
  for (std::size_t i = 0; i < cycles * axes; ++i) {
    in.push_back(500 * std::sin(static_cast<double>(i / axes) / 40 + static_cast<double>(i % axes)));
  }
  return in;
}

struct Outputs {
  std::vector<double> values;
  std::vector<std::uint8_t> status;
  axisrt_status worst = AXISRT_OK;
};

Outputs one_by_one(TestRuntime& runtime, std::vector<double> const& in) {
  std::size_t const axes = axisrt_axis_count(runtime.runtime);
  Outputs outputs{.values = std::vector<double>(in.size()), .status = std::vector<std::uint8_t>(in.size())};
  for (std::size_t row = 0; row < in.size(); row += axes) {
    outputs.worst = std::max(
        outputs.worst, axisrt_step(runtime.runtime, &in[row], &outputs.values[row], &outputs.status[row]));
  }
  return outputs;
}

}  // namespace

TEST_CASE("axisrt_run is axisrt_step for each row") {
  for (ImageRecord const& image : {complete_image(), channel_image()}) {
    TestRuntime stepped(write_image(image));
    TestRuntime run(write_image(image));
    TestRuntime in_place(write_image(image));
    if (stepped.status == AXISRT_NO_LEVEL) return;
    for (auto* const runtime : {&stepped, &run, &in_place}) runtime->reset_all(0);
    auto in = setpoints(axisrt_axis_count(run.runtime));
    in[in.size() / 2] = std::numeric_limits<double>::quiet_NaN();
    auto const wanted = one_by_one(stepped, in);
    Outputs got{.values = std::vector<double>(in.size()), .status = std::vector<std::uint8_t>(in.size())};
    got.worst = axisrt_run(run.runtime, in.data(), got.values.data(), in.size(), got.status.data());
    CHECK(got.values == wanted.values);
    CHECK(got.status == wanted.status);
    CHECK(got.worst == wanted.worst);
    CHECK(got.worst >= AXISRT_BAD_INPUT);
    CHECK(axisrt_run(in_place.runtime, in.data(), in.data(), in.size(), nullptr) == wanted.worst);
    CHECK(in == wanted.values);
  }
}

TEST_CASE("axisrt_run executes nothing where its arrays are not whole rows, or overlap") {
  TestRuntime runtime(write_image(complete_image()));
  if (runtime.status == AXISRT_NO_LEVEL) return;
  REQUIRE(axisrt_axis_count(runtime.runtime) == 2);
  runtime.reset_all(3);
  std::vector<double> values(12, 7.0);
  std::vector<double> out(12, 7.0);
  auto* const bytes = reinterpret_cast<std::uint8_t*>(values.data());
  auto const refuses = [&](double const* in, double* to, std::size_t count, std::uint8_t* status) {
    return axisrt_run(runtime.runtime, in, to, count, status) == AXISRT_BAD_ARGUMENT;
  };
  CHECK(refuses(values.data(), out.data(), 3, nullptr));
  CHECK(refuses(values.data(), values.data() + 2, 4, nullptr));
  CHECK(refuses(values.data() + 2, values.data(), 4, nullptr));
  CHECK(refuses(values.data(), out.data(), 4, bytes + 31));
  CHECK(refuses(out.data(), values.data(), 4, bytes));
  CHECK(refuses(nullptr, out.data(), 4, nullptr));
  CHECK(refuses(values.data(), nullptr, 4, nullptr));
  CHECK(refuses(values.data(), out.data(), SIZE_MAX - 1, nullptr));
  CHECK(axisrt_run(nullptr, values.data(), out.data(), 4, nullptr) == AXISRT_BAD_ARGUMENT);
  CHECK(out == std::vector<double>(12, 7.0));
  CHECK(values == std::vector<double>(12, 7.0));
  CHECK(runtime.state().unfiltered == 3);
  CHECK(axisrt_run(runtime.runtime, values.data(), out.data(), 0, nullptr) == AXISRT_OK);
  CHECK(axisrt_run(runtime.runtime, values.data(), values.data() + 4, 4, bytes + 64) == AXISRT_OK);
}

}  // namespace run_test
