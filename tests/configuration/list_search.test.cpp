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
    return whole.lexically_normal().generic_string();
  }

  std::set<std::string> paths_;
};

std::string found(Tree tree, std::string const& start_up, std::string const& named) {
  auto const list = configuration::find_list(tree, start_up, named);
  return list ? (list->beside ? "beside " : "") + list->path : "none";
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

TEST_CASE("a file of that name beside the start-up list is the last resort") {
  Tree const tree({"/cfg/listen/hochlauf.lis", "/cfg/listen/x.lis"});
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "/opt/cnc/lists/x.lis") == "beside /cfg/listen/x.lis");
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "lists/x.lis") == "beside /cfg/listen/x.lis");
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "lists/z.lis") == "none");
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "") == "none");
  CHECK(found(tree, "/cfg/listen/hochlauf.lis", "..") == "none");
}
