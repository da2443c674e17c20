// File names in URIs, of either operating system.
#include "editor/uri.hpp"

#include "support/catch.hpp"

using namespace axisc::editor;

TEST_CASE("file URIs are paths") {
  CHECK(path_of("file:///a/b%20c/%C3%BC.lis") == "/a/b c/\xC3\xBC.lis");
  CHECK(path_of("file://localhost/a.lis") == "/a.lis");
  CHECK(path_of("file://server/Freigabe%201/x.lis") == "//server/Freigabe 1/x.lis");
  CHECK(path_of("file://server").empty());
  CHECK(path_of("file:///c%3A/listen/x.lis") == "c:/listen/x.lis");
  CHECK(path_of("file:///C:/listen/x.lis") == "C:/listen/x.lis");
  CHECK(path_of("untitled:Untitled-1") == "untitled:Untitled-1");
  CHECK(path_of("file:///a%") == "/a%");
  CHECK(path_of("file:///a%zz") == "/a%zz");
  CHECK(path_of("file://").empty());
}

TEST_CASE("paths are file URIs") {
  CHECK(uri_of("/a/b c/\xC3\xBC.lis") == "file:///a/b%20c/%C3%BC.lis");
  CHECK(uri_of("C:/listen/x.lis") == "file:///C%3A/listen/x.lis");
  CHECK(uri_of("//server/Freigabe 1/x.lis") == "file://server/Freigabe%201/x.lis");
}
