// Arrows only point down: an include may name a folder only if the target of the including folder links it.
#include "support/catch.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

std::set<std::string> const folders = {"diagnostics", "grammar", "schema", "design", "validator",
                                       "codegen",     "runtime", "motion", "cli"};

/// Folders that each folder's CMakeLists.txt links.
std::map<std::string, std::set<std::string>> target_graph() {
  std::map<std::string, std::set<std::string>> graph;
  std::regex const word("axisc_([a-z]+)|\\b([a-z]+)\\b");
  for (auto const& folder : folders) {
    fs::path const file = fs::path(AXISC_SOURCE_DIR) / folder / "CMakeLists.txt";
    if (!fs::exists(file)) continue;
    std::ifstream in(file);
    std::string const text((std::istreambuf_iterator<char>(in)), {});
    auto& links = graph[folder];
    links.insert(folder);
    auto const depends = text.find("DEPENDS");
    std::string const tail = folder == "cli"                ? text
                             : depends == std::string::npos ? ""
                                                            : text.substr(depends);
    for (std::sregex_iterator match(tail.begin(), tail.end(), word), end; match != end; ++match) {
      std::string const name = (*match)[1].matched ? (*match)[1].str() : (*match)[2].str();
      if (folders.contains(name)) links.insert(name);
      if (name == "axisrt") links.insert("runtime");
    }
  }
  return graph;
}

/// Everything that can be reached: a target hands on what it links.
void close(std::map<std::string, std::set<std::string>>& graph) {
  for (bool grown = true; grown;) {
    grown = false;
    for (auto& [folder, links] : graph) {
      auto const before = links;
      for (auto const& link : before) links.insert(graph[link].begin(), graph[link].end());
      grown = grown || links.size() != before.size();
    }
  }
}

}  // namespace

TEST_CASE("includes follow the target graph") {
  auto graph = target_graph();
  close(graph);
  std::regex const include("^\\s*#\\s*include\\s*\"([a-z]+)/");
  std::size_t files = 0;
  for (auto const& folder : folders) {
    if (!fs::exists(fs::path(AXISC_SOURCE_DIR) / folder)) continue;
    for (auto const& entry : fs::recursive_directory_iterator(fs::path(AXISC_SOURCE_DIR) / folder)) {
      auto const extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".hpp" && extension != ".h") continue;
      ++files;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (!std::regex_search(line, match, include) || !folders.contains(match[1].str())) continue;
        INFO(entry.path().string() << ": " << line);
        CHECK(graph[folder].contains(match[1].str()));
      }
    }
  }
  CHECK(files > 50);
}

TEST_CASE("the runtime depends on nothing of the tool") {
  auto graph = target_graph();
  CHECK(graph["runtime"] == std::set<std::string>{"runtime"});
  CHECK(graph["diagnostics"] == std::set<std::string>{"diagnostics"});
  CHECK(graph["schema"] == std::set<std::string>{"diagnostics", "schema"});
  CHECK(graph["design"] == std::set<std::string>{"design"});
}

TEST_CASE("Spirit lives in grammar/ and nowhere else") {
  for (auto const& folder : folders) {
    if (folder == "grammar" || !fs::exists(fs::path(AXISC_SOURCE_DIR) / folder)) continue;
    for (auto const& entry : fs::recursive_directory_iterator(fs::path(AXISC_SOURCE_DIR) / folder)) {
      auto const extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".hpp" && extension != ".h") continue;
      std::ifstream in(entry.path());
      std::string const text((std::istreambuf_iterator<char>(in)), {});
      INFO(entry.path().string());
      CHECK(text.find("boost/spirit") == std::string::npos);
    }
  }
}
