// --shard, and merge, which undoes it.
#include "cli/fleet/shard.hpp"

#include "cli/program.hpp"
#include "cli/temporary_folder.hpp"
#include "support/golden.hpp"
#include "support/sarif_schema.hpp"

#include <algorithm>
#include <set>

using namespace axisc::test;
using axisc::cli::is_in_shard;
using Catch::Matchers::Contains;

namespace {

std::string mistakes() {
  return read_source_file("tests/cli/data/mistakes.lis");
}
std::string warning() {
  return read_source_file("tests/cli/data/warning.lis");
}

/// Lists of their own, and machines of several shards that share one.
class Plant {
 public:
  Plant() {
    folder.write(".git/HEAD", "");
    for (int i = 0; i < 12; ++i) {
      auto const number = std::to_string(i);
      folder.write("a/axis" + number + ".lis", i % 3 == 0 ? mistakes() : warning());
      folder.write(
          "m" + number + "/machine.json",
          R"({"axes": [{"name": "X", "list": "../shared.lis"}, {"name": "Y", "list": "../b c.lis"}]})");
    }
    folder.write("shared.lis", mistakes());
    folder.write("b c.lis", warning());
  }

  [[nodiscard]] Outcome run(std::vector<std::string> const& arguments) const {
    return run_axisc(arguments, in_folder(folder.path()));
  }
  /// The results of all shards, in files "1" to "count"; the exit status of the worst.
  int run_shards(std::vector<std::string> arguments, unsigned count) const {
    int worst = 0;
    arguments.insert(arguments.end(), {"--shard", ""});
    for (unsigned i = 1; i <= count; ++i) {
      arguments.back() = std::to_string(i) + "/" + std::to_string(count);
      auto const outcome = run(arguments);
      worst = std::max(worst, outcome.status);
      folder.write(std::to_string(i) + ".result", outcome.out);
    }
    return worst;
  }
  /// The last shard's result first: order does not matter.
  [[nodiscard]] Outcome merge(unsigned count, std::vector<std::string> const& more = {}) const {
    std::vector<std::string> arguments{"merge"};
    for (unsigned i = count; i >= 1; --i) arguments.push_back(std::to_string(i) + ".result");
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  TemporaryFolder folder;
};

void check_same(Outcome const& left, Outcome const& right) {
  CHECK(left.status == right.status);
  CHECK(left.out == right.out);
  CHECK(left.err == right.err);
}

}  // namespace

TEST_CASE("every path is in one shard, whatever the others are") {
  std::array<std::size_t, 5> sizes{};
  for (int i = 0; i < 1000; ++i) {
    auto const path = "plant/axis" + std::to_string(i) + ".lis";
    std::size_t holders = 0;
    for (std::uint32_t shard = 1; shard <= 5; ++shard) {
      if (!is_in_shard({.index = shard, .count = 5}, path, "/repository")) continue;
      ++holders;
      ++sizes[shard - 1];
      CHECK(is_in_shard({.index = shard, .count = 5}, "./plant/x/../axis" + std::to_string(i) + ".lis",
                        "/repository"));
      CHECK(is_in_shard({.index = shard, .count = 5}, "/repository/" + path, "/repository"));
    }
    CHECK(holders == 1);
  }
  for (auto const size : sizes) CHECK((size > 140 && size < 260));
  // The assignment is a promise: caches and reports of earlier runs rely on it.
  CHECK(is_in_shard({.index = 4, .count = 7}, "axes/x.lis", "/repository") ==
        is_in_shard({.index = 4, .count = 7}, "axes/x.lis", "/elsewhere"));
}

TEST_CASE("merged shards are the whole run, byte for byte") {
  Plant const plant;
  for (std::string const format : {"json", "sarif"}) {
    for (unsigned const count : {1U, 3U, 7U, 40U}) {
      std::vector<std::string> arguments{"lint", ".", "missing.lis", "empty", "--format", format};
      std::filesystem::create_directories(plant.folder / "empty");
      if (format == "json") arguments.emplace_back("--statistics");
      auto const whole = plant.run(arguments);
      CHECK(whole.status == 2);
      CHECK(plant.run_shards(arguments, count) == 2);
      check_same(plant.merge(count), whole);
      CHECK(plant.merge(count, {"-o", "all"}).out.empty());
      CHECK(plant.folder.read("all") == whole.out);
      if (format == "sarif")
        CHECK(sarif_complaints(plant.folder.read("1.result")) == std::vector<std::string>{});
    }
  }
}

TEST_CASE("the exit status of merge is that of the whole run") {
  Plant const plant;
  for (std::vector<std::string> const& arguments : std::vector<std::vector<std::string>>{
           {"lint", "b c.lis", "a/axis1.lis", "--format", "json"},
           {"lint", "b c.lis", "a/axis1.lis", "--format", "json", "--werror"},
           {"lint", ".", "--format", "json", "--lang", "de"}}) {
    auto const whole = plant.run(arguments);
    CHECK(plant.run_shards(arguments, 2) == whole.status);
    check_same(plant.merge(2), whole);
  }
}

TEST_CASE("a baseline belongs to merge") {
  Plant const plant;
  REQUIRE(plant.run({"lint", ".", "--write-baseline", "known.json", "--cycle-time", "1ms"}).status == 0);
  plant.folder.write("a/new.lis", mistakes());
  std::filesystem::remove(plant.folder / "a/axis0.lis");
  for (std::string const format : {"json", "sarif"}) {
    std::vector<std::string> arguments{"lint",     ".",    "--cycle-time", "1ms",
                                       "--format", format, "--disable",    "AX3015"};
    auto with_baseline = arguments;
    with_baseline.insert(with_baseline.end(), {"--baseline", "known.json"});
    auto const whole = plant.run(with_baseline);
    CHECK(plant.run_shards(arguments, 3) == 1);
    check_same(plant.merge(3, {"--baseline", "known.json"}), whole);
  }
  CHECK_THAT(plant.run({"lint", ".", "--shard", "1/2", "--baseline", "known.json"}).err,
             Contains("axisc merge"));
}

TEST_CASE("bad shards are usage errors") {
  Plant const plant;
  for (auto const* const value :
       {"0/2", "3/2", "1", "1/", "/2", "a/2", "1/2/3", "-1/2", "1/0", "1/99999999", ""}) {
    auto const outcome = plant.run({"lint", ".", "--shard", value});
    INFO(value);
    CHECK(outcome.status == 2);
    CHECK(lines_of(outcome.err) == 1);
    CHECK_THAT(outcome.err, Contains("--shard needs I/N"));
  }
  CHECK_THAT(plant.run({"lint", ".", "--shard", "1/2", "--fix"}).err, Contains("cannot be used with --fix"));
  CHECK_THAT(plant.run({"compile", "b c.lis", "-o", "x.axim", "--shard", "1/2"}).err,
             Contains("needs --output-folder"));
}

TEST_CASE("what is no set of shards is refused") {
  Plant const plant;
  plant.run_shards({"lint", ".", "--format", "json"}, 3);
  auto const check = [&](std::vector<std::string> arguments, std::string const& expected) {
    arguments.insert(arguments.begin(), "merge");
    auto const outcome = plant.run(arguments);
    INFO(expected);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(lines_of(outcome.err) == 1);
    CHECK_THAT(outcome.err, Contains(expected));
  };
  check({}, "FILE is missing");
  check({"1.result", "3.result"}, "shard 2/3 is missing");
  check({"1.result", "2.result", "2.result", "3.result"}, "are both shard 2/3");
  check({"1.result", "missing.result"}, "AX9001]: cannot read missing.result");
  auto const second = plant.folder.read("2.result");
  plant.folder.write("cut.result", second.substr(0, second.size() / 2));
  check({"1.result", "cut.result", "3.result"}, "cut.result is damaged");
  plant.folder.write("whole.result", plant.run({"lint", ".", "--format", "json"}).out);
  plant.folder.write("old", "old");
  check({"1.result", "2.result", "-o", "old"}, "shard 3/3 is missing");
  CHECK(plant.folder.read("old") == "old");
  check({"whole.result"}, "was not written by `axisc lint --shard");
  check({"shared.lis"}, "is damaged");
  for (std::vector<std::string> const& other : std::vector<std::vector<std::string>>{
           {"--cycle-time", "2ms"}, {"--lang", "de"}, {"--disable", "AX3005"}, {"--werror"}}) {
    std::vector<std::string> arguments{"lint", ".", "--format", "json", "--shard", "2/3"};
    arguments.insert(arguments.end(), other.begin(), other.end());
    plant.folder.write("other.result", plant.run(arguments).out);
    check({"1.result", "other.result", "3.result"}, "other.result and 1.result are from different runs");
  }
}
