// Where the lists lie that a start-up list names.
#include "configuration/list_search.hpp"

#include "support/catch.hpp"

#include <set>

namespace {

using namespace axisc;

/// Empty files at these paths; folders are what the paths say.
class Tree final : public configuration::Files {
 public:
  explicit Tree(std::set<std::string> paths) : paths_(std::move(paths)) {}

  [[nodiscard]] std::variant<std::string, configuration::FileError> read(std::string const& path) override {
    if (!is_file(path)) return configuration::FileError::not_found;
    return std::string();
  }
  [[nodiscard]] bool is_file(std::string const& path) override { return paths_.contains(normal(path)); }
  [[nodiscard]] std::vector<std::string> names_in(std::string const& folder) override {
    std::string const own = normal(folder + "x");
    std::string const prefix = own.substr(0, own.size() - 1);
    std::set<std::string> names;
    for (std::string const& path : paths_) {
      if (path.starts_with(prefix))
        names.insert(path.substr(prefix.size(), path.find('/', prefix.size()) - prefix.size()));
    }
    return {names.begin(), names.end()};
  }
  [[nodiscard]] bool is_same(std::string const& one, std::string const& other) override {
    return normal(one) == normal(other);
  }

 private:
  /// Seen from /cfg/listen/.
  static std::string normal(std::string const& path) {
    std::filesystem::path const whole = path.starts_with('/') ? path : "/cfg/listen/" + path;
    std::string normal = whole.lexically_normal().generic_string();
    if (normal.size() > 1 && normal.ends_with('/')) normal.pop_back();
    return normal;
  }

  std::set<std::string> paths_;
};

std::string found(Tree tree, std::string const& start_up, std::string const& named) {
  auto const list = configuration::find_list(tree, start_up, named);
  if (!list) return "none";
  return (list->moved ? "moved " : "") + list->path + (list->other ? " or " + *list->other : "");
}

}  // namespace

TEST_CASE("a list is found from the start-up list's folder, and from every folder above it") {
  Tree const tree({"/cfg/listen/hochlauf.lis", "/cfg/listen/x.lis", "/cfg/deep/y.lis"});
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "x.lis") == "/cfg/listen/x.lis");
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "./listen/x.lis") == "/cfg/listen/x.lis");
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "deep/y.lis") == "/cfg/deep/y.lis");
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "cfg/deep/y.lis") == "/cfg/deep/y.lis");
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "../deep/y.lis") == "/cfg/listen/../deep/y.lis");
}

TEST_CASE("in the working folder a list beside the start-up list keeps its short name") {
  Tree const tree({"/cfg/listen/hochlauf.lis", "/cfg/listen/x.lis", "/cfg/deep/y.lis"});
  CHECK(found(tree, "hochlauf.lis", "./listen/x.lis") == "x.lis");
  CHECK(found(tree, "hochlauf.lis", "deep/y.lis") == "../deep/y.lis");
}

TEST_CASE("backslashes, letter case and the root of the kernel do not matter") {
  Tree const tree({"/cfg/listen/hochlauf.lis", "/cfg/listen/AchsMds1.lis"});
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", ".\\LISTEN\\achsmds1.LIS") == "/cfg/listen/AchsMds1.lis");
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "CncKernelRootDir/listen/AchsMds1.lis") ==
        "/cfg/listen/AchsMds1.lis");
}

TEST_CASE(
    "where no folder of the path is there, a file of that name beside the start-up list is the last resort") {
  Tree const tree({"/cfg/listen/hochlauf.lis", "/cfg/listen/x.lis"});
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "/opt/cnc/lists/x.lis") == "moved /cfg/listen/x.lis");
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "lists/x.lis") == "moved /cfg/listen/x.lis");
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "lists/z.lis") == "none");
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "") == "none");
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "..") == "none");
}

TEST_CASE("a folder that was copied by another name is found around the start-up list") {
  std::string const start_up = "/cfg/Kunde4711/SoE/hochlauf.lis";
  Tree const tree({start_up, "/cfg/Kunde4711/SoE/achsmds1.lis", "/cfg/Kunde4711/nullp_d1.lis"});
  CHECK(found(tree, start_up, "./listen/SoE/achsmds1.lis") == "moved /cfg/Kunde4711/SoE/achsmds1.lis");
  CHECK(found(tree, start_up, ".\\LISTEN\\soe\\ACHSMDS1.lis") == "moved /cfg/Kunde4711/SoE/achsmds1.lis");
  CHECK(found(tree, start_up, "./listen/nullp_d1.lis") == "moved /cfg/Kunde4711/nullp_d1.lis");
  CHECK(found(tree, start_up, "C:\\CNC\\listen\\SoE\\achsmds1.lis") ==
        "moved /cfg/Kunde4711/SoE/achsmds1.lis");
  CHECK(found(tree, start_up, "./listen/SoE/achsmds2.lis") == "none");
}

TEST_CASE("a list that is not in its folder is missing, whatever lies elsewhere") {
  Tree const tree(
      {"/cfg/listen/SoE/hochlauf.lis", "/cfg/listen/SoE/y.lis", "/cfg/listen/x.lis", "/cfg/y.lis"});
  CHECK(found(tree, "/cfg/listen/SoE/hochlauf.lis", "./listen/y.lis") == "none");
  CHECK(found(tree, "/cfg/listen/SoE/hochlauf.lis", "./listen/SoE/x.lis") == "none");
}

TEST_CASE("where two files may be meant, the second is named as well") {
  SECTION("a copy beside the original") {
    Tree const tree({"/cfg/listen/x.lis", "/cfg/Kunde4711/x.lis", "/cfg/Kunde4711/hochlauf.lis"});
    CHECK(found(tree, "/cfg/Kunde4711/hochlauf.lis", "./listen/x.lis") ==
          "/cfg/listen/x.lis or /cfg/Kunde4711/x.lis");
  }
  SECTION("a copy that has the name in two of its folders") {
    Tree const tree({"/cfg/Kunde4711/SoE/hochlauf.lis", "/cfg/Kunde4711/SoE/x.lis", "/cfg/Kunde4711/x.lis"});
    CHECK(found(tree, "/cfg/Kunde4711/SoE/hochlauf.lis", "./listen/x.lis") ==
          "moved /cfg/Kunde4711/SoE/x.lis or /cfg/Kunde4711/x.lis");
  }
  SECTION("not in the original itself") {
    Tree const tree({"/cfg/listen/SoE/hochlauf.lis", "/cfg/listen/SoE/x.lis", "/cfg/listen/x.lis"});
    CHECK(found(tree, "/cfg/listen/SoE/hochlauf.lis", "./listen/x.lis") == "/cfg/listen/x.lis");
  }
}
