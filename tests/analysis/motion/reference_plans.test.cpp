// Plans that an independent program computed from the lists and words of a channel. They are read here
// without the list reader and the interpreter, so that nothing but the planner is looked at.
#include "analysis/motion/program/arc_words.hpp"
#include "planned_path.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

namespace axisc::motion::reference_plans_test {
namespace {

using nlohmann::json;

/// Values of an axis list, with the defaults of the control.
class List {
 public:
  explicit List(json const& lines) : lines_(lines) {}

  [[nodiscard]] double value(std::string const& name, double otherwise) const {
    return lines_.contains(name) ? lines_.at(name).get<double>() : otherwise;
  }
  [[nodiscard]] double gear(std::string const& name, double otherwise) const {
    return value("getriebe[0]." + name, otherwise);
  }

 private:
  json const& lines_;
};

machine::AccelerationRamp ramp(double acceleration, double build_up, double take_back, double least) {
  return {.acceleration = acceleration,
          .build_up = std::max(build_up, least),
          .take_back = std::max(take_back, least)};
}

machine::AxisDynamics axis_of(List const& list) {
  machine::AxisDynamics axis;
  double const a_max = list.gear("dynamik.a_max", 1000);
  double const tr_min = list.gear("dynamik.tr_min", 10000);
  auto const capped = [&](double a) { return std::min(a, a_max); };
  auto const slope = [&](char const* name, double otherwise) {
    return list.gear(std::string("slope_profil.") + name, otherwise);
  };
  auto const step = [&](char const* name, double otherwise) {
    return list.gear(std::string("lslope_profil.") + name, otherwise);
  };
  axis.feed.velocity = list.gear("dynamik.vb_max", 200'000);
  axis.rapid.velocity = std::min(list.gear("vb_eilgang", 166'666), axis.feed.velocity);
  auto const stages = [&](char const* first, char const* second, char const* changeover) {
    return machine::AccelerationStages{.first = capped(step(first, 1000)),
                                       .second = capped(step(second, 1000)),
                                       .changeover = step(changeover, 100'000)};
  };
  auto const down = [&](machine::AccelerationStages up, char const* first, char const* second) {
    if (step(first, 0) > 0) up.first = capped(step(first, 0));
    if (step(second, 0) > 0) up.second = capped(step(second, 0));
    return up;
  };
  axis.feed.step_up = stages("a_stufe_1", "a_stufe_2", "vb_stufe_1_2");
  axis.feed.step_down = down(axis.feed.step_up, "d_stufe_1", "d_stufe_2");
  axis.rapid.step_up = stages("a_grenz_stufe_1", "a_grenz_stufe_2", "vb_grenz_stufe_1_2");
  axis.rapid.step_down = down(axis.rapid.step_up, "d_grenz_stufe_1", "d_grenz_stufe_2");
  axis.feed.up = ramp(capped(slope("a_beschl", 1000)), slope("tr_beschl_zu", 50'000),
                      slope("tr_beschl_ab", 50'000), tr_min);
  axis.feed.down = ramp(capped(slope("a_brems", 1000)), slope("tr_brems_zu", 50'000),
                        slope("tr_brems_ab", 50'000), tr_min);
  double const rapid = capped(list.gear("dynamik.a_grenz", list.gear("slope_profil.a_grenz", 1000)));
  double const tr_rapid = list.gear("dynamik.tr_grenz", list.gear("slope_profil.tr_grenz", 10'000));
  axis.rapid.up = axis.rapid.down = ramp(rapid, tr_rapid, tr_rapid, tr_min);
  axis.curve_ramp_time = std::max(list.gear("dynamik.tr_geom", 10'000), tr_min);
  axis.highest_acceleration = a_max;
  axis.shortest_ramp_time = tr_min;
  axis.acceleration_transition_weight = list.gear("dynamik.a_trans_weight", 0);
  axis.curvature_transition_weight = list.gear("dynamik.r_trans_weight", 1000);
  return axis;
}

machine::ChannelDynamics channel_of(json const& lines) {
  machine::ChannelDynamics channel;
  auto const number = [&](char const* name, int otherwise) {
    return lines.contains(name) ? lines.at(name).get<int>() : otherwise;
  };
  channel.slope = static_cast<machine::Slope>(number("prog_start.slope.profile", 0));
  channel.constant_ramp_times = number("prog_start.slope.mode_ramp_time", 0) == 1;
  channel.limits_curvature_steps = number("corr_v_trans_jerk", 0) == 1;
  channel.transition_mode = static_cast<std::uint8_t>(number("mode_trans_jerk", 0));
  channel.look_ahead_blocks =
      static_cast<std::uint32_t>(number("configuration.interpolator.number_blocks_lah", 120));
  return channel;
}

/// Runs the few words that the plans use.
class Program {
 public:
  Program(std::vector<std::string> axes, PathDynamics const& dynamics, LookAhead& planner)
      : axes_(std::move(axes)), planner_(planner), T_(dynamics.cycle_time.seconds()) {
    words_.slope = dynamics.channel.slope;
    words_.constant_ramp_times = dynamics.channel.constant_ramp_times;
  }

  void line(std::string const& text) {
    if (text.starts_with("#SLOPE [TYPE=")) {
      std::map<std::string, machine::Slope> const slopes = {{"STEP", machine::Slope::step},
                                                            {"TRAPEZ", machine::Slope::trapez},
                                                            {"SIN2", machine::Slope::sin2},
                                                            {"HSC", machine::Slope::hsc}};
      words_.slope = slopes.at(text.substr(13, text.size() - 14));
      said_.reset();
      return;
    }
    block_ = {};
    block_.end = position_;
    std::map<char, double> center;
    bool moves = false;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
      if (word[0] == 'N') {
        block_.label = word;
      } else if (word[0] == 'G') {
        function(word);
      } else if (word[0] == 'F') {
        feed_ = std::stod(word.substr(1)) / 60 * units_per_mm * T_;
      } else if (word[0] == 'I' || word[0] == 'J') {
        center[word[0]] = std::stod(word.substr(1)) * units_per_mm;
        moves = true;
      } else {
        auto const axis = std::find(axes_.begin(), axes_.end(), word.substr(0, 1)) - axes_.begin();
        REQUIRE(axis < static_cast<std::ptrdiff_t>(axes_.size()));
        block_.end[static_cast<std::size_t>(axis)] = std::stod(word.substr(1)) * units_per_mm;
        moves = true;
      }
    }
    if (moves) move(center);
  }

 private:
  void function(std::string const& word) {
    auto const percent = [&] { return std::stod(word.substr(word.find('=') + 1)); };
    if (word.starts_with("G131=")) {
      for (auto& axis : words_.feed) axis.up.acceleration = axis.down.acceleration = percent();
      said_.reset();
    } else if (word.starts_with("G133=")) {
      for (auto& axis : words_.feed) {
        axis.up.build_up = axis.up.take_back = axis.down.build_up = axis.down.take_back = percent();
      }
      said_.reset();
    } else if (word == "G60") {
      block_.exact_stop = true;
    } else if (word == "G360" || word == "G359") {
      stops_ = word == "G360";
    } else if (word == "G901" || word == "G900") {
      brakes_late_ = word == "G901";
    } else {
      motion_ = std::stoi(word.substr(1));
      REQUIRE(motion_ <= 3);
    }
  }

  void move(std::map<char, double> const& center) {
    if (!said_) said_ = std::make_shared<BlockDynamics const>(words_);
    block_.dynamics = said_;
    block_.rapid = motion_ == 0;
    if (!block_.rapid) block_.feed = feed_;
    block_.exact_stop = block_.exact_stop || stops_;
    block_.brakes_late = brakes_late_;
    if (motion_ >= 2) {
      ArcWords arc;
      arc.clockwise = motion_ == 2;
      arc.to_center_first = center.contains('I') ? center.at('I') : 0;
      arc.to_center_second = center.contains('J') ? center.at('J') : 0;
      block_.arc = std::make_shared<Arc const>(std::get<Arc>(arc_of(arc, position_, block_.end)));
    }
    position_ = block_.end;
    planner_.add(block_);
  }

  std::vector<std::string> axes_;
  LookAhead& planner_;
  double T_;
  BlockDynamics words_;
  std::shared_ptr<BlockDynamics const> said_;
  ProgrammedBlock block_;
  Point position_{};
  int motion_ = 1;
  double feed_ = 0;
  bool stops_ = false, brakes_late_ = false;
};

/// Position and velocity so many cycles after the start.
struct Place {
  Point position{};
  double velocity = 0;
};

Place place_at(test::PlannedPath const& path, double time) {
  for (auto const& block : path.blocks) {
    double way = 0;
    for (auto const& phase : block.phases) {
      if (time <= phase.duration) {
        return {.position = block.block.path.at(way + phase.way_at(time)),
                .velocity = phase.velocity_at(time)};
      }
      time -= phase.duration;
      way += phase.length;
    }
  }
  return {.position = path.blocks.back().block.end, .velocity = 0};
}

void check_case(json const& plan, double within) {
  PathDynamics dynamics;
  std::vector<std::string> names;
  for (auto const& [name, lines] : plan.at("axes").items()) {
    names.push_back(name);
    dynamics.axes.push_back(axis_of(List(lines)));
  }
  dynamics.channel = channel_of(plan.contains("channel") ? plan.at("channel") : json::object());
  dynamics.cycle_time = {plan.at("cycle_time_us").get<std::uint32_t>() * 1000};
  double const T = dynamics.cycle_time.seconds();
  auto const mm_s = [T](double units) { return units / units_per_mm / T; };
  test::PlannedPath path;
  LookAhead planner(PathLimits(dynamics), false, path);
  planner.begin({}, {}, 1);
  Program program(names, dynamics, planner);
  for (auto const& line : plan.at("program")) program.line(line.get<std::string>());
  planner.stop();

  auto const& expected = plan.at("expected");
  auto const near = [&](double value) { return Approx(value).epsilon(within).margin(within); };
  double cycles = 0;
  double peak_acceleration = 0;
  double peak_jerk = 0;
  std::map<std::string, test::PlannedBlock const*> blocks;
  for (auto const& block : path.blocks) {
    blocks[block.block.label] = &block;
    cycles += block.cycles();
    for (auto const& phase : block.phases) {
      for (double const share : {0.0, 0.5, 1.0}) {
        double const time = share * phase.duration;
        peak_acceleration = std::max(peak_acceleration, std::abs(phase.acceleration_at(time)));
        peak_jerk = std::max(peak_jerk, std::abs(phase.jerk_at(time)));
      }
    }
  }
  CHECK(cycles * T == near(expected.at("time_s")));
  CHECK(peak_acceleration / units_per_mm / (T * T) == near(expected.at("peak_acceleration_mm_s2")));
  if (!expected.at("peak_jerk_mm_s3").is_null()) {
    CHECK(peak_jerk / units_per_mm / (T * T * T) == near(expected.at("peak_jerk_mm_s3")));
  }
  for (auto const& block : expected.at("blocks")) {
    INFO(block.at("label"));
    auto const& found = *blocks.at(block.at("label"));
    CHECK(found.cycles() * T == near(block.at("time_s")));
    CHECK(found.block.length / units_per_mm == near(block.at("length_mm")));
    CHECK(mm_s(found.motion.velocity_in) == near(block.at("velocity_in_mm_s")));
    CHECK(mm_s(found.motion.velocity_peak) == near(block.at("velocity_peak_mm_s")));
    CHECK(mm_s(found.motion.velocity_out) == near(block.at("velocity_out_mm_s")));
  }
  for (auto const& setpoint : expected.at("setpoints")) {
    auto const place = place_at(path, setpoint.at("cycle").get<double>());
    INFO("cycle " << setpoint.at("cycle"));
    CHECK(mm_s(place.velocity) == near(setpoint.at("velocity_mm_s")));
    for (std::size_t i = 0; i < names.size(); ++i) {
      CHECK(place.position[i] / units_per_mm == near(setpoint.at("position_mm").at(names[i])));
    }
  }
}

}  // namespace

TEST_CASE("plans of an independent program") {
  auto const path = std::filesystem::path(AXISC_SOURCE_DIR) / "../shared/reference/dynamics.json";
  std::ifstream file(path);
  if (!file) {
    WARN(path.string() << " is not here");
    return;
  }
  auto const document = json::parse(file);
  for (auto const& plan : document.at("cases")) {
    INFO(plan.at("name"));
    check_case(plan, document.at("tolerance").at("relative"));
  }
}

}  // namespace axisc::motion::reference_plans_test
