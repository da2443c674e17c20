// The outline of a list, and the symbols of the workspace.
#include "folders.hpp"
#include "support/catch.hpp"

using namespace axisc::test;

TEST_CASE("symbols are the families of a list") {
  auto const symbols =
      Conversation()
          .open("/x.lis", "kopf.achs_nr 1\nfilter[0].type BANDSTOP\nfilter[0].fg_f0 42\nEnde\n")
          .ask("textDocument/documentSymbol", "/x.lis")
          .results()[0];
  REQUIRE(symbols.size() == 2);
  CHECK(symbols[1]["name"] == "filter[0]");
  CHECK(symbols[1]["detail"] == "BANDSTOP 42 Hz");
  CHECK(symbols[1]["range"]["end"] == Json({{"line", 2}, {"character", 18}}));
  REQUIRE(symbols[1]["children"].size() == 2);
  CHECK(symbols[1]["children"][1]["name"] == "fg_f0");
}

TEST_CASE("the workspace's symbols are axes and channels") {
  auto const& folder = folder_of_two_axes();
  auto const found = [&](std::string const& query) {
    return Conversation()
        .open(folder / "all.lis", folder.read("all.lis"))
        .ask("workspace/symbol", folder / "all.lis", {{"query", query}})
        .results()[0];
  };
  CHECK(found("").size() == 2);
  REQUIRE(found("y").size() == 1);
  CHECK(found("y")[0]["location"]["uri"] == "file://" + (folder / "y.lis"));
}
