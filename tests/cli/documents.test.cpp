// The commands of the documentation are real: each block that begins with `$` is executed in a copy of the
// samples, and what it prints is what the document shows. AXISC_UPDATE_GOLDEN=1 writes the outputs into the
// document.
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>

using namespace axisc::test;

namespace {

namespace fs = std::filesystem;

/// What the shell prints for a command in `folder`, standard error included.
std::string shell(std::string const& command, std::string const& folder) {
  std::string const program_folder = fs::path(AXISC_PROGRAM).parent_path().string();
  std::string const line = "cd '" + folder + "' && export PATH='" + program_folder +
                           "':\"$PATH\" LANG=C LC_ALL= LC_MESSAGES= && { " + command + "\n} 2>&1";
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
