// The same findings and images for every number of threads and shards, with and without a cache.
#include "cli/program.hpp"
#include "cli/temporary_folder.hpp"
#include "support/random_lists.hpp"

#include <algorithm>
#include <map>
#include <random>

using namespace axisc::test;
namespace fs = std::filesystem;

namespace {

struct Fleet {
  std::vector<std::uint32_t> lists;
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      machines;  ///< each of two lists, which several may share
};

void write(TemporaryFolder const& folder, Fleet const& fleet) {
  for (std::size_t i = 0; i < fleet.lists.size(); ++i) {
    folder.write("in/p" + std::to_string(i % 3) + "/axis" + std::to_string(i) + ".lis",
                 axisc::tests::random_list(fleet.lists[i]));
  }
  for (std::size_t i = 0; i < fleet.machines.size(); ++i) {
    auto const [x, y] = fleet.machines[i];
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
    std::ifstream file(entry.path(), std::ios::binary);
    files.emplace(fs::relative(entry.path(), folder).string(),
                  std::string(std::istreambuf_iterator<char>(file), {}));
  }
  return files;
}

constexpr std::uint32_t rounds = 8;

/// Numbers of one round; the same in every run.
class Chance {
 public:
  explicit Chance(std::uint32_t seed) : engine_(seed) {}
  [[nodiscard]] std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(engine_()) % end; }
  [[nodiscard]] Fleet fleet() {
    Fleet fleet;
    for (auto left = below(25); left > 0; --left) fleet.lists.push_back(below(4000));
    for (auto left = below(8); left > 0; --left) fleet.machines.emplace_back(below(4000), below(4000));
    return fleet;
  }
  void shuffle(std::vector<std::string>& words) { std::shuffle(words.begin() + 1, words.end(), engine_); }

 private:
  std::mt19937 engine_;
};

}  // namespace

TEST_CASE("findings are the same for every number of threads and shards") {
  for (std::uint32_t seed = 0; seed < rounds; ++seed) {
    INFO("seed " << seed);
    Chance chance(seed);
    TemporaryFolder const folder;
    write(folder, chance.fleet());
    folder.write("in/always.lis", "kopf.achs_nr 1\n");
    auto const run = [&](std::vector<std::string> const& arguments) {
      return run_axisc(arguments, in_folder(folder.path()));
    };
    std::string const format = chance.below(2) == 0 ? "json" : "sarif";
    auto const threads = std::to_string(2 + chance.below(10));
    auto const shards = 1 + chance.below(5);
    std::vector<std::string> const lint{"lint", "in", "--format", format};
    auto const with = [&](std::vector<std::string> const& more) {
      auto arguments = lint;
      arguments.insert(arguments.end(), more.begin(), more.end());
      return run(arguments);
    };
    auto const one = with({"-j", "1"});
    auto const many = with({"-j", threads});
    CHECK(one.status == many.status);
    CHECK(one.out == many.out);
    CHECK(one.err == many.err);

    std::vector<std::string> merge{"merge"};
    for (std::uint32_t i = 1; i <= shards; ++i) {
      auto const shard = std::to_string(i) + "/" + std::to_string(shards);
      // The second shard has a cache that the others filled in part, or not.
      folder.write("s" + std::to_string(i), with({"--shard", shard, "-j", threads, "--cache", "cache"}).out);
      merge.push_back("s" + std::to_string(i));
    }
    chance.shuffle(merge);
    auto const merged = run(merge);
    CHECK(merged.status == one.status);
    CHECK(merged.out == one.out);
    CHECK(with({"--cache", "cache"}).out == one.out);
  }
}

TEST_CASE("images are the same for every number of threads and shards") {
  for (std::uint32_t seed = 0; seed < rounds; ++seed) {
    INFO("seed " << seed);
    Chance chance(seed);
    TemporaryFolder const folder;
    write(folder, chance.fleet());
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
    auto const images = files_below(folder / "one");
    CHECK(files_below(folder / "many") == images);
    auto const shards = std::to_string(1 + chance.below(4));
    for (int i = 1; i <= std::stoi(shards); ++i) {
      static_cast<void>(compile("parts", {"--shard", std::to_string(i) + "/" + shards, "--cache", "cache"}));
    }
    CHECK(files_below(folder / "parts") == images);
  }
}
