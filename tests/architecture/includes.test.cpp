// Arrows only point down: an include may name a folder only if the target of the including folder links it.
#include "support/catch.hpp"
#include "support/file_contents.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Each library and its folder.
std::map<std::string, std::string> const libraries = {
    {"system", "system"},
    {"diagnostics", "diagnostics"},
    {"grammar", "grammar"},
    {"schema", "schema"},
    {"design", "design"},
    {"machine", "configuration/machine"},
    {"configuration", "configuration"},
    {"validator", "validator"},
    {"codegen", "codegen"},
    {"image", "image"},
    {"runtime", "runtime"},
    {"recordings", "analysis/recordings"},
    {"motion", "analysis/motion"},
    {"tuning", "analysis/tuning"},
    {"comparison", "analysis/comparison"},
    {"circle", "analysis/circle"},
    {"pictures", "presentation/pictures"},
    {"presentation", "presentation"},
    {"axisc", "axisc"},
    {"editor", "editor"},
    {"interface", "axisc/interface"},
    {"cli", "cli"},
};

/// What each library may include, beside itself: the picture of the architecture.
std::map<std::string, std::set<std::string>> const may_include = {
    {"system", {}},
    {"diagnostics", {}},
    {"schema", {"diagnostics"}},
    {"design", {}},
    {"runtime", {}},
    {"grammar", {"diagnostics"}},
    {"machine", {"design"}},
    {"configuration", {"machine", "design", "schema", "grammar", "diagnostics"}},
    {"validator",
     {"system", "configuration", "machine", "design", "schema", "grammar", "diagnostics", "runtime"}},
    {"codegen", {"machine", "design", "runtime"}},
    {"image", {"codegen", "machine", "design", "schema", "runtime"}},
    {"pictures", {"diagnostics"}},
    {"presentation", {"pictures", "diagnostics"}},
    {"comparison", {"motion", "recordings", "machine", "design", "diagnostics"}},
    {"circle", {"motion"}},
    {"recordings", {"diagnostics"}},
    {"tuning", {"motion", "recordings", "image", "codegen", "machine", "design", "diagnostics", "runtime"}},
    {"motion", {"image", "codegen", "machine", "schema", "design", "grammar", "diagnostics", "runtime"}},
    {"axisc",
     {"presentation", "pictures", "motion", "tuning", "comparison", "circle", "recordings", "image",
      "codegen", "validator", "configuration", "machine", "design", "schema", "grammar", "diagnostics",
      "system", "runtime"}},
    {"editor",
     {"axisc", "presentation", "pictures", "motion", "image", "codegen", "validator", "configuration",
      "machine", "design", "schema", "grammar", "diagnostics"}},
    {"interface",
     {"axisc", "editor", "presentation", "pictures", "image", "codegen", "validator", "configuration",
      "diagnostics", "system"}},
    {"cli",
     {"axisc", "editor", "presentation", "pictures", "motion", "tuning", "comparison", "recordings", "image",
      "codegen", "validator", "configuration", "machine", "design", "schema", "grammar", "diagnostics",
      "system", "runtime"}},
};

/// The top folders of all libraries.
std::set<std::string> tops_with_sources() {
  std::set<std::string> tops;
  for (auto const& [library, folder] : libraries) tops.insert(folder.substr(0, folder.find('/')));
  return tops;
}

/// Stages of the validator, the lowest first: none includes a later one.
std::vector<std::string> const stages = {"values", "commands", "loading", "views", "engine", "rules"};

/// Every source of the folder and below it.
std::vector<fs::path> sources_of(std::string const& folder) {
  std::vector<fs::path> sources;
  for (auto const& entry : fs::recursive_directory_iterator(fs::path(AXISC_SOURCE_DIR) / folder)) {
    auto const extension = entry.path().extension();
    if (extension == ".cpp" || extension == ".hpp" || extension == ".h") sources.push_back(entry.path());
  }
  return sources;
}

/// The included files of this project.
std::vector<std::string> includes_of(fs::path const& source) {
  static std::regex const include("^\\s*#\\s*include\\s*\"([^\"]+)\"");
  std::vector<std::string> included;
  std::ifstream in(source);
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (std::regex_search(line, match, include)) included.push_back(match[1].str());
  }
  return included;
}

/// The library that a file belongs to, by its path from the root; empty for none.
std::string library_of(std::string const& path) {
  std::string found;
  std::size_t longest = 0;
  for (auto const& [library, folder] : libraries) {
    if (folder.size() < longest || !path.starts_with(folder + "/")) continue;
    longest = folder.size();
    found = library;
  }
  return found;
}

std::string from_root(fs::path const& source) {
  return source.lexically_relative(AXISC_SOURCE_DIR).generic_string();
}

/// Libraries that each library's CMakeLists.txt links.
std::map<std::string, std::set<std::string>> target_graph() {
  std::map<std::string, std::set<std::string>> graph;
  std::regex const word("axisc_([a-z]+)|\\b([a-z]+)\\b");
  for (auto const& [library, folder] : libraries) {
    fs::path const file = fs::path(AXISC_SOURCE_DIR) / folder / "CMakeLists.txt";
    if (!fs::exists(file)) continue;
    auto const text = axisc::test::file_contents(file);
    auto& links = graph[library];
    links.insert(library);
    auto const depends = text.find("DEPENDS");
    std::string const tail = library == "cli"               ? text
                             : depends == std::string::npos ? ""
                                                            : text.substr(depends);
    for (std::sregex_iterator match(tail.begin(), tail.end(), word), end; match != end; ++match) {
      std::string const name = (*match)[1].matched ? (*match)[1].str() : (*match)[2].str();
      if (libraries.contains(name)) links.insert(name);
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
  std::size_t files = 0;
  for (auto const& [library, folder] : libraries) {
    for (auto const& source : sources_of(folder)) {
      if (library_of(from_root(source)) != library) continue;
      ++files;
      for (auto const& included : includes_of(source)) {
        auto const target = library_of(included);
        if (target.empty()) continue;
        INFO(source.string() << " includes " << included);
        CHECK(graph[library].contains(target));
      }
    }
  }
  CHECK(files > 500);
}

TEST_CASE("each library includes what the architecture lets it include") {
  for (auto const& [library, allowed] : may_include) {
    for (auto const& source : sources_of(libraries.at(library))) {
      if (library_of(from_root(source)) != library) continue;
      for (auto const& included : includes_of(source)) {
        auto const target = library_of(included);
        if (target.empty() || target == library) continue;
        INFO(source.string() << " includes " << included);
        CHECK(allowed.contains(target));
      }
    }
  }
}

TEST_CASE("arrows between the folders of the library, of the faces and of the presentation form no circle") {
  std::map<std::string, std::set<std::string>> arrows;
  std::map<std::string, std::string> example;
  for (std::string const top : {"axisc", "presentation", "editor", "cli"}) {
    for (auto const& source : sources_of(top)) {
      auto const from = fs::path(from_root(source)).parent_path().generic_string();
      for (auto const& included : includes_of(source)) {
        auto const to = fs::path(included).parent_path().generic_string();
        if (to == from || !libraries.contains(included.substr(0, included.find('/')))) continue;
        arrows[from].insert(to);
        example[from + " -> " + to] = from_root(source) + " includes " + included;
      }
    }
  }
  auto reached = arrows;
  for (bool grown = true; grown;) {
    grown = false;
    for (auto& [from, to] : reached) {
      auto const before = to;
      for (auto const& next : before) {
        auto const beyond = reached.find(next);
        if (beyond != reached.end()) to.insert(beyond->second.begin(), beyond->second.end());
      }
      grown = grown || to.size() != before.size();
    }
  }
  for (auto const& [from, direct] : arrows) {
    for (auto const& to : direct) {
      auto const back = reached.find(to);
      INFO(from << " -> " << to << ", and back again: " << example[from + " -> " + to]);
      CHECK_FALSE((back != reached.end() && back->second.contains(from)));
    }
  }
}

TEST_CASE("the runtime depends on nothing of the tool") {
  auto graph = target_graph();
  CHECK(graph["runtime"] == std::set<std::string>{"runtime"});
  CHECK(graph["diagnostics"] == std::set<std::string>{"diagnostics"});
  CHECK(graph["schema"] == std::set<std::string>{"diagnostics", "schema"});
  CHECK(graph["design"] == std::set<std::string>{"design"});
  CHECK(graph["machine"] == std::set<std::string>{"machine", "design"});
}

TEST_CASE("a stage of the validator includes no later stage") {
  std::string const prefix = "validator/";
  for (std::size_t stage = 0; stage < stages.size(); ++stage) {
    for (auto const& source : sources_of(prefix + stages[stage])) {
      for (auto const& included : includes_of(source)) {
        for (std::size_t later = stage + 1; later < stages.size(); ++later) {
          INFO(source.string() << " includes " << included);
          CHECK(included.rfind(prefix + stages[later] + "/", 0) != 0);
        }
      }
    }
  }
}

TEST_CASE("no folder is too full to be read at a glance") {
  std::size_t const most = 40;
  auto tops = tops_with_sources();
  tops.insert("tests");
  for (auto const& top : tops) {
    std::map<fs::path, std::size_t> counts;
    for (auto const& entry : fs::recursive_directory_iterator(fs::path(AXISC_SOURCE_DIR) / top)) {
      auto const path = entry.path().string();
      bool const is_ours = path.find("/tests/fuzz/corpus/") == std::string::npos &&
                           path.find("/node_modules/") == std::string::npos;
      if (entry.is_regular_file() && is_ours) ++counts[entry.path().parent_path()];
    }
    for (auto const& [folder, count] : counts) {
      if (folder.filename() == "rules") continue;
      INFO(folder.string());
      CHECK(count <= most);
    }
  }
}

TEST_CASE("a folder of the library includes none of the folders above it") {
  std::vector<std::string> const layers = {"environment", "asked",    "files",  "settings",
                                           "workspace",   "checking", "answers"};
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    for (auto const& source : sources_of("axisc/" + layers[layer])) {
      for (auto const& included : includes_of(source)) {
        for (std::size_t above = layer + 1; above < layers.size(); ++above) {
          INFO(source.string() << " includes " << included);
          CHECK_FALSE(included.starts_with("axisc/" + layers[above] + "/"));
        }
      }
    }
  }
}

TEST_CASE("the operating system is called in system/ alone") {
  std::set<std::string> const foreign = {"unistd.h",  "fcntl.h", "sys/stat.h", "sys/file.h", "sys/mman.h",
                                         "termios.h", "elf.h",   "link.h",     "dirent.h",   "windows.h"};
  std::regex const include("^\\s*#\\s*include\\s*<([^>]+)>");
  for (auto const& folder : tops_with_sources()) {
    if (folder == "system" || folder == "runtime") continue;
    for (auto const& source : sources_of(folder)) {
      std::ifstream in(source);
      for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (!std::regex_search(line, match, include)) continue;
        INFO(source.string() << ": " << line);
        CHECK_FALSE(foreign.contains(match[1].str()));
      }
    }
  }
}

TEST_CASE("names become paths in system/path.hpp alone") {
  // The constructor of std::filesystem::path does not take UTF-8 everywhere, and string() does not give it.
  std::regex const narrow(
      R"((\bpath[({][^)}&])|((\bpath|name|folder|file|relative|whole)\(?\)?(\.|->)(generic_)?string\(\))|u8path|\.native\(\))");
  for (auto const& folder : tops_with_sources()) {
    if (folder == "system" || folder == "runtime") continue;
    for (auto const& source : sources_of(folder)) {
      auto const text = axisc::test::file_contents(source);
      if (text.find("filesystem") == std::string::npos) continue;
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);) {
        INFO(source.string() << ": " << line);
        CHECK_FALSE(std::regex_search(line, narrow));
      }
    }
  }
}

TEST_CASE("sources differ between operating systems in system/ alone") {
  std::regex const conditional(
      R"(^\s*#\s*(if|ifdef|ifndef|elif).*\b(_WIN32|_WIN64|__linux__|__unix__|__APPLE__)\b)");
  for (auto const& folder : tops_with_sources()) {
    if (folder == "system" || folder == "runtime") continue;
    for (auto const& source : sources_of(folder)) {
      std::ifstream in(source);
      for (std::string line; std::getline(in, line);) {
        INFO(source.string() << ": " << line);
        CHECK_FALSE(std::regex_search(line, conditional));
      }
    }
  }
}

TEST_CASE("Spirit lives in grammar/ and nowhere else") {
  // Sources that parse nothing would pay for its compile time through a header of grammar/.
  std::set<std::string> with_spirit;
  for (auto const& source : sources_of("grammar")) {
    auto const text = axisc::test::file_contents(source);
    if (text.find("<boost/spirit") != std::string::npos)
      with_spirit.insert("grammar/" + source.filename().string());
  }
  CHECK_FALSE(with_spirit.empty());
  for (bool grown = true; grown;) {
    grown = false;
    for (auto const& source : sources_of("grammar")) {
      if (source.extension() == ".cpp") continue;
      for (auto const& included : includes_of(source)) {
        if (!with_spirit.contains(included)) continue;
        grown = with_spirit.insert("grammar/" + source.filename().string()).second || grown;
      }
    }
  }
  auto outside = tops_with_sources();
  outside.erase("grammar");
  for (std::string const folder : {"tests", "bench", "examples"}) outside.insert(folder);
  for (auto const& folder : outside) {
    for (auto const& source : sources_of(folder)) {
      std::ifstream in(source);
      for (std::string line; std::getline(in, line);) {
        INFO(source.string() << ": " << line);
        CHECK(line.find("#include <boost/spirit") != 0);
      }
      for (auto const& included : includes_of(source)) {
        INFO(source.string() << " includes " << included);
        CHECK_FALSE(with_spirit.contains(included));
      }
    }
  }
}

TEST_CASE("modules of the page and of the extension form no circle") {
  std::regex const import("from '(\\.[^']+)'");
  for (std::string const folder : {"web/src", "editor/clients/vscode/src"}) {
    fs::path const root = fs::path(AXISC_SOURCE_DIR) / folder;
    std::map<std::string, std::set<std::string>> reached;
    for (auto const& entry : fs::recursive_directory_iterator(root)) {
      if (entry.path().extension() != ".ts") continue;
      auto& imported = reached[entry.path().lexically_relative(root).generic_string()];
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (!std::regex_search(line, match, import)) continue;
        auto const module = entry.path().parent_path() / (match[1].str() + ".ts");
        imported.insert(module.lexically_normal().lexically_relative(root).generic_string());
      }
    }
    CHECK(reached.size() > 5);
    for (bool grown = true; grown;) {
      grown = false;
      for (auto& [module, imported] : reached) {
        for (auto const& next : std::set<std::string>(imported)) {
          auto const beyond = reached.find(next);
          if (beyond == reached.end()) continue;
          for (auto const& far : beyond->second) grown = imported.insert(far).second || grown;
        }
      }
    }
    for (auto const& [module, imported] : reached) {
      INFO(folder << "/" << module << " imports itself through others");
      CHECK_FALSE(imported.contains(module));
    }
  }
}
