// The outline of a list, and the symbols of the workspace.
#include "folders.hpp"
#include "support/catch.hpp"

#include <string>
#include <vector>

namespace symbols_test {

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

TEST_CASE("the workspace's symbols are lines that set what people look for") {
  auto const found = [](std::string const& query) {
    return Conversation()
        .open("/x.lis",
              "kopf.achs_nr 1\nkopf.log_achs_name X\ngetriebe[0].kv 1000\nfilter[1].type BANDSTOP\nEnde\n")
        .ask("workspace/symbol", "/x.lis", {{"query", query}})
        .results()[0];
  };
  auto const names = [&](std::string const& query) {
    std::vector<std::string> all;
    for (auto const& symbol : found(query)) all.push_back(symbol["name"]);
    return all;
  };
  using Names = std::vector<std::string>;
  CHECK(names("Kv") == Names{"X: getriebe[0].kv"});
  CHECK(found("Kv")[0]["location"]["range"]["start"] == Json({{"line", 2}, {"character", 0}}));
  CHECK(names("Kerbfilter") == Names{"X: filter[1].type (Kerbfilter)"});
  CHECK(names("Kerbfiltr") == Names{"X: filter[1].type (Kerbfiltr)"});
  CHECK(names("Umkehrspiel").empty());
}

}  // namespace symbols_test
