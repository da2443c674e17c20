// --cache and --print-key: what is kept is right, or it is not used.
#include "cli/fleet/cache_store.hpp"
#include "cli/fleet/file_digests.hpp"
#include "cli/program.hpp"
#include "cli/temporary_folder.hpp"
#include "support/golden.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utime.h>

using namespace axisc::test;
using namespace axisc::cli;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

std::string mistakes() {
  return read_source_file("tests/cli/data/mistakes.lis");
}
std::string warning() {
  return read_source_file("tests/cli/data/warning.lis");
}
std::string const machine =
    R"({"cycle_time_us": 1000, "default_list": "default.lis", "axes": [{"name": "X", "list": "x.lis"}], "programs": ["part.nc"]})";

/// Lists and a machine with everything that a machine can name.
class Plant {
 public:
  Plant() {
    folder.write("a.lis", mistakes());
    folder.write("b.lis", warning());
    folder.write("m/machine.json", machine);
    folder.write("m/x.lis", mistakes());
    folder.write("m/default.lis", "kenngr.achs_typ 1\nEnde\n");
    folder.write("m/part.nc", "N10 #FILTER ON [ORDER=7]\nM30\n");
  }
  [[nodiscard]] Outcome lint(std::vector<std::string> const& more = {}, bool cached = true) const {
    std::vector<std::string> arguments{"lint", "."};
    arguments.insert(arguments.end(), more.begin(), more.end());
    if (cached) arguments.insert(arguments.end(), {"--cache", "../" + name() + ".cache"});
    return run_axisc(arguments, in_folder(folder.path()));
  }
  [[nodiscard]] std::string key(std::vector<std::string> const& more = {}) const {
    auto arguments = more;
    arguments.emplace_back("--print-key");
    auto const outcome = lint(arguments, false);
    CHECK(outcome.status == 0);
    CHECK(outcome.out.size() == 33);
    return outcome.out;
  }
  [[nodiscard]] std::string name() const { return fs::path(folder.path()).filename().string(); }
  [[nodiscard]] fs::path cache() const { return folder.path() + ".cache"; }
  ~Plant() {
    std::error_code error;
    fs::remove_all(cache(), error);
  }
  Plant(Plant const&) = delete;
  Plant& operator=(Plant const&) = delete;

  TemporaryFolder folder;
};

void check_same(Outcome const& left, Outcome const& right) {
  CHECK(left.status == right.status);
  CHECK(left.out == right.out);
  CHECK(left.err == right.err);
}

/// The packs of a cache, which are what its entries stand in.
std::vector<fs::path> packs_of(fs::path const& cache) {
  std::vector<fs::path> packs;
  for (auto const& entry : fs::directory_iterator(cache)) {
    if (entry.path().extension() == pack_extension) packs.push_back(entry.path());
  }
  return packs;
}

std::size_t entries_of(fs::path const& cache) {
  std::size_t entries = 0;
  for (auto const& pack : open_packs(cache.string())) entries += pack.rows().size();
  return entries;
}

void change_byte(fs::path const& path, std::size_t at) {
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.seekg(static_cast<std::streamoff>(at));
  auto const byte = static_cast<char>(file.get() ^ 0x55);
  file.seekp(static_cast<std::streamoff>(at));
  file.put(byte);
}

}  // namespace

TEST_CASE("with a cache every format is the same, the first time and again") {
  Plant const plant;
  for (std::string const format : {"text", "json", "sarif", "github", "gitlab"}) {
    auto const plain = plant.lint({"--format", format}, false);
    CHECK(plain.status == 1);
    check_same(plant.lint({"--format", format}), plain);
    auto const entries = entries_of(plant.cache());
    check_same(plant.lint({"--format", format}), plain);
    check_same(plant.lint({"--format", format, "-j", "5"}), plain);
    // Nothing was checked anew.
    CHECK(entries_of(plant.cache()) == entries);
  }
}

TEST_CASE("whatever a result depends on makes a new one") {
  Plant const plant;
  std::vector<std::pair<std::string, std::string>> const changes{
      {"a.lis", warning()},
      {"b.lis", warning() + "kopf.hugo 1\n"},
      {"m/x.lis", "Ende\n"},
      {"m/default.lis", "filter[0].order 99\nEnde\n"},
      {"m/part.nc", "N10 #FILTER ON [ORDR=7]\n"},
      {"m/machine.json",
       R"({"cycle_time_us": 2000, "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}]})"},
      {"m/y.lis", mistakes()},
      {"axisc.json", R"({"disable": ["AX3005", "AX2001"]})"},
      {"axisc.json", R"({"severity": {"AX2001": "note"}, "cycle_time_us": 500})"},
      {"axisc.json", R"({"paths": [{"pattern": "m/**", "disable": ["AX2001"]}]})"},
      {"schema.json", R"({"version": 1, "parameters": [{"name": "kopf.hugo", "type": "UNS32"}]})"},
      {"axisc.json", R"({"schema": ["schema.json"]})"},
      {"schema.json",
       R"({"version": 1, "parameters": [{"name": "kopf.hugo", "type": "UNS32", "minimum": 5}]})"},
  };
  check_same(plant.lint(), plant.lint({}, false));
  auto key = plant.key();
  for (auto const& [file, content] : changes) {
    INFO(file);
    plant.folder.write(file, content);
    check_same(plant.lint(), plant.lint({}, false));
    check_same(plant.lint(), plant.lint({}, false));
    bool const matters = file != "schema.json" || fs::file_size(plant.folder / "axisc.json") == 27;
    CHECK((plant.key() != key) == matters);
    key = plant.key();
  }
  fs::remove(plant.folder / "m/part.nc");
  fs::remove(plant.folder / "axisc.json");
  check_same(plant.lint(), plant.lint({}, false));
  for (std::vector<std::string> const& options :
       std::vector<std::vector<std::string>>{{"--cycle-time", "2ms"},
                                             {"--pedantic"},
                                             {"--disable", "AX2001"},
                                             {"--lang", "de"},
                                             {"--quiet"},
                                             {"--build", "V3.1.3075.02"},
                                             {"--axis-type", "S"},
                                             {"--color", "always"},
                                             {"--schema", "schema.json"}}) {
    INFO(options.front());
    check_same(plant.lint(options), plant.lint(options, false));
    CHECK(plant.key(options) != plant.key());
  }
}

TEST_CASE("the key depends on what matters alone") {
  Plant const plant;
  auto const key = plant.key({"--cycle-time", "1ms"});
  CHECK(plant.key({"--cycle-time", "1000us", "-j", "7"}) == key);
  CHECK(plant.key({"--cycle-time", "1ms", "--cache", plant.cache().string()}) == key);
  CHECK(plant.key({"--cycle-time", "1ms", "--werror"}) != key);
  utime((plant.folder / "a.lis").c_str(), nullptr);
  CHECK(plant.key({"--cycle-time", "1ms"}) == key);
  // A copy elsewhere has the same names and the same content.
  TemporaryFolder const elsewhere;
  fs::copy(plant.folder.path(), elsewhere / "copy", fs::copy_options::recursive);
  CHECK(run_axisc({"lint", ".", "--print-key", "--cycle-time", "1ms"}, in_folder(elsewhere / "copy")).out ==
        key);
  auto const compile = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"compile", "b.lis", "--print-key", "--cycle-time", "1ms"});
    return run_axisc(arguments, in_folder(plant.folder.path())).out;
  };
  CHECK(compile({}).size() == 33);
  CHECK(compile({"-o", "x.axim"}) == compile({"--depfile", "d"}));
  CHECK(compile({"--strip"}) != compile({}));
  CHECK(compile({"--image-version", "7"}) != compile({}));
}

TEST_CASE("damaged caches give no wrong results") {
  Plant const plant;
  auto const plain = plant.lint({}, false);
  REQUIRE(plant.lint().out == plain.out);
  auto const damage = [&](std::function<void(fs::path const&)> const& how) {
    fs::remove_all(plant.cache());
    REQUIRE(plant.lint().out == plain.out);
    for (auto const& pack : packs_of(plant.cache())) how(pack);
    check_same(plant.lint(), plain);
    check_same(plant.lint(), plain);
  };
  auto const size = fs::file_size(packs_of(plant.cache()).front());
  for (std::size_t at = 0; at < size; at += 1 + size / 60) {
    damage([at](fs::path const& pack) { change_byte(pack, at); });
  }
  damage([](fs::path const& pack) { fs::resize_file(pack, fs::file_size(pack) / 2); });
  damage([](fs::path const& pack) { fs::resize_file(pack, 0); });
  damage([](fs::path const& pack) { std::ofstream(pack) << std::string(5000, '\xFF'); });
  damage([](fs::path const& pack) { fs::remove(pack); });
  auto const table = plant.cache() / "files";
  // Only files that stayed as they are for two seconds get into the table.
  std::this_thread::sleep_for(std::chrono::milliseconds(2100));
  check_same(plant.lint(), plain);
  REQUIRE(fs::exists(table));
  for (std::size_t at = 0; at < fs::file_size(table); at += 7) {
    change_byte(table, at);
    check_same(plant.lint(), plain);
  }
}

TEST_CASE("a cache never follows a link, waits for a pipe or believes a size", "[posix]") {
  Plant const plant;
  auto const plain = plant.lint({}, false);
  REQUIRE(plant.lint().out == plain.out);
  plant.folder.write("victim", "precious");
  std::this_thread::sleep_for(std::chrono::milliseconds(2100));
  for (std::string const name : {"files", "lock", "new.axpack"}) {
    fs::remove(plant.cache() / name);
    fs::create_symlink(plant.folder / "victim", plant.cache() / name);
    check_same(plant.lint(), plain);
    check_same(plant.lint({"--cache-size", "1"}), plain);
    CHECK(plant.folder.read("victim") == "precious");
    fs::remove(plant.cache() / name);
    REQUIRE(::mkfifo((plant.cache() / name).c_str(), 0600) == 0);
    check_same(plant.lint(), plain);
    check_same(plant.lint({"--cache-size", "1"}), plain);
    fs::remove(plant.cache() / name);
  }
  // A table of 2^28 entries, said to be in a file that takes no room on the disk.
  constexpr std::uint64_t rows = std::uint64_t{1} << 28U;
  constexpr std::uint64_t size = 8 + rows * 44 + 32;
  fs::path const pack = plant.cache() / "huge.axpack";
  {
    std::ofstream file(pack, std::ios::binary);
    std::uint64_t const numbers[] = {rows, 8, 0};
    file.seekp(static_cast<std::streamoff>(size - 32));
    file.write(reinterpret_cast<char const*>(numbers), sizeof(numbers));
    file << "axpkend1";
  }
  check_same(plant.lint(), plain);
}

TEST_CASE("a file that changes within the resolution of its clock is read again") {
  TemporaryFolder const folder;
  auto const path = folder.write("x.lis", "one");
  FileDigests digests(folder / "files");
  auto const facts = *facts_of(path);
  digests.learn(path, facts, nanoseconds_now(), digest_of("one"));
  digests.save();
  CHECK_FALSE(FileDigests(folder / "files").known(path, facts));
  // Three seconds later it is safe.
  digests.learn(path, facts, nanoseconds_now() + 3'000'000'000, digest_of("one"));
  digests.save();
  FileDigests again(folder / "files");
  CHECK(again.known(path, facts) == digest_of("one"));
  auto other = facts;
  other.inode_changed += 1;
  CHECK_FALSE(again.known(path, other));
  CHECK_FALSE(again.known(folder / "y.lis", facts));
}

TEST_CASE("a restored time of change deceives nobody") {
  Plant const plant;
  REQUIRE(plant.lint().status == 1);
  // Long enough ago to be put into the table of facts.
  std::this_thread::sleep_for(std::chrono::milliseconds(2100));
  REQUIRE(plant.lint().status == 1);
  auto const path = plant.folder / "b.lis";
  auto const time = fs::last_write_time(path);
  auto other = warning();
  other.replace(other.find("kopf"), 4, "kapf");
  REQUIRE(other.size() == warning().size());
  plant.folder.write("b.lis", other);
  fs::last_write_time(path, time);
  check_same(plant.lint(), plant.lint({}, false));
}

TEST_CASE("the size of a cache is bounded, what was used longest ago goes") {
  TemporaryFolder const folder;
  std::string const entry(10'000, 'x');
  auto const key = [](std::uint64_t number) { return Digest{.high = number, .low = number * 7919}; };
  {
    CacheStore store(folder.path(), 1'000'000);
    for (std::uint64_t i = 0; i < 90; ++i) store.add(key(i), entry);
    store.finish();
  }
  auto packs = open_packs(folder.path());
  REQUIRE(packs.size() == 1);
  // All of it was used long ago but for number 7; the future is no time.
  std::vector<std::uint32_t> rows(90);
  for (std::uint32_t i = 0; i < 90; ++i) rows[i] = i;
  packs[0].mark_used(rows, seconds_now() - 5000);
  for (std::uint32_t i = 0; i < 90; ++i) {
    if (packs[0].rows()[i].key == key(7)) packs[0].mark_used({i}, seconds_now());
  }
  {
    CacheStore store(folder.path(), 1'000'000);
    for (std::uint64_t i = 100; i < 130; ++i) store.add(key(i), entry);
    store.finish();
  }
  CacheStore store(folder.path(), 1'000'000);
  std::size_t kept = 0;
  for (std::uint64_t i = 0; i < 90; ++i) kept += store.find(key(i)) ? 1 : 0;
  CHECK(store.find(key(7)) == entry);
  for (std::uint64_t i = 100; i < 130; ++i) CHECK(store.find(key(i)) == entry);
  CHECK(kept < 60);
  CHECK(kept > 30);
  std::uintmax_t size = 0;
  for (auto const& pack : packs_of(folder.path())) size += fs::file_size(pack);
  CHECK(size <= 1'000'000);
}

TEST_CASE("a cache that is too small, or of bad size, is no obstacle") {
  Plant const plant;
  auto const plain = plant.lint({}, false);
  for (int i = 0; i < 3; ++i) check_same(plant.lint({"--cache-size", "1K"}), plain);
  for (auto const* const size : {"0", "x", "5X", "-1", "G", "99999999T"}) {
    auto const outcome = plant.lint({"--cache-size", size});
    INFO(size);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains("--cache-size needs a size"));
  }
  // Where no cache can be, a warning says so, and the result is the same.
  auto const outcome = plant.lint({"--cache", "/proc/nowhere/cache"}, false);
  CHECK(outcome.status == plain.status);
  CHECK(outcome.out == plain.out);
  CHECK_THAT(outcome.err, Contains("the cache /proc/nowhere/cache cannot be used"));
}

TEST_CASE("a cache that cannot be written any more keeps nothing, and says so at the end") {
  TemporaryFolder const folder;
  CacheStore store(folder / "cache", 1'000'000);
  fs::remove_all(folder / "cache");
  store.add({.high = 1, .low = 2}, "content");
  store.add({.high = 1, .low = 3}, "content");
  CHECK_THROWS_WITH(store.finish(), Contains("cannot write"));
}

TEST_CASE("many processes share a cache") {
  Plant const plant;
  for (int i = 0; i < 40; ++i) plant.folder.write("more/" + std::to_string(i) + ".lis", mistakes());
  auto const plain = plant.lint({}, false);
  constexpr int processes = 6;
  std::vector<std::thread> threads;
  threads.reserve(processes);
  std::vector<Outcome> outcomes(processes);
  for (int i = 0; i < processes; ++i) {
    // A small cache, so that they tidy it while others read.
    threads.emplace_back([&, i] {
      for (int round = 0; round < 4; ++round) {
        outcomes[static_cast<std::size_t>(i)] = plant.lint({"--cache-size", "60K"});
      }
    });
  }
  for (auto& thread : threads) thread.join();
  for (auto const& outcome : outcomes) check_same(outcome, plain);
}

TEST_CASE("compile takes images from a cache") {
  Plant const plant;
  plant.folder.write("ok.lis",
                     "kopf.achs_nr 1\nfilter[0].enable 1\nfilter[0].type LOWPASS\nfilter[0].order 2\n"
                     "filter[0].fg_f0 20\nfilter[0].prototype BUTTERWORTH\nEnde\n");
  auto const compile = [&](std::string const& folder, std::vector<std::string> more) {
    more.insert(more.begin(), {"compile", ".", "--output-folder", folder, "--cycle-time", "1ms"});
    return run_axisc(more, in_folder(plant.folder.path()));
  };
  auto const plain = compile("../" + plant.name() + ".cache/plain", {});
  for (std::string const again : {"first", "second"}) {
    check_same(
        compile("../" + plant.name() + ".cache/" + again, {"--cache", "../" + plant.name() + ".cache/c"}),
        plain);
    for (auto const& entry : fs::recursive_directory_iterator(plant.cache() / "plain")) {
      if (!entry.is_regular_file()) continue;
      auto const below = fs::relative(entry.path(), plant.cache() / "plain").string();
      auto const read = [&](std::string const& name) {
        std::ifstream file(plant.cache() / name / below, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
      };
      CHECK_FALSE(read("plain").empty());
      CHECK(read(again) == read("plain"));
    }
  }
}

TEST_CASE("an image from a cache is verified before it is written") {
  Plant const plant;
  plant.folder.write("ok.lis", "kopf.achs_nr 1\nEnde\n");
  std::string const cache = "../" + plant.name() + ".cache";
  auto const compile = [&](std::string const& image) {
    return run_axisc({"compile", "ok.lis", "-o", image, "--cycle-time", "1ms", "--cache", cache},
                     in_folder(plant.folder.path()));
  };
  REQUIRE(compile("a.axim").status == 0);
  // Somebody else's pack: every checksum is right, and the image in it was changed.
  auto const packs = open_packs(plant.cache().string());
  REQUIRE(packs.size() == 1);
  {
    fs::create_directories(plant.cache() / "other");
    PackWriter writer((plant.cache() / "other").string());
    for (std::size_t row = 0; row < packs[0].rows().size(); ++row) {
      auto content = *packs[0].read(row);
      auto const image = content.find("AXIM");
      REQUIRE(image != std::string::npos);
      content[image + 200] = static_cast<char>(content[image + 200] ^ 1);
      writer.add(packs[0].rows()[row].key, content, seconds_now());
    }
    writer.commit();
  }
  fs::remove(packs[0].path());
  auto const other = packs_of(plant.cache() / "other").front();
  fs::rename(other, plant.cache() / other.filename());
  REQUIRE(compile("b.axim").status == 0);
  CHECK(plant.folder.read("b.axim") == plant.folder.read("a.axim"));
}
