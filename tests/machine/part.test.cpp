// Some axes of a machine are compiled as the machine compiles them.
#include "configuration/machine/part.hpp"

#include "codegen/image_writer.hpp"
#include "image/chain_figures.hpp"
#include "image/step_answers.hpp"
#include "support/catch.hpp"
#include "tests/codegen/machines.hpp"

#include <algorithm>
#include <vector>

namespace axisc::codegen {
namespace {

void check_same(image::ChainFigures const& a, image::ChainFigures const& b) {
  CHECK(a.delay_cycles == b.delay_cycles);
  CHECK(a.settling_cycles == b.settling_cycles);
  CHECK(a.overshoot == b.overshoot);
  CHECK(a.corner_deviation == b.corner_deviation);
}

}  // namespace

TEST_CASE("an axis does alone what it does in its machine, and all at once what each does", "[image]") {
  for (machine::Machine const& whole : {test::sample_machine(), test::kernel_machine()}) {
    auto const image = write_image(whole, {});
    auto const contents = test::contents_of(image);
    std::vector<std::size_t> axes;
    for (std::size_t axis = whole.axes.size(); axis > 0; --axis) axes.push_back(axis - 1);
    auto const together = image::chain_figures(image, contents, axes);
    REQUIRE(together.size() == axes.size());
    for (std::size_t i = 0; i < axes.size(); ++i) {
      INFO(whole.axes[axes[i]].name);
      check_same(together[i], image::chain_figures(image, contents, axes[i]));
      auto const part = machine::part_of(whole, std::vector{axes[i]});
      REQUIRE(part.machine.axes.front().name == whole.axes[axes[i]].name);
      auto const own = write_image(part.machine, {});
      check_same(together[i], image::chain_figures(own, test::contents_of(own), std::size_t{0}));
    }
  }
}

TEST_CASE("steps of all axes are executed once, however many ask", "[image]") {
  auto const image = write_image(test::sample_machine(), {});
  auto const contents = test::contents_of(image);
  image::StepAnswers steps(image, contents);
  CHECK(steps.cycles() == 0);
  auto created = image::RuntimeHost::create(image);
  auto& host = std::get<image::RuntimeHost>(created);
  REQUIRE(host.reset_all(0) == AXISRT_OK);
  std::vector<double> const setpoints(contents.axes.size(), 1);
  std::vector<double> filtered(setpoints.size());
  for (std::uint64_t n = 1; n <= 50; ++n) {
    static_cast<void>(host.step(setpoints, filtered));
    for (std::size_t axis = 0; axis < filtered.size(); ++axis) {
      auto const answer = steps.answer(axis, n);
      REQUIRE(answer.size() == n);
      CHECK(answer.back() == filtered[axis]);
    }
    CHECK(steps.cycles() == n);
  }
  CHECK(steps.answer(0, 20).size() == 20);
  CHECK(steps.cycles() == 50);
  for (std::size_t axis = 0; axis < contents.axes.size(); ++axis) {
    check_same(steps.figures(axis), image::chain_figures(image, contents, axis));
  }
}

TEST_CASE("a part has the channels of its axes, with these alone, and the masters that they follow") {
  machine::Machine const whole = test::kernel_machine();
  auto const slave = std::find_if(whole.axes.begin(), whole.axes.end(),
                                  [](machine::AxisConfiguration const& axis) { return axis.gantry_master; });
  REQUIRE(slave != whole.axes.end());
  auto const index = static_cast<std::size_t>(slave - whole.axes.begin());
  auto const part = machine::part_of(whole, std::vector{index});
  REQUIRE(part.machine.axes.size() == 2);
  CHECK(part.machine.axes[0].name == slave->name);
  CHECK(part.machine.axes[0].gantry_master == 1);
  CHECK(part.machine.axes[1].name == whole.axes[*slave->gantry_master].name);
  REQUIRE(part.groups.size() == part.machine.groups.size());
  for (std::size_t i = 0; i < part.groups.size(); ++i) {
    machine::MachineGroup const& group = whole.groups[part.groups[i]];
    CHECK(std::find(group.axes.begin(), group.axes.end(), index) != group.axes.end());
    CHECK(part.machine.groups[i].name == group.name);
    CHECK(part.machine.groups[i].axes == std::vector<std::size_t>{0});
    CHECK(part.machine.groups[i].filter_sets == group.filter_sets);
  }
}

}  // namespace axisc::codegen
