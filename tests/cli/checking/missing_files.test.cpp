// No configuration passes of which a file is missing or damaged, whichever it is.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/file_contents.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

namespace fs = std::filesystem;
using Contents = std::map<std::string, std::string>;

/// The file that makes the machine, and all others of its folder, by their paths in it.
struct Configuration {
  std::string name, root;
  Contents files;
};

Contents contents_of(fs::path const& folder) {
  Contents contents;
  for (auto const& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    contents[entry.path().lexically_relative(folder).generic_string()] = file_contents(entry.path());
  }
  return contents;
}

bool is_root(std::string const& name) {
  auto const file = fs::path(name).filename();
  return file == "machine.json" || file == "hochlauf.lis" || file == "hochlauf.xml" ||
         file == "hochlauf.tsproj";
}

/// Every sample that is a machine. `mistakes` and `tutorial` have errors as they are.
std::vector<Configuration> configurations() {
  std::vector<Configuration> found;
  auto const samples = fs::path(AXISC_SOURCE_DIR) / "samples";
  for (auto const& entry : fs::recursive_directory_iterator(samples)) {
    auto const name = entry.path().lexically_relative(samples).generic_string();
    if (!is_root(name) || name.starts_with("mistakes/") || name.starts_with("tutorial/")) continue;
    auto folder = entry.path().parent_path();
    // The programs of a controller lie beside the folder of its lists.
    if (fs::exists(folder.parent_path() / "prog")) folder = folder.parent_path();
    found.push_back({.name = folder.lexically_relative(samples).generic_string(),
                     .root = entry.path().lexically_relative(folder).generic_string(),
                     .files = contents_of(folder)});
  }
  std::sort(found.begin(), found.end(),
            [](Configuration const& a, Configuration const& b) { return a.name < b.name; });
  return found;
}

/// The files whose names are in the text of another one.
std::vector<std::string> named_files(Configuration const& configuration) {
  std::vector<std::string> named;
  for (auto const& [path, own] : configuration.files) {
    auto const file = fs::path(path).filename().string();
    bool const is_named = std::any_of(configuration.files.begin(), configuration.files.end(),
                                      [&, &path = path](auto const& other) {
                                        return other.first != path && !other.first.ends_with(".nc") &&
                                               other.second.find(file) != std::string::npos;
                                      });
    // Measured data and plants are named in no list.
    if (is_named && path != configuration.root) named.push_back(path);
  }
  return named;
}

std::string as_utf16(std::string const& bytes) {
  std::string wide = "\xFF\xFE";
  for (char const byte : bytes) wide.append(1, byte).append(1, '\0');
  return wide;
}

struct Damage {
  char const* name;
  std::function<void(fs::path const& file, std::string const& bytes)> apply;
};

void overwrite(fs::path const& path, std::string const& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::array<Damage, 5> const of_named_files = {
    Damage{"removed", [](fs::path const& file, std::string const&) { fs::remove(file); }},
    Damage{"in UTF-16",
           [](fs::path const& file, std::string const& bytes) { overwrite(file, as_utf16(bytes)); }},
    Damage{"a folder",
           [](fs::path const& file, std::string const&) {
             fs::remove(file);
             fs::create_directory(file);
           }},
    // As root every file may be read, but none that a link leads nowhere.
    Damage{"a dangling link",
           [](fs::path const& file, std::string const&) {
             fs::remove(file);
             fs::create_symlink("nowhere", file);
           }},
    Damage{"a link to itself",
           [](fs::path const& file, std::string const&) {
             fs::remove(file);
             fs::create_symlink(file.filename(), file);
           }},
};

/// For files that say which others there are, or whose form says where they end. The first half of a plain
/// list may be as good as the whole.
std::array<Damage, 3> const of_enclosing_files = {
    Damage{"emptied", [](fs::path const& file, std::string const&) { overwrite(file, ""); }},
    Damage{"cut in half",
           [](fs::path const& file, std::string const& bytes) {
             overwrite(file, bytes.substr(0, bytes.size() / 2));
           }},
    Damage{"cut after half of its lines",
           [](fs::path const& file, std::string const& bytes) {
             overwrite(file, bytes.substr(0, bytes.find('\n', bytes.size() / 2) + 1));
           }},
};

void write(Configuration const& configuration, TemporaryFolder const& folder) {
  for (auto const& [path, bytes] : configuration.files) folder.write(path, bytes);
}

enum class Tried { lint, every_command };

void check_refused(Configuration const& configuration, std::string const& path, Damage const& damage,
                   Tried tried) {
  INFO(configuration.name << ": " << path << " is " << damage.name);
  TemporaryFolder const folder;
  write(configuration, folder);
  damage.apply(folder / path, configuration.files.at(path));
  auto const there = in_folder(folder.path());
  auto const linted = run_axisc({"lint", "."}, there);
  INFO(linted.out << linted.err);
  CHECK(linted.status != 0);
  CHECK(linted.out.find("no findings") == std::string::npos);
  if (tried == Tried::lint) return;
  CHECK(run_axisc({"compile", configuration.root, "-o", "out.axim"}, there).status != 0);
  CHECK_FALSE(fs::exists(folder / "out.axim"));
  CHECK(run_axisc({"report", configuration.root, "-o", "page.html"}, there).status != 0);
  // What cannot be checked at all gets no page.
  if (!fs::exists(folder / "page.html")) return;
  auto const page = folder.read("page.html");
  CHECK(page.find("Yes, ") == std::string::npos);
  CHECK(page.find("Not within the tolerance") == std::string::npos);
}

bool is_enclosing(Configuration const& configuration, std::string const& path) {
  return path == configuration.root || path.ends_with(".xml");
}

}  // namespace

TEST_CASE("every sample configuration is good as it is, and names its files") {
  auto const all = configurations();
  CHECK(all.size() >= 9);
  for (auto const& configuration : all) {
    INFO(configuration.name);
    TemporaryFolder const folder;
    write(configuration, folder);
    CHECK(run_axisc({"lint", "."}, in_folder(folder.path())).status == 0);
    CHECK(named_files(configuration).size() >= 1);
  }
}

TEST_CASE("no configuration passes of which a named file is missing or damaged") {
  std::size_t turn = 0;
  for (auto const& configuration : configurations()) {
    for (auto const& path : named_files(configuration)) {
      // The full form is the long test.
      check_refused(configuration, path, of_named_files.at(turn % of_named_files.size()),
                    turn % 8 == 0 ? Tried::every_command : Tried::lint);
      ++turn;
    }
  }
}

TEST_CASE("no configuration passes whose machine file, start-up list, project or list in XML is cut off") {
  std::size_t turn = 0;
  for (auto const& configuration : configurations()) {
    for (auto const& [path, bytes] : configuration.files) {
      if (!is_enclosing(configuration, path)) continue;
      check_refused(configuration, path, of_enclosing_files.at(turn % of_enclosing_files.size()),
                    Tried::lint);
      ++turn;
    }
  }
}

TEST_CASE("a start-up list none of whose lists is there is never ready, whether findings are shown or not") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  auto const sample = contents_of(fs::path(AXISC_SOURCE_DIR) / "samples/controller");
  folder.write("hochlauf.lis", sample.at("listen/hochlauf.lis"));
  CHECK_THAT(run_axisc({"lint", "."}, there).out, Contains("16 errors"));
  CHECK(run_axisc({"report", ".", "-o", "page.html"}, there).status == 1);
  CHECK_THAT(folder.read("page.html"), Contains("No: errors: "));
  auto const contour = run_axisc({"contour", ".", "--cycle-time", "1ms"}, there);
  CHECK(contour.status == 1);
  CHECK_THAT(contour.err, Contains("AX7002") && !Contains("silenced"));

  fs::remove(folder / "page.html");
  folder.write("axisc.json", R"({"disable": ["AX7002"]})");
  for (auto const& command : std::vector<std::vector<std::string>>{{"compile", ".", "-o", "out.axim"},
                                                                   {"report", ".", "-o", "page.html"},
                                                                   {"contour", ".", "--cycle-time", "1ms"}}) {
    INFO(command.front());
    auto const outcome = run_axisc(command, there);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains("describes no complete machine"));
  }
  CHECK_FALSE(fs::exists(folder / "out.axim"));
  CHECK_FALSE(fs::exists(folder / "page.html"));
}

TEST_CASE("a start-up list without axes is never ready, whether findings are shown or not") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("hochlauf.lis", "kanal_anzahl 0\nzahl_mds 0\nEnde\n");
  CHECK(run_axisc({"lint", "."}, there).status == 1);
  folder.write("axisc.json", R"({"disable": ["AX7007"], "cycle_time_us": 1000})");
  for (auto const& command : std::vector<std::vector<std::string>>{
           {"compile", ".", "-o", "out.axim"}, {"report", ".", "-o", "page.html"}, {"contour", "."}}) {
    INFO(command.front());
    auto const outcome = run_axisc(command, there);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains("configures no axis"));
  }
  CHECK_FALSE(fs::exists(folder / "out.axim"));
  CHECK_FALSE(fs::exists(folder / "page.html"));
}

TEST_CASE("an axis is checked though the default list is missing") {
  TemporaryFolder const folder;
  folder.write("listen/hochlauf.lis",
               "kanal_anzahl 0\nzahl_mds 1\ndefault_achs_mds ./listen/default.lis\n"
               "achs_mds[0] ./listen/x.lis\nEnde\n");
  folder.write("listen/x.lis",
               "kopf.achs_nr 1\nfilter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 999\nEnde\n");
  auto const outcome = run_axisc({"lint", "listen"}, in_folder(folder.path()));
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.out, Contains("error[AX7002]") && Contains("error[AX3001]") &&
                              Contains("the control's own defaults count"));
}

TEST_CASE("machine says what is missing") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  fs::copy(AXISC_SOURCE_DIR "/samples/controller", folder.path(), fs::copy_options::recursive);
  fs::remove(folder / "prog/init.nc");
  std::string const place = "listen/sda_mds1.lis:17";
  std::string const reason = "the program \"init.nc\" is not found\n";
  auto const text = run_axisc({"machine", "listen"}, there);
  CHECK(text.status == 1);
  CHECK_THAT(text.out, Contains(place + "  " + reason));
  auto const json = run_axisc({"machine", "listen", "--format", "json"}, there);
  CHECK(json.status == 1);
  CHECK(json.err == place + ": " + reason);
}

TEST_CASE("machine says that a machine file is none, and writes none") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  for (std::string const text : {R"({"machine": "m", "axes": 5})", R"({"machine": "m")"}) {
    folder.write("machine.json", text);
    INFO(text);
    auto const shown = run_axisc({"machine", "machine.json"}, there);
    CHECK(shown.status == 1);
    CHECK_THAT(shown.out, Contains("machine.json:"));
    auto const written = run_axisc({"machine", "machine.json", "--format", "json"}, there);
    CHECK(written.status == 1);
    CHECK(written.out.empty());
    CHECK_THAT(written.err, Contains("machine.json:"));
  }
}

TEST_CASE("a copy of the folder by another name is a machine like the original") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  fs::copy(AXISC_SOURCE_DIR "/samples/controller", folder.path(), fs::copy_options::recursive);
  auto const original = run_axisc({"machine", "listen"}, there).out;
  fs::rename(folder / "listen", folder / "Kunde4711");
  auto const copy = run_axisc({"machine", "Kunde4711"}, there);
  CHECK(copy.status == 0);
  CHECK(lines_of(copy.out) == lines_of(original));
  auto const linted = run_axisc({"lint", "Kunde4711", "--pedantic"}, there);
  CHECK(linted.status == 0);
  CHECK_THAT(linted.out, Contains(R"("Kunde4711/achsmds1.lis" was taken for "./listen/achsmds1.lis")"));
  // Beside the original it leads back to it.
  fs::copy(AXISC_SOURCE_DIR "/samples/controller/listen", folder / "listen", fs::copy_options::recursive);
  CHECK_THAT(run_axisc({"lint", "Kunde4711"}, there).out,
             Contains(R"("listen/achsmds1.lis" was taken for "./listen/achsmds1.lis", but )"
                      R"("Kunde4711/achsmds1.lis" may be meant)"));
}

TEST_CASE("no configuration passes with any damage to any of its files", "[.][long]") {
  for (auto const& configuration : configurations()) {
    for (auto const& path : named_files(configuration)) {
      for (auto const& damage : of_named_files)
        check_refused(configuration, path, damage, Tried::every_command);
    }
    for (auto const& [path, bytes] : configuration.files) {
      if (!is_enclosing(configuration, path)) continue;
      for (auto const& damage : of_enclosing_files) check_refused(configuration, path, damage, Tried::lint);
    }
    check_refused(configuration, configuration.root, of_named_files[1], Tried::every_command);
  }
}
