// The same findings and images for every number of threads.
#include "cli/program.hpp"
#include "support/file_contents.hpp"
#include "support/random_lists.hpp"
#include "support/temporary_folder.hpp"

#include <map>
#include <random>

using namespace axisc::test;
namespace fs = std::filesystem;

namespace {

struct Plant {
  std::vector<std::uint32_t> lists;
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      machines;  ///< each of two lists, which several may share
};

void write(TemporaryFolder const& folder, Plant const& plant) {
  for (std::size_t i = 0; i < plant.lists.size(); ++i) {
    folder.write("in/p" + std::to_string(i % 3) + "/axis" + std::to_string(i) + ".lis",
                 axisc::tests::random_list(plant.lists[i]));
  }
  for (std::size_t i = 0; i < plant.machines.size(); ++i) {
    auto const [x, y] = plant.machines[i];
    for (auto const list : {x % 4, y % 4}) {
      folder.write("in/shared/" + std::to_string(list) + ".lis", axisc::tests::random_list(list + 5000));
    }
    folder.write("in/m" + std::to_string(i) + ".json",
                 R"({"axes": [{"name": "X", "list": "shared/)" + std::to_string(x % 4) +
                     R"(.lis"}, {"name": "Y", "list": "shared/)" + std::to_string(y % 4) + R"(.lis"}]})");
  }
}

std::map<std::string, std::string> files_below(std::string const& folder) {
  std::map<std::string, std::string> files;
  if (!fs::exists(folder)) return files;
  for (auto const& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files.emplace(fs::relative(entry.path(), folder).string(), file_contents(entry.path()));
  }
  return files;
}

constexpr std::uint32_t rounds = 8;

/// Numbers of one round; the same in every run.
class Chance {
 public:
  explicit Chance(std::uint32_t seed) : engine_(seed) {}
  [[nodiscard]] std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(engine_()) % end; }
  [[nodiscard]] Plant plant() {
    Plant plant;
    for (auto left = below(25); left > 0; --left) plant.lists.push_back(below(4000));
    for (auto left = below(8); left > 0; --left) plant.machines.emplace_back(below(4000), below(4000));
    return plant;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace

TEST_CASE("findings are the same for every number of threads") {
  for (std::uint32_t seed = 0; seed < rounds; ++seed) {
    INFO("seed " << seed);
    Chance chance(seed);
    TemporaryFolder const folder;
    write(folder, chance.plant());
    folder.write("in/always.lis", "kopf.achs_nr 1\n");
    auto const run = [&](std::vector<std::string> const& arguments) {
      return run_axisc(arguments, in_folder(folder.path()));
    };
    REQUIRE(run({"lint", "in/always.lis", "--write-baseline", "known.json"}).status == 0);
    auto const threads = std::to_string(2 + chance.below(10));
    for (std::string const format : {"text", "json", "jsonl", "sarif", "github", "gitlab", "junit"}) {
      INFO(format);
      std::vector<std::string> const lint{"lint", "in",         "--pedantic", "--format",
                                          format, "--baseline", "known.json"};
      auto const with = [&](std::string const& count) {
        auto arguments = lint;
        arguments.insert(arguments.end(), {"-j", count});
        return run(arguments);
      };
      auto const one = with("1");
      auto const many = with(threads);
      CHECK(one.status == many.status);
      CHECK(one.out == many.out);
      CHECK(one.err == many.err);
    }
  }
}

TEST_CASE("images are the same for every number of threads") {
  for (std::uint32_t seed = 0; seed < rounds; ++seed) {
    INFO("seed " << seed);
    Chance chance(seed);
    TemporaryFolder const folder;
    write(folder, chance.plant());
    folder.write("in/always.lis", "kopf.achs_nr 1\n");
    auto const compile = [&](std::string const& output, std::vector<std::string> const& more) {
      std::vector<std::string> arguments{"compile", "in", "--output-folder", output, "--cycle-time", "1ms"};
      arguments.insert(arguments.end(), more.begin(), more.end());
      return run_axisc(arguments, in_folder(folder.path()));
    };
    auto const one = compile("one", {"-j", "1"});
    auto const many = compile("many", {"-j", "9"});
    CHECK(one.status == many.status);
    CHECK(one.err == many.err);
    CHECK(files_below(folder / "many") == files_below(folder / "one"));
  }
}
