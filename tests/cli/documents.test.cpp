// The commands of the documentation are real: each block that begins with `$` is executed in a copy of the
// samples, and what it prints is what the document shows. AXISC_UPDATE_GOLDEN=1 writes the outputs into the
// document.
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace documents_test {

using namespace axisc::test;

namespace {

namespace fs = std::filesystem;

/// What the shell prints for a command in `folder`, standard error included.
std::string shell(std::string const& command, std::string const& folder) {
  std::string const program_folder = fs::path(AXISC_PROGRAM).parent_path().string();
  std::string const line = "cd '" + folder + "' && export PATH='" + program_folder +
                           "':\"$PATH\" LANG=C LC_ALL= LC_MESSAGES= samples='" AXISC_SOURCE_DIR
                           "/samples' && { " +
                           command + "\n} 2>&1";
  std::string output;
  FILE* const pipe = ::popen(line.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::array<char, 4096> buffer{};
  while (std::size_t const got = std::fread(buffer.data(), 1, buffer.size(), pipe))
    output.append(buffer.data(), got);
  ::pclose(pipe);
  return output;
}

/// The document with what its commands print now.
std::string executed(std::string const& document, std::string const& folder) {
  std::istringstream lines(document);
  std::string result;
  bool in_console = false;
  for (std::string line; std::getline(lines, line);) {
    if (in_console && line.rfind("$ ", 0) == 0) {
      result += line + "\n" + shell(line.substr(2), folder);
      continue;
    }
    if (line.rfind("```", 0) == 0) {
      in_console = line == "```console";
    } else if (in_console) {
      continue;
    }
    result += line + "\n";
  }
  return result;
}

/// The blocks of a document that a reader pastes into a shell, of those that run axisc.
std::vector<std::string> pasted(std::string const& document) {
  std::istringstream lines(document);
  std::vector<std::string> blocks;
  std::string block;
  bool in_block = false;
  bool runs_axisc = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("```", 0) == 0) {
      if (in_block && runs_axisc) blocks.push_back(block);
      in_block = line == "```sh";
      runs_axisc = false;
      block.clear();
    } else if (in_block) {
      block += line + "\n";
      runs_axisc = runs_axisc || line.rfind("axisc ", 0) == 0;
    }
  }
  return blocks;
}

/// A document, and what makes the folder in which its reader works.
struct Page {
  char const* document;
  char const* folder;
};

constexpr Page pages[] = {
    {"README.md",
     "cp -r $samples/controller/. $samples/controller-project/project/hochlauf.tsproj . && "
     "mv hochlauf.tsproj Project.tsproj && cp $samples/controller-xml/listen/achsmds1.xml update.xml"},
    {"docs/circle.md",
     "cp -r $samples . && cp samples/circle/* . && "
     "awk 'BEGIN { print \"angle_deg,deviation_um\"; for (i = 0; i <= 720; ++i) print i / 2 \",\" i % 7 }' "
     ">ballbar.csv"},
    {"docs/compare.md",
     "cp $samples/mill/* . && axisc compile machine.json -o m.axim -q 2>findings && "
     "axisc run m.axim --signal ramp:1000 --cycles 9000 | "
     "awk -F, '{print (NR == 1 ? \"setpoint\" : NR - 1) \",\" $1}' >scope.csv"},
    {"docs/contour.md", "cp $samples/mill/* ."},
    {"docs/controller-folder.md",
     "cp -r $samples/controller/. . && mkdir old && cp listen/sda_mds1.lis old/sda.txt"},
    {"docs/export.md", "cp -r $samples ."},
    {"docs/fmu.md", "cp -r $samples ."},
    {"docs/findings.md", "cp -r $samples ."},
    {"docs/gallery.md", "cp -r $samples . && cp -r samples/controller repaired"},
    {"docs/identify.md", "cp $samples/resonance/* . && cp moves.csv x.csv"},
    {"docs/machine-file.md",
     "cp $samples/mill/* . && cp z.lis x2.lis && cp $samples/controller/listen/sda_mds1.lis . && "
     "sed -n '/^{/,/^}/p' $document >machine.json"},
    {"docs/nc-programs.md", "cp -r $samples ."},
    {"docs/pipelines.md",
     "cp -r $samples/mill plant && cp -r plant lists && ls plant/*.lis >changed.txt && "
     "echo plant/machine.json >machines.txt && git init -q -b main . && git add . && "
     "git -c user.name=a -c user.email=a commit -qm lists && git update-ref refs/remotes/origin/main HEAD"},
    {"docs/plant-file.md", "cp $samples/mill/* . && sed -n '/^{/,/^}/p' $document >plant.json"},
    {"docs/plots.md",
     "cp -r $samples/controller/. $samples/mill/* . && mkdir old && cp -r listen prog old && "
     "axisc compile machine.json -o mill.axim -q 2>findings"},
    {"docs/record.md",
     "cp $samples/resonance/* . && cp torque-velocity.csv x.csv && cp torque-velocity.csv record.svdx && "
     "cp $samples/circle/ccw.csv circle.svdx"},
    {"docs/report.md", "cp -r $samples/controller/. $samples/mill/* . && mkdir old && cp -r listen prog old"},
    {"docs/runtime.md",
     "cp $samples/mill/* . && axisc compile machine.json -o mill.axim -q 2>findings && "
     "axisc run mill.axim --record crash.axrd >outputs"},
    {"docs/schema-files.md", "cp $samples/mill/* . && sed -n '/^{/,/^}/p' $document >build-3200.json"},
    {"docs/suggest.md",
     "cp $samples/resonance/* . && sed '1s/Force X \\[N\\]/Torque/; 1s/Velocity X \\[mm.s\\]/Velocity/' "
     "torque-velocity.csv "
     ">scope.csv"},
    {"docs/twincat-project.md",
     "cp -r $samples/controller-project/. . && cp project/hochlauf.tsproj Project.tsproj"},
};

}  // namespace

TEST_CASE("the tutorial shows what its commands print") {
  TemporaryFolder const folder;
  fs::copy(std::string(AXISC_SOURCE_DIR) + "/samples/tutorial", folder / "try");
  check_golden("docs/tutorial.md", executed(read_source_file("docs/tutorial.md"), folder / "try"));
}

TEST_CASE("the gallery shows what its commands print") {
  std::string const folder = std::string(AXISC_SOURCE_DIR) + "/samples/mistakes";
  check_golden("docs/mistakes.md", executed(read_source_file("docs/mistakes.md"), folder));
}

TEST_CASE("the front page shows what its commands print") {
  TemporaryFolder const folder;
  fs::copy(std::string(AXISC_SOURCE_DIR) + "/samples/tutorial", folder / "try");
  check_golden("README.md", executed(read_source_file("README.md"), folder / "try"));
}

TEST_CASE("the page about TwinCAT projects shows the machine of the sample") {
  TemporaryFolder const folder;
  fs::copy(std::string(AXISC_SOURCE_DIR) + "/samples/controller-project", folder / "try",
           fs::copy_options::recursive);
  check_golden("docs/twincat-project.md",
               executed(read_source_file("docs/twincat-project.md"), folder / "try"));
}

TEST_CASE("the page about a controller's folder shows the machine of the sample") {
  TemporaryFolder const folder;
  fs::copy(std::string(AXISC_SOURCE_DIR) + "/samples/controller", folder / "try",
           fs::copy_options::recursive);
  check_golden("docs/controller-folder.md",
               executed(read_source_file("docs/controller-folder.md"), folder / "try"));
}

TEST_CASE("the page about suggestions shows what its commands print") {
  TemporaryFolder const folder;
  fs::copy(std::string(AXISC_SOURCE_DIR) + "/samples/resonance", folder / "try");
  fs::copy(std::string(AXISC_SOURCE_DIR) + "/samples/motion/rack", folder / "try/rack");
  check_golden("docs/suggest.md", executed(read_source_file("docs/suggest.md"), folder / "try"));
}

TEST_CASE("the page about mass and friction shows what its commands print") {
  TemporaryFolder const folder;
  fs::copy(std::string(AXISC_SOURCE_DIR) + "/samples/resonance", folder / "try");
  check_golden("docs/identify.md", executed(read_source_file("docs/identify.md"), folder / "try"));
}

TEST_CASE("the page about recordings shows what its commands print") {
  TemporaryFolder const folder;
  fs::copy(std::string(AXISC_SOURCE_DIR) + "/samples/recording", folder / "try", fs::copy_options::recursive);
  check_golden("docs/compare.md", executed(read_source_file("docs/compare.md"), folder / "try"));
}

TEST_CASE("the page about looking up, getting and setting values shows what its commands print") {
  TemporaryFolder const folder;
  fs::copy(std::string(AXISC_SOURCE_DIR) + "/samples/mill", folder / "try");
  check_golden("docs/values.md", executed(read_source_file("docs/values.md"), folder / "try"));
}

TEST_CASE("the pages about the position loop and about proofs show what their commands print") {
  for (std::string const document : {"docs/closed-loop.md", "docs/certificate.md"}) {
    TemporaryFolder const folder;
    fs::create_directories(folder / "try/examples");
    fs::copy(std::string(AXISC_SOURCE_DIR) + "/samples", folder / "try/samples", fs::copy_options::recursive);
    fs::copy(std::string(AXISC_SOURCE_DIR) + "/examples/axim_check.c", folder / "try/examples");
    check_golden(document, executed(read_source_file(document), folder / "try"));
  }
}

TEST_CASE("the page about the runtime says how large an image is") {
  TemporaryFolder const folder;
  auto const image = folder / "mill.axim";
  auto const size_of = [&](std::string const& options) {
    shell("axisc compile -q \"$samples/mill\" -o mill.axim " + options, folder.path());
    return std::to_string(fs::file_size(image));
  };
  auto const complete = size_of("");
  CHECK_THAT(
      read_source_file("docs/runtime.md"),
      Catch::Matchers::Contains("image of " + size_of("--strip") + " bytes stripped, " + complete + "\n"));
}

TEST_CASE("the page about settings shows what applies") {
  TemporaryFolder const folder;
  auto const document = read_source_file("docs/settings.md");
  auto const begin = document.find("```json\n") + 8;
  folder.write("axisc.json", document.substr(begin, document.find("```", begin) - begin));
  folder.write("build-3200.json", R"({"version": 1, "parameters": []})");
  folder.write("x.lis", "kopf.achs_nr 1\n");
  check_golden("docs/settings.md", executed(document, folder.path()));
}

TEST_CASE("every guide has an example that is run") {
  // What both the guide and the test of it name: a command or a file of the example.
  struct Elsewhere {
    char const* document;
    char const* runs;
    char const* both;
  };
  static constexpr Elsewhere elsewhere[] = {
      {"browser", ".ci/web", ".ci/web"},
      {"building", "test.sh", "cmake --preset release"},
      {"editors", "tests/editors/neovim.sh", "editor/clients/neovim"},
      {"filters", "tests/cli/plots/gallery.test.cpp", "(filters/"},
      {"image-format", "tests/codegen/image_format_document.test.cpp", "docs/tools/image_format_doc"},
      {"installation", ".ci/packages", "tar -xf"},
      {"library", "tests/examples/libraries.sh", "check_and_compile"},
      {"linuxcnc", "tests/linuxcnc/run.py", "simulated.hal"},
      {"packages", ".ci/packages", "axisc_add_image("},
      {"python", "tests/python/test_axisc.py", "import axisc"},
      {"rules", "tests/cli/explain.test.cpp", "axisc explain"},
      {"webassembly", ".ci/wasm", "cmake --build --preset wasm --target axisc"},
  };
  for (auto const& entry : fs::directory_iterator(AXISC_SOURCE_DIR "/docs")) {
    auto const name = entry.path().stem().string();
    if (entry.path().extension() != ".md" || name == "README" || name == "glossary" ||
        name == "architecture") {
      continue;
    }
    CAPTURE(name);
    auto const* const found = std::find_if(std::begin(elsewhere), std::end(elsewhere),
                                           [&](Elsewhere const& one) { return one.document == name; });
    auto const document = read_source_file("docs/" + name + ".md");
    bool const is_run_here = document.find("```console") != std::string::npos || !pasted(document).empty();
    CHECK(is_run_here == (found == std::end(elsewhere)));
    if (found == std::end(elsewhere)) continue;
    CHECK_THAT(document, Catch::Matchers::Contains(found->both));
    CHECK_THAT(read_source_file(found->runs), Catch::Matchers::Contains(found->both));
  }
}

TEST_CASE("translated guides have the headings, rows and commands of the English ones") {
  auto const outline = [](std::string const& document) {
    std::istringstream lines(read_source_file(document));
    std::string result;
    bool in_commands = false;
    bool in_block = false;
    for (std::string line; std::getline(lines, line);) {
      bool const is_fence = line.rfind("```", 0) == 0;
      if (is_fence) in_block = !in_block;
      if (is_fence) in_commands = line == "```sh";
      auto const mark = line.substr(0, line.find_first_not_of("#|-"));
      result += in_block ? (in_commands ? line : "code") + "\n" : mark.empty() ? "" : mark + "\n";
    }
    return result;
  };
  std::size_t translated = 0;
  for (auto const& entry : fs::directory_iterator(AXISC_SOURCE_DIR "/docs/de")) {
    auto const name = entry.path().filename().string();
    CAPTURE(name);
    CHECK(outline("docs/de/" + name) == outline("docs/" + name));
    ++translated;
  }
  CHECK(translated >= 2);
}

TEST_CASE("every document with lines for the shell says where they run") {
  auto const is_known = [](std::string const& document) {
    return std::any_of(std::begin(pages), std::end(pages),
                       [&](Page const& page) { return document == page.document; });
  };
  for (auto const& entry : fs::directory_iterator(AXISC_SOURCE_DIR "/docs")) {
    if (entry.path().extension() != ".md") continue;
    std::string const document = "docs/" + entry.path().filename().string();
    CAPTURE(document);
    CHECK((pasted(read_source_file(document)).empty() || is_known(document)));
  }
}

TEST_CASE("every line for the shell in the documentation runs") {
  // Findings are no failure; a command that does not exist, a missing file or an unknown option is.
  std::string const watched =
      "said=$PWD/../said; axisc() { status=0; command axisc \"$@\" 2>$said || status=$?; [ $status -gt 1 ] "
      "|| return 0; "
      "{ echo \"axisc $*: exit status $status\" && cat $said; } >&3; return $status; }; "
      "exec 3>&1 >$said.all 2>&1; trap '[ $? = 0 ] || { echo failed && cat $said.all; } >&3' EXIT; set -e\n";
  for (auto const& [document, prepare] : pages) {
    CAPTURE(document);
    TemporaryFolder const folder;
    fs::create_directory(folder / "try");
    std::string const source = "document='" AXISC_SOURCE_DIR "/" + std::string(document) + "'; ";
    REQUIRE(shell(source + prepare + " || echo not prepared", folder / "try") == "");
    for (auto const& block : pasted(read_source_file(document)))
      CHECK(shell(watched + block, folder / "try") == "");
  }
}

}  // namespace documents_test
