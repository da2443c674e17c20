#include "codegen/image_writer.hpp"
#include "codegen/source_digest.hpp"
#include "image/image_contents.hpp"
#include "support/catch.hpp"
#include "tests/codegen/machines.hpp"

namespace axisc::codegen {
namespace {

void check_filter(image::ImageFilter const& filter, machine::ConfiguredFilter const& configured,
                  design::CycleTime cycle_time) {
  CHECK(filter.index == configured.index);
  CHECK(filter.specification == configured.specification);
  design::FilterDesign const expected =
      design::design_filter(configured.specification, cycle_time, design::Precision::exact);
  CHECK(filter.design.realisation == expected.realisation);
  CHECK(filter.design.sections == expected.sections);
  CHECK(filter.design.blocks_constant == expected.blocks_constant);
  CHECK(filter.design.delay_cycles == expected.delay_cycles);
  CHECK(filter.design.share.filtered == expected.share.filtered);
  CHECK(filter.design.share.direct == expected.share.direct);
  CHECK(filter.design.share.direct_low == expected.share.direct_low);
  CHECK(filter.design.pole_radius == expected.pole_radius);
  CHECK(filter.design.dc_gain == expected.dc_gain);
  CHECK(filter.design.group_delay_cycles == expected.group_delay_cycles);
  CHECK(filter.kernel_sum == 1);
  CHECK(filter.peak_gain >= Approx(filter.design.dc_gain).epsilon(1e-12));
  CHECK(filter.overshoot >= 0);
  CHECK(filter.self_test_input.size() == 32 + expected.delay_cycles);
  CHECK(filter.self_test_output.size() == filter.self_test_input.size());
}

void check_chain(std::vector<image::ImageFilter> const& chain,
                 std::vector<machine::ConfiguredFilter> const& configured, design::CycleTime cycle_time) {
  REQUIRE(chain.size() == configured.size());
  for (std::size_t i = 0; i < chain.size(); ++i) check_filter(chain[i], configured[i], cycle_time);
}

}  // namespace

TEST_CASE("what is written is read back", "[image]") {
  machine::Machine const machine = test::sample_machine();
  std::vector<std::byte> const image = write_image(machine, {.image_version = 41});
  image::ImageContents const contents = test::contents_of(image);

  CHECK(contents.format_major == 1);
  CHECK(contents.format_minor == 1);
  CHECK(contents.size == image.size());
  CHECK(contents.cycle_time == machine.cycle_time);
  CHECK(contents.image_version == 41);
  CHECK_FALSE(contents.compiler_version.empty());
  CHECK(contents.source_digest == source_digest(machine.lists));

  REQUIRE(contents.lists.size() == machine.lists.size());
  for (std::size_t i = 0; i < contents.lists.size(); ++i) {
    CHECK(contents.lists[i].name == machine.lists[i].name);
    CHECK(contents.lists[i].sha256 == sha256(machine.lists[i].content));
  }

  REQUIRE(contents.axes.size() == machine.axes.size());
  for (std::size_t i = 0; i < contents.axes.size(); ++i) {
    image::ImageAxis const& axis = contents.axes[i];
    machine::AxisConfiguration const& configured = machine.axes[i];
    CHECK(axis.name == configured.name);
    CHECK(axis.number == configured.number);
    CHECK(axis.type == static_cast<std::uint32_t>(configured.type));
    CHECK(axis.position_window == configured.position_window);
    CHECK(axis.velocity_limit == configured.velocity_limit);
    CHECK(axis.acceleration_limit == configured.acceleration_limit);
    check_chain(axis.filters, configured.filters, machine.cycle_time);
    check_chain(axis.interface_filters, configured.interface_filters, machine.cycle_time);

    double delay = 0;
    for (image::ImageFilter const& filter : axis.filters) delay += filter.design.group_delay_cycles;
    CHECK(axis.delay_cycles == Approx(delay).epsilon(1e-14));
    CHECK(axis.peak_gain >= 1);

    REQUIRE(axis.values.size() == configured.values.size());
    for (std::size_t j = 0; j < axis.values.size(); ++j) {
      CHECK(axis.values[j].name == configured.values[j].name);
      CHECK(axis.values[j].value == configured.values[j].text);
      CHECK(axis.values[j].list == machine.lists[configured.values[j].list].name);
      CHECK(axis.values[j].line == configured.values[j].line);
    }
  }
}

TEST_CASE("kernels, channels and banks are read back", "[image]") {
  machine::Machine const machine = test::kernel_machine();
  image::ImageContents const contents = test::contents_of(write_image(machine, {}));

  image::ImageSlot const slot = contents.axes[0].slot.value();
  CHECK(slot.family == machine::KernelFamily::fir);
  CHECK(slot.on_at_start);
  CHECK(slot.group == 0U);
  image::ImageKernel const& kernel = contents.kernels.at(slot.kernel.value());
  CHECK(kernel.specification.type == design::KernelType::gaussian);
  CHECK(kernel.specification.order == 21);
  CHECK(kernel.specification.quality == 0.75);
  design::KernelDesign const design =
      design::design_kernel(machine.axes[0].kernel->specification, machine.cycle_time);
  CHECK(kernel.design.tail_sums == design.tail_sums);
  CHECK(kernel.design.half_width == 11);
  CHECK(kernel.design.delay_cycles == 11);
  CHECK(kernel.design.group_delay_cycles == 11);
  CHECK(kernel.design.kernel_sum == 1);
  REQUIRE(kernel.design.taps.size() == 23);
  for (std::size_t i = 0; i < 23; ++i) CHECK(kernel.design.taps[i] == Approx(design.taps[i]).margin(1e-15));
  CHECK(kernel.peak_gain == 1);
  CHECK(kernel.overshoot == 0);
  CHECK(kernel.tail_gain >= 11);
  CHECK(kernel.tail_gain <= 11 * (1 + 1e-12));
  CHECK(kernel.self_test_input.size() == 32 + 22);
  CHECK(kernel.self_test_output.size() == 32 + 22);
  CHECK(contents.axes[0].delay_cycles == Approx(11 + 5).epsilon(1e-2));  // and the PT1

  image::ImageSlot const hsc = contents.axes[2].slot.value();
  CHECK(hsc.family == machine::KernelFamily::hsc);
  CHECK_FALSE(hsc.on_at_start);
  CHECK(contents.kernels[hsc.kernel.value()].specification.share_percent == 90);
  CHECK(contents.axes[2].delay_cycles == 0);
  CHECK_FALSE(contents.axes[3].slot);
  CHECK_FALSE(contents.axes[4].slot->kernel);

  REQUIRE(contents.groups.size() == 2);
  image::ImageGroup const& mill = contents.groups[0];
  CHECK(mill.name == "mill");
  CHECK(mill.members == std::vector<std::size_t>{0, 3, 1, 2});
  CHECK(mill.off_fade_cycles > 0);
  REQUIRE(mill.banks.size() == 7);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(mill.banks[i + 1].parameters == machine.groups[0].filter_sets[i]);
    CHECK_FALSE(mill.banks[i + 1].hsc);
  }
  CHECK(mill.banks[0].parameters.empty());
  CHECK(mill.banks[0].kernels[0] == slot.kernel);
  CHECK_FALSE(mill.banks[0].kernels[1]);
  CHECK(mill.banks[0].fade_cycles > 0);
  CHECK(mill.banks[6].hsc);
  CHECK(mill.banks[6].kernels[3] == hsc.kernel);
  CHECK(contents.groups[1].name == "turn");

  image::ImageContents const stripped = test::contents_of(write_image(machine, {.strip = true}));
  CHECK(stripped.groups[0].name.empty());
  CHECK(stripped.kernels[0].self_test_input.empty());
  CHECK(stripped.kernels[0].design.tail_sums == contents.kernels[0].design.tail_sums);
}

TEST_CASE("position control is read back", "[image]") {
  machine::Machine const machine = test::kernel_machine();
  image::ImageContents const contents = test::contents_of(write_image(machine, {}));
  image::ImageControl const control = contents.axes[0].control.value();
  CHECK(control.source == 0);
  CHECK(control.limit == 500'000);
  CHECK(control.limit_factor == 1000);
  CHECK(control.scaling.controller == machine::PositionController::drive);
  CHECK(control.scaling.v_reso_num == 3);
  CHECK(control.scaling.v_reso_denom == 7);
  CHECK(control.scaling.time_base == 2);
  CHECK(control.increments_per_velocity == Approx(3.0 / 7 * 0.001).epsilon(1e-15));
  REQUIRE(control.stages.size() == 2);
  CHECK(control.stages[0].mode == machine::StageMode::direct);
  CHECK_FALSE(control.stages[0].has_oscillator);
  CHECK(control.stages[0].weight == 3);
  REQUIRE(control.stages[0].filters.size() == 1);
  CHECK(control.stages[0].filters[0].specification == machine.axes[0].position_control->stages[0].filters[0]);
  CHECK(control.stages[1].index == 1);
  CHECK(control.stages[1].mode == machine::StageMode::indirect);
  CHECK(control.stages[1].has_oscillator);
  CHECK(control.stages[1].weight == 1.9);
  CHECK(control.stages[1].weight_numerator == 190);
  CHECK(control.stages[1].weight_denominator == 100);
  REQUIRE(control.stages[1].filters.size() == 2);
  CHECK(control.stages[1].filters[0].specification.frequency.value == 11);
  CHECK(control.stages[1].filters[0].specification.quality == 0.8);
  CHECK(control.stages[1].filters[0].design.dc_gain == 1);
  CHECK(control.stages[1].filters[1].design.blocks_constant);

  image::ImageControl const slave = contents.axes[3].control.value();
  CHECK(slave.source == 0);
  CHECK(slave.stages.empty());
  CHECK(slave.limit == 500'000);
  CHECK(slave.scaling.multi_gain_z == 8);
  CHECK(slave.increments_per_velocity == Approx(6e-5 * 8 / 3).epsilon(1e-15));
  CHECK_FALSE(contents.axes[1].control);
}

TEST_CASE("an image that verify refuses is not read", "[image]") {
  std::vector<std::byte> image = write_image(test::sample_machine(), {});
  image[image.size() / 2] ^= std::byte{1};
  auto const refused = image::read_image(image);
  REQUIRE(std::holds_alternative<axisrt_status>(refused));
  CHECK(std::get<axisrt_status>(refused) == AXISRT_WRONG_CHECKSUM);

  auto const nothing = image::read_image({});
  REQUIRE(std::holds_alternative<axisrt_status>(nothing));
  CHECK(std::get<axisrt_status>(nothing) == AXISRT_TOO_SHORT);
}

TEST_CASE("the bytes may lie anywhere", "[image]") {
  std::vector<std::byte> const image = write_image(test::sample_machine(), {});
  std::vector<std::byte> shifted(image.size() + 64);
  for (std::size_t shift = 1; shift < 64; shift += 21) {
    auto const begin = shifted.begin() + static_cast<std::ptrdiff_t>(shift);
    std::copy(image.begin(), image.end(), begin);
    CHECK(test::contents_of(std::span(shifted).subspan(shift, image.size())).axes.size() == 4);
  }
}

}  // namespace axisc::codegen
