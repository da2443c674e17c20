#include "diagnostics/repository_path.hpp"

#include "support/catch.hpp"

#include <optional>
#include <string>

using namespace axisc;

TEST_CASE("paths from the root of the repository") {
  RepositoryPaths const paths{.root = "/home/anna/mill", .folder = "/home/anna/mill/axes"};
  CHECK(path_in_repository(paths, "x.lis") == "axes/x.lis");
  CHECK(path_in_repository(paths, "./a//b/../x.lis") == "axes/a/x.lis");
  CHECK(path_in_repository(paths, "../machine.json") == "machine.json");
  CHECK(path_in_repository(paths, "/home/anna/mill/..x.lis") == "..x.lis");
  CHECK(path_in_repository(paths, "../../x.lis") == std::nullopt);
  CHECK(path_in_repository(paths, "/tmp/x.lis") == std::nullopt);
  CHECK(path_in_repository(paths, "-") == std::nullopt);
  CHECK(shown_path(paths, "/tmp/x.lis") == "/tmp/x.lis");
  CHECK(shown_path(paths, "x.lis") == "axes/x.lis");
  CHECK(path_in_repository({.root = "/", .folder = "/tmp"}, "x.lis") == "tmp/x.lis");
}

TEST_CASE("paths with drives from the root of the repository") {
  RepositoryPaths const paths{.root = "C:/mill", .folder = "C:/mill/axes"};
  CHECK(path_in_repository(paths, "x.lis") == "axes/x.lis");
  CHECK(path_in_repository(paths, "C:/mill/machine.json") == "machine.json");
  CHECK(path_in_repository(paths, "c:/Mill/x.lis") == "x.lis");
  CHECK(path_in_repository(paths, "/mill/x.lis") == "x.lis");
  CHECK(path_in_repository(paths, "D:/mill/x.lis") == std::nullopt);
  CHECK(path_in_repository(paths, "//server/mill/x.lis") == std::nullopt);
  // Elsewhere a colon is a character of a name.
  CHECK(path_in_repository({.root = "/mill", .folder = "/mill"}, "C:/x.lis") == "C:/x.lis");
}

TEST_CASE("paths as URIs") {
  CHECK(as_uri("axes/x-1_a.lis~") == "axes/x-1_a.lis~");
  CHECK(as_uri("Achse 1/ü#?:%.lis") == "Achse%201/%C3%BC%23%3F%3A%25.lis");
  CHECK(as_uri("\xFC") == "%FC");
}
