// What lists say about how fast a channel drives its path. Defaults and meanings: manual "Channel
// parameters".
#include "configuration/channel_dynamics.hpp"

#include "support/catch.hpp"

namespace {

using namespace axisc;
using namespace axisc::configuration;
using machine::Slope;

ListedDynamics read(std::string text) {
  ListedDynamics listed;
  SourceText const source("sda.lis", std::move(text));
  read_channel_dynamics(listed_values(source, SourceId{}), listed);
  return listed;
}

std::uint32_t blocks(std::string text, Slope slope = Slope::step) {
  return look_ahead_blocks(read(std::move(text)).look_ahead, slope, 120);
}

}  // namespace

TEST_CASE("a channel list that says nothing leaves the control's defaults") {
  auto const dynamics = read("gruppe[0].bezeichnung Mill\n").dynamics;
  CHECK(dynamics.is_from_list);
  CHECK(dynamics.slope == Slope::step);
  CHECK_FALSE(dynamics.constant_ramp_times);
  CHECK(dynamics.weighted_acceleration == 0);
  CHECK(dynamics.weighted_ramp == 0);
  CHECK_FALSE(dynamics.limits_curvature_steps);
  CHECK(dynamics.transition_mode == 0);
  CHECK_FALSE(dynamics.stops_after_rapid);
  CHECK(dynamics.vector.velocity == 2e9);
  CHECK(dynamics.vector.acceleration == 1e8);
  CHECK(dynamics.vector.per_minute);
  CHECK_FALSE(dynamics.vector.limits_circles);
  CHECK_FALSE(machine::ChannelDynamics{}.is_from_list);
}

TEST_CASE("each parameter of a channel list reaches its value") {
  auto const dynamics =
      read(
          "prog_start.slope.profile 2 ( P-CHAN-00071\nprog_start.slope.mode_ramp_time 1\n"
          "prog_start.slope.acceleration 1\nprog_start.slope.ramp_time 4\n"
          "corr_v_trans_jerk TRUE\nmode_trans_jerk 2\nexact_stop_after_g00 1\n"
          "vector.velocity 1500\nvector.acceleration 1800000\nvector.deceleration 2000000.5\n"
          "vector.radial_acceleration 1000\nvector.cir_radial_acc_limit 1\n"
          "vector.acc_dec_unit MM_S2\n")
          .dynamics;
  CHECK(dynamics.slope == Slope::sin2);
  CHECK(dynamics.constant_ramp_times);
  CHECK(dynamics.weighted_acceleration == 1);
  CHECK(dynamics.weighted_ramp == 4);
  CHECK(dynamics.limits_curvature_steps);
  CHECK(dynamics.transition_mode == 2);
  CHECK(dynamics.stops_after_rapid);
  CHECK(dynamics.vector.velocity == 1500);
  CHECK(dynamics.vector.acceleration == 1800000);
  CHECK(dynamics.vector.deceleration == 2000000.5);
  CHECK(dynamics.vector.radial_acceleration == 1000);
  CHECK(dynamics.vector.limits_circles);
  CHECK_FALSE(dynamics.vector.per_minute);
}

TEST_CASE("of a channel parameter the last line counts, and a value that is none changes nothing") {
  CHECK(read("prog_start.slope.profile 1\nPROG_START.SLOPE.PROFILE 3\n").dynamics.slope == Slope::hsc);
  CHECK(read("prog_start.slope.profile 1\nprog_start.slope.profile 7\n").dynamics.slope == Slope::trapez);
  CHECK(read("mode_trans_jerk 5\n").dynamics.transition_mode == 0);
  CHECK(read("vector.velocity fast\n").dynamics.vector.velocity == 2e9);
}

TEST_CASE("the look-ahead buffer by its function") {
  CHECK(blocks("") == 120);
  CHECK(blocks("configuration.interpolator.function FCT_IPO_DEFAULT | FCT_SYNC\n") == 120);
  CHECK(blocks("configuration.interpolator.function FCT_LOOK_AHEAD_STANDARD\n") == 120);
  CHECK(blocks("configuration.interpolator.function FCT_LOOK_AHEAD_LOW\n") == 30);
  CHECK(blocks("configuration.interpolator.function FCT_SYNC |FCT_LOOK_AHEAD_HIGH\n") == 190);
  // The number counts with CUSTOM alone.
  CHECK(blocks("configuration.interpolator.number_blocks_lah 50\n") == 120);
  std::string const custom = "configuration.interpolator.function FCT_LOOK_AHEAD_CUSTOM\n";
  CHECK(blocks(custom) == 120);
  CHECK(blocks(custom + "configuration.interpolator.number_blocks_lah 50\n") == 50);
  CHECK(blocks(custom + "configuration.interpolator.parameter 60\n") == 60);
  CHECK(blocks(custom + "configuration.interpolator.number_blocks_lah 2\n") == 10);
  CHECK(blocks(custom + "configuration.interpolator.number_blocks_lah 5000\n") == 5000);
  CHECK(blocks(custom + "configuration.interpolator.number_blocks_lah 5000\n", Slope::trapez) == 500);
  CHECK(blocks(custom + "configuration.interpolator.number_blocks_lah 50000\n") == 10000);
}

TEST_CASE("a start-up list names the buffer of each channel") {
  SourceText const source("hochlauf.lis",
                          "configuration.channel[0].interpolator.function FCT_LOOK_AHEAD_LOW\n"
                          "configuration.channel[1].interpolator.function FCT_LOOK_AHEAD_CUSTOM\n"
                          "configuration.channel[1].interpolator.number_blocks_lah 77\n");
  auto const values = listed_values(source, SourceId{});
  auto const of = [&](std::uint32_t channel) {
    ListedLookAhead listed;
    read_look_ahead(values, channel, listed);
    return look_ahead_blocks(listed, Slope::step, 70);
  };
  CHECK(of(0) == 30);
  CHECK(of(1) == 77);
  CHECK(of(2) == 70);
}

TEST_CASE("parameters that no plan computes are named where they are not 0") {
  auto const named = [](std::string text) {
    std::vector<std::string> numbers;
    for (auto const& value : read(std::move(text)).uncomputed) numbers.emplace_back(value.number);
    return numbers;
  };
  using Numbers = std::vector<std::string>;
  CHECK(named("dynamic_weighting_active 0\ncurve_dynamic_weighting_active FALSE\n").empty());
  CHECK(
      named("dynamic_weighting_active 1\ncurve_dynamic_weighting_active 1\ntrans_limit_with_curvature 2\n") ==
      Numbers{"P-CHAN-00190", "P-CHAN-00230", "P-CHAN-00245"});
  CHECK(named("dynamic_weighting_active 1\ndynamic_weighting_active 0\n").empty());
}
