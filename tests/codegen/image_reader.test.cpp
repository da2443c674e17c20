#include "codegen/image_contents.hpp"
#include "codegen/image_writer.hpp"
#include "codegen/source_digest.hpp"
#include "machines.hpp"
#include "support/catch.hpp"

namespace axisc::codegen {
namespace {

void check_filter(ImageFilter const& filter, validator::ConfiguredFilter const& configured,
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

void check_chain(std::vector<ImageFilter> const& chain,
                 std::vector<validator::ConfiguredFilter> const& configured, design::CycleTime cycle_time) {
  REQUIRE(chain.size() == configured.size());
  for (std::size_t i = 0; i < chain.size(); ++i) check_filter(chain[i], configured[i], cycle_time);
}

}  // namespace

TEST_CASE("what is written is read back", "[image]") {
  validator::Machine const machine = test::sample_machine();
  std::vector<std::byte> const image = write_image(machine, {.image_version = 41});
  ImageContents const contents = test::contents_of(image);

  CHECK(contents.format_major == 1);
  CHECK(contents.format_minor == 0);
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
    ImageAxis const& axis = contents.axes[i];
    validator::AxisConfiguration const& configured = machine.axes[i];
    CHECK(axis.name == configured.name);
    CHECK(axis.number == configured.number);
    CHECK(axis.type == static_cast<std::uint32_t>(configured.type));
    CHECK(axis.position_window == configured.position_window);
    CHECK(axis.velocity_limit == configured.velocity_limit);
    CHECK(axis.acceleration_limit == configured.acceleration_limit);
    check_chain(axis.filters, configured.filters, machine.cycle_time);
    check_chain(axis.interface_filters, configured.interface_filters, machine.cycle_time);

    double delay = 0;
    for (ImageFilter const& filter : axis.filters) delay += filter.design.group_delay_cycles;
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

TEST_CASE("an image that verify refuses is not read", "[image]") {
  std::vector<std::byte> image = write_image(test::sample_machine(), {});
  image[image.size() / 2] ^= std::byte{1};
  auto const refused = read_image(image);
  REQUIRE(std::holds_alternative<axisrt_status>(refused));
  CHECK(std::get<axisrt_status>(refused) == AXISRT_WRONG_CHECKSUM);

  auto const nothing = read_image({});
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
