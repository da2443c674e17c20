// An FMU computes what axisrt computes, bit for bit: random images, hostile setpoints, commands and resets.
#include "image/fmu/fmu.hpp"
#include "runtime/c99/random_image.hpp"
#include "runtime/c99/random_numbers.hpp"
#include "runtime/test_runtime.hpp"
#include "tests/fmu/imported.hpp"

#include <bit>
#include <limits>
#include <span>

using namespace axisc;
using namespace axisc::test;

namespace {

ImageRecord named_image(std::uint32_t seed) {
  auto record = random_image(seed);
  record.strip = false;
  for (std::size_t i = 0; i < record.axes.size(); ++i) record.axes[i].name = "A" + std::to_string(i);
  for (std::size_t i = 0; i < record.groups.size(); ++i) record.groups[i].name = "C" + std::to_string(i);
  return record;
}

/// An importer's table and what axisrt gives for it: the inputs of the scenario, line by line the outputs.
class Reference {
 public:
  Reference(ImageRecord const& record, Bytes const& bytes, UnpackedFmu const& fmu)
      : record_(record),
        fmu_(fmu),
        runtime_(bytes, record.cycle_time_ns, AXISRT_LEVEL_PORTABLE),
        inputs_(5, std::vector<double>(record.axes.size())),
        outputs_(4, std::vector<double>(record.axes.size())),
        statuses_(3, std::vector<std::uint8_t>(record.axes.size())),
        wanted_(record.groups.size()),
        done_(record.groups.size()),
        command_status_(record.groups.size()),
        is_high_(record.axes.size()) {
    REQUIRE(runtime_.status == AXISRT_OK);
  }

  std::string scenario;
  std::vector<std::vector<double>> lines;
  std::uint64_t commands = 0;

  void start(Random& random) {
    for (std::size_t i = 0; i < record_.axes.size(); ++i) set_inputs(random, i);
    scenario += "init\n";
    for (std::size_t i = 0; i < record_.axes.size(); ++i) reset(i);
  }

  void cycle(Random& random) {
    for (std::size_t i = 0; i < record_.axes.size(); ++i) set_inputs(random, i);
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      if (random.chance(15)) want(i, random.below(settings(i)));
      if (wanted_[i] != done_[i]) {
        command(i);
      } else {
        command_status_[i] = AXISRT_OK;  // a command that waited was taken back
      }
    }
    for (std::size_t i = 0; i < record_.axes.size(); ++i) {
      bool const is_low = !is_high_[i];
      is_high_[i] = is_low && random.chance(60);
      if (!is_high_[i]) continue;  // no edge from one cycle to the next
      auto const name = fmu_.variable(axis(i) + ".reset");
      edges_ += name + " 0\n";
      scenario += name + " 1\n";
      reset(i);
    }
    scenario += "step 1\n" + edges_;
    edges_.clear();
    step();
    lines.push_back(outputs());
  }

 private:
  [[nodiscard]] std::string const& axis(std::size_t i) const { return record_.axes[i].name; }
  [[nodiscard]] bool has_guards(std::size_t group) const {
    for (auto const& bank : record_.groups[group].banks) {
      if ((bank.keywords & AXISRT_KEYWORD_GUARD) != 0) return true;
    }
    return false;
  }
  [[nodiscard]] std::uint32_t settings(std::size_t group) const {
    return static_cast<std::uint32_t>(record_.groups[group].banks.size()) + (has_guards(group) ? 3 : 2);
  }

  static double number(Random& random, double before) {
    if (random.chance(60)) return std::numeric_limits<double>::quiet_NaN();
    if (random.chance(60)) return random.sign() * random.magnitude(-1074, 1020);
    if (random.chance(4)) return before;
    if (random.chance(30)) return random.sign() * random.magnitude(-510, 40);
    return before + random.sign() * random.magnitude(-30, 8);
  }

  void set_inputs(Random& random, std::size_t i) {
    static constexpr std::array names = {".setpoint", ".interface", ".v_set", ".v_motor", ".v_direct"};
    for (std::size_t k = 0; k < names.size(); ++k) {
      auto const variable = fmu_.variable(axis(i) + names[k]);
      if (variable.empty()) continue;
      auto& value = inputs_[k][i];
      value = number(random, std::isfinite(value) && std::abs(value) < 1e15 ? value : 0);
      scenario += variable + " " + hexadecimal(value) + "\n";
    }
  }

  void reset(std::size_t i) {
    auto const number = static_cast<std::uint32_t>(i);
    axisrt_reset(runtime_.runtime, number, inputs_[0][i]);
    axisrt_reset_interface(runtime_.runtime, number, inputs_[1][i]);
    axisrt_reset_velocity(runtime_.runtime, number, inputs_[2][i], inputs_[3][i], inputs_[4][i]);
  }

  void want(std::size_t group, std::uint32_t setting) {
    wanted_[group] = setting;
    scenario += fmu_.variable(record_.groups[group].name + ".filter") + " " + std::to_string(setting) + "\n";
  }

  void command(std::size_t group) {
    std::uint32_t const wanted = wanted_[group], first = has_guards(group) ? 3 : 2;
    axisrt_filter_command words{.size = sizeof words,
                                .action = AXISRT_ACTION_ON,
                                .keywords = 0,
                                .order = 0,
                                .share = 0,
                                .fcut = 0,
                                .quality = 0};
    if (wanted >= first) {
      auto const& bank = record_.groups[group].banks[wanted - first];
      words.keywords = bank.keywords;
      words.order = bank.order;
      words.share = bank.share;
      words.fcut = bank.frequency;
      words.quality = bank.quality;
    } else {
      words.action = wanted == 0 ? AXISRT_ACTION_PROGRAM_END : AXISRT_ACTION_OFF;
      if (wanted == 2) words.keywords = AXISRT_KEYWORD_GUARD;
    }
    command_status_[group] = axisrt_command(runtime_.runtime, static_cast<std::uint32_t>(group), &words);
    commands += 1;
    if (command_status_[group] == AXISRT_OK) done_[group] = wanted;
  }

  void step() {
    axisrt_step(runtime_.runtime, inputs_[0].data(), outputs_[0].data(), statuses_[0].data());
    axisrt_step_interface(runtime_.runtime, inputs_[1].data(), outputs_[1].data(), statuses_[1].data());
    axisrt_velocities const velocities{.size = sizeof velocities,
                                       .reserved = 0,
                                       .v_set = inputs_[2].data(),
                                       .v_motor = inputs_[3].data(),
                                       .v_direct = inputs_[4].data()};
    axisrt_step_velocity(runtime_.runtime, &velocities, outputs_[2].data(), outputs_[3].data(),
                         statuses_[2].data());
  }

  [[nodiscard]] double output(std::size_t i, std::string const& kind) {
    if (kind == "filtered") return outputs_[0][i];
    if (kind == "interface_filtered") return outputs_[1][i];
    if (kind == "v_add") return outputs_[2][i];
    if (kind == "increments") return outputs_[3][i];
    if (kind == "settled") return runtime_.state(static_cast<std::uint32_t>(i)).settled;
    bool const has_interface = !record_.axes[i].interface_filters.empty();
    return std::max({statuses_[0][i], has_interface ? statuses_[1][i] : std::uint8_t{0}, statuses_[2][i]});
  }

  [[nodiscard]] std::vector<double> outputs() {
    std::vector<double> values;
    for (auto const& name : fmu_.outputs()) {
      auto const dot = name.find('.');
      auto const number = static_cast<std::size_t>(std::stoul(name.substr(1, dot - 1)));
      values.push_back(name[0] == 'C' ? command_status_[number] : output(number, name.substr(dot + 1)));
    }
    return values;
  }

  ImageRecord const& record_;
  UnpackedFmu const& fmu_;
  TestRuntime runtime_;
  std::vector<std::vector<double>> inputs_, outputs_;
  std::vector<std::vector<std::uint8_t>> statuses_;
  std::vector<std::uint32_t> wanted_, done_, command_status_;
  std::vector<bool> is_high_;
  std::string edges_;
};

struct Counts {
  std::uint64_t values = 0, commands = 0, images_with_commands = 0;
};

void compare(std::vector<std::string> const& printed, std::vector<std::vector<double>> const& expected,
             Counts& counts) {
  REQUIRE(printed.size() == expected.size() + 1);  // after the initialization, too
  for (std::size_t cycle = 0; cycle < expected.size(); ++cycle) {
    auto const values = numbers_of(printed[cycle + 1]);
    REQUIRE(values.size() == expected[cycle].size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      counts.values += 1;
      if (std::bit_cast<std::uint64_t>(values[i]) == std::bit_cast<std::uint64_t>(expected[cycle][i]))
        continue;
      FAIL("cycle " << cycle << ", output " << i << ": " << values[i] << " instead of "
                    << expected[cycle][i]);
    }
  }
}

void run_image(std::uint32_t seed, ImageRecord const& record, Counts& counts) {
  INFO("seed " << seed);
  auto const version = seed % 2 == 0 ? image::FmiVersion::three : image::FmiVersion::two;
  auto const bytes = write_image(record);
  AlignedMemory const aligned{bytes};
  auto const span = std::as_bytes(std::span(aligned.data(), aligned.size()));
  auto const contents = image::read_image(span);
  REQUIRE(std::holds_alternative<image::ImageContents>(contents));
  auto const made = image::fmu_of(span, std::get<image::ImageContents>(contents),
                                  {.version = version, .name = "random", .complete = seed % 3 == 0});
  REQUIRE(std::holds_alternative<image::Fmu>(made));
  TemporaryFolder const folder;
  for (auto const& file : std::get<image::Fmu>(made).files) folder.write(file.name, file.content);
  UnpackedFmu const fmu(folder.path(), version);
  fmu.compile();
  Reference reference(record, bytes, fmu);
  Random random(seed);
  reference.start(random);
  for (int cycle = 0; cycle < 200; ++cycle) reference.cycle(random);
  compare(fmu.run(reference.scenario, fmu.outputs()), reference.lines, counts);
  counts.commands += reference.commands;
  if (reference.commands > 0) counts.images_with_commands += 1;
}

}  // namespace

TEST_CASE("FMUs of random images compute what axisrt computes, bit for bit") {
  if (!is_installed("cc")) {
    WARN("cc is not installed");
    return;
  }
  Counts counts;
  for (std::uint32_t seed = 0; seed < 6; ++seed) run_image(seed, named_image(seed), counts);
  CHECK(counts.values > 10'000);
  CHECK(counts.commands > 30);
}

TEST_CASE("FMUs of two hundred random images with commands compute what axisrt computes", "[.long]") {
  Counts counts;
  for (std::uint32_t seed = 6; counts.images_with_commands < 200; ++seed) {
    REQUIRE(seed < 1000);
    auto const record = named_image(seed);
    if (!record.groups.empty()) run_image(seed, record, counts);  // a third of them has no channel
  }
  WARN(counts.values << " values were equal, with " << counts.commands << " commands");
}
