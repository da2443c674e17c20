// Machines from their texts to the bytes of their images, in one thread and without any file:
// bench/README.md.
//
//   bench_machines [--machines N] [--rounds N] [--lines N]
#include "codegen/image_writer.hpp"
#include "lists/generator.hpp"
#include "lists/memory_files.hpp"
#include "lists/random.hpp"
#include "lists/rounds.hpp"
#include "validator/check.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <vector>

namespace axisc::bench {
namespace {

constexpr std::array<char const*, 4> axes = {"X", "Y", "Z", "W"};

struct MachineTexts {
  std::string machine;
  std::string default_list;
  std::vector<std::string> lists;
};

/// A kernel that no other machine has, or one of sixteen.
std::string kernel_list(std::size_t number, bool shared) {
  if (shared) number %= 16;
  Random random(number + 1);
  std::string text =
      "filter_fir.enable 1\nfilter_fir.order " + std::to_string(100 + random.below(101)) + "\n";
  if (number % 2 == 0) {
    text += "filter_fir.type 2\nfilter_fir.quality 0." + std::to_string(100000 + number) + "\n";
  } else {
    text += "filter_fir.type 3\nfilter_fir.fcut " + std::to_string(20 + number % 40) + "." +
            std::to_string(number) + "\n";
  }
  return text + "Ende\n";
}

/// The first lines of a list of the fleet, without its filters.
std::string axis_list(std::size_t number, std::size_t axis, std::size_t lines) {
  std::string text = "kopf.achs_nr " + std::to_string(axis + 1) + "\nkopf.log_achs_name " + axes[axis] + "\n";
  GeneratedList const list = generate_list(number);
  for (Entry const& entry : list.entries) {
    if (lines-- == 0) break;
    if (entry.name.substr(0, 7) != "filter[") text += entry.name + " " + entry.value + "\n";
  }
  return text + "Ende\n";
}

MachineTexts make_machine(std::size_t number, std::size_t lines, bool shared) {
  MachineTexts texts;
  texts.default_list = kernel_list(number, shared);
  texts.machine = R"({"machine": "M)" + std::to_string(number) +
                  R"(", "cycle_time_us": 1000, "default_list": "default.lis", "axes": [)";
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    if (axis > 0) texts.machine += ", ";
    texts.machine += R"({"name": ")" + std::string(axes[axis]) + R"(", "list": ")" + axes[axis] + R"(.lis"})";
    texts.lists.push_back(axis_list(number * axes.size() + axis, axis, lines));
  }
  texts.machine += "]}";
  return texts;
}

std::size_t bytes_written = 0;
std::size_t refused = 0;

void compile(MachineTexts const& texts, codegen::KnownDesigns& designs) {
  static std::string const machine_path("m/machine.json"), default_path("m/default.lis");
  MemoryFiles files;
  files.put(machine_path, texts.machine);
  files.put(default_path, texts.default_list);
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    std::string path("m/");
    path.append(axes[axis]).append(".lis");
    files.put(path, texts.lists[axis]);
  }
  SourceSet sources;
  validator::CheckResult const result = validator::check(files, machine_path, {}, sources);
  if (!result.machine) {
    if (++refused == 1) {
      for (Finding const& finding : result.findings) {
        std::printf("%s %s\n", code_text(finding.code).c_str(), finding.parameter.c_str());
      }
    }
    return;
  }
  bytes_written += codegen::write_image(*result.machine, {}, designs).size();
}

}  // namespace
}  // namespace axisc::bench

int main(int argc, char** argv) {
  using namespace axisc::bench;
  std::size_t count = 1000, rounds = 3, lines = 100;
  for (int i = 1; i + 1 < argc; i += 2) {
    std::string_view const option = argv[i];
    std::size_t const value = std::strtoul(argv[i + 1], nullptr, 10);
    if (option == "--machines") count = value;
    if (option == "--rounds") rounds = value;
    if (option == "--lines") lines = value;
  }
  auto const make_fleet = [=](bool shared) {
    std::vector<MachineTexts> machines;
    for (std::size_t number = 0; number < count; ++number) {
      machines.push_back(make_machine(number, lines, shared));
    }
    return machines;
  };
  std::vector<MachineTexts> const own = make_fleet(false), shared = make_fleet(true);
  auto const compile_all = [](std::vector<MachineTexts> const& machines) {
    axisc::codegen::KnownDesigns designs;
    for (MachineTexts const& texts : machines) compile(texts, designs);
  };
  std::vector<Contender> const contenders = {
      {"each with a filter of its own", 0, count, [&] { compile_all(own); }},
      {"sixteen filters among all", 0, count, [&] { compile_all(shared); }}};
  measure(contenders, 0, rounds, "machines/s");
  std::printf("%zu bytes per image, %zu refused\n", bytes_written / (rounds + 1) / (2 * count), refused);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%ld KiB resident at most\n", usage.ru_maxrss);
  return 0;
}
