// The outline of a list, and the symbols of the workspace.
#include "support/catch.hpp"
#include "support/conversation.hpp"
#include "support/temporary_folder.hpp"

using namespace axisc::test;

namespace {

TemporaryFolder const& machine_folder() {
  static TemporaryFolder const folder;
  folder.write("machine.json",
               R"({"cycle_time_us": 1000, "default_list": "all.lis",
                   "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}]})");
  folder.write("all.lis", "getriebe[0].dynamik.vb_max 500000\nfilter[0].fg_f0  42\n");
  folder.write("x.lis",
               "kopf.achs_nr 1\nfilter[0].enable 1\nfilter[0].order 2\nfilter[0].prototype "
               "BUTTERWORTH\nfilter[0].type LOWPASS\nfilter[0].fg_f0 17\n");
  folder.write("y.lis", "kopf.achs_nr 2\n");
  return folder;
}

}  // namespace

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
  auto const& folder = machine_folder();
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
