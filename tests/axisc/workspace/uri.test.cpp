// File names in URIs, of either operating system.
#include "axisc/workspace/uri.hpp"

#include "support/catch.hpp"

using namespace axisc;

TEST_CASE("file URIs are paths") {
  CHECK(path_of("file:///a/b%20c/%C3%BC.lis") == "/a/b c/\xC3\xBC.lis");
  CHECK(path_of("file://host/a.lis", FileNames::posix) == "/a.lis");
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
}

TEST_CASE("on Windows, the host of a URI is that of a share") {
  auto const names = FileNames::windows;
  auto const path = GENERATE("//server/share/x.lis", "//server/Listen%20alt/\xC3\xBC.lis", "C:/listen/x.lis");
  CHECK(path_of(uri_of(path, names), names) == path);
  CHECK(path_of("file://server/share/b%20c/x.lis", names) == "//server/share/b c/x.lis");
  CHECK(path_of("file://localhost/c:/x.lis", names) == "c:/x.lis");
  CHECK(path_of("file:///c%3A/x.lis", names) == "c:/x.lis");
  CHECK(uri_of("//server/share/b c/x.lis", names) == "file://server/share/b%20c/x.lis");
  CHECK(uri_of("//server/share/x.lis", FileNames::posix) == "file:////server/share/x.lis");
}
