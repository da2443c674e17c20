// What stands in folders, and long paths of Windows.
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "system/folder.hpp"
#include "system/long_path.hpp"

#include <filesystem>

using namespace axisc::system;
using axisc::test::TemporaryFolder;

TEST_CASE("a folder's entries come in the order of their names, links as such") {
  TemporaryFolder const folder;
  folder.write("b.lis", "");
  folder.write("B.lis", "");
  folder.write("\xC3\xA4.lis", "");
  std::filesystem::create_directory(folder / "a");
  std::filesystem::create_symlink("nowhere", folder / "c");
  auto const found = entries_of(folder.path());
  auto const& entries = std::get<std::vector<FolderEntry>>(found);
  REQUIRE(entries.size() == 5);
  CHECK((entries[0].name == "B.lis" && entries[0].kind == FileKind::regular));
  CHECK((entries[1].name == "a" && entries[1].kind == FileKind::folder));
  CHECK(entries[2].name == "b.lis");
  CHECK((entries[3].name == "c" && entries[3].kind == FileKind::link));
  CHECK(entries[4].name == "\xC3\xA4.lis");
  CHECK(std::get<Error>(entries_of(folder / "missing")).refusal == Refusal::not_found);
  CHECK(std::holds_alternative<Error>(entries_of(folder / "b.lis")));
}

TEST_CASE("the kind of a name is that of the file, of a link where links are refused") {
  TemporaryFolder const folder;
  folder.write("a.lis", "");
  std::filesystem::create_symlink("a.lis", folder / "link");
  std::filesystem::create_symlink("nowhere", folder / "dangling");
  CHECK(kind_of(folder / "link") == FileKind::regular);
  CHECK(kind_of(folder / "link", Link::refused) == FileKind::link);
  CHECK(kind_of(folder / "dangling") == std::nullopt);
  CHECK(kind_of(folder / "dangling", Link::refused) == FileKind::link);
  CHECK(kind_of(folder.path()) == FileKind::folder);
}

TEST_CASE("names in folders") {
  CHECK(name_in("", "x.lis") == "x.lis");
  CHECK(name_in("a", "x.lis") == "a/x.lis");
  CHECK(name_in("a/", "x.lis") == "a/x.lis");
  CHECK(name_in("/", "x.lis") == "/x.lis");
}

TEST_CASE("long paths of Windows") {
  CHECK(extended_path("C:/lists/x.lis") == R"(\\?\C:\lists\x.lis)");
  CHECK(extended_path(R"(C:\lists\x.lis)") == R"(\\?\C:\lists\x.lis)");
  CHECK(extended_path("//server/share/x.lis") == R"(\\?\UNC\server\share\x.lis)");
  CHECK(extended_path(R"(\\?\C:\x.lis)") == R"(\\?\C:\x.lis)");
  CHECK(extended_path(R"(\\.\NUL)") == R"(\\.\NUL)");
}
