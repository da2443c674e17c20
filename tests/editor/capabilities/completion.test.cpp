// Completion of names, values, references and commands.
#include "support/catch.hpp"
#include "support/conversation.hpp"

#include <algorithm>

namespace completion_test {

using namespace axisc::test;

namespace {

Json completed(std::string const& text) {
  auto const last = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  auto const column = static_cast<int>(text.size() - (text.rfind('\n') + 1));
  return Conversation()
      .open("/x.lis", text)
      .ask_at("textDocument/completion", "/x.lis", last, column)
      .results()[0];
}

Json item(Json const& items, std::string const& label) {
  auto const found =
      std::find_if(items.begin(), items.end(), [&](Json const& each) { return each["label"] == label; });
  return found == items.end() ? Json() : *found;
}

}  // namespace

TEST_CASE("names are completed segment by segment") {
  auto const families = completed("filter[0].order 1\nfil");
  CHECK_FALSE(item(families, "filter[0]").is_null());
  CHECK_FALSE(item(families, "filter[1]").is_null());
  CHECK(item(families, "filter[2]").is_null());
  CHECK_FALSE(item(families, "kenngr").is_null());
  CHECK(item(families, "filter[1]")["textEdit"]["range"]["start"] == Json({{"line", 1}, {"character", 0}}));
  // All entries are used.
  auto const full = completed("filter[0].a 1\nfilter[1].a 1\nfilter[2].a 1\nfilter");
  CHECK_FALSE(item(full, "filter[2]").is_null());
  CHECK(item(full, "filter[3]").is_null());
  auto const order = item(completed("  filter[0].or"), "order");
  CHECK(order["detail"].get<std::string>().find("P-AXIS-00140") == 0);
  CHECK_FALSE(order["documentation"].get<std::string>().empty());
  CHECK(order["textEdit"]["range"]["start"]["character"] == 12);
  CHECK(item(completed("filter[0].or"), "filter[0]").is_null());
  CHECK(completed("# fil").empty());
  CHECK(completed("kopf.achs_nr 1 ( fil").empty());
}

TEST_CASE("values of enumerations are completed with their meaning") {
  auto const types = completed("filter[0].type  B");
  CHECK(item(types, "BANDSTOP")["documentation"] == "band-stop (4)");
  CHECK(item(types, "BANDSTOP")["textEdit"]["range"]["start"]["character"] == 16);
  CHECK(item(completed("kenngr.achs_typ "), "ACHSTYP_SPINDEL")["detail"] == "4");
  auto const drives = completed("kenngr.antr_typ ");
  CHECK(item(drives, "2")["documentation"] == "SERCOS");
  CHECK(item(drives, "4")["preselect"] == true);
  CHECK(completed("kopx.unknown ").empty());
  CHECK(completed("filter[0].type BANDSTOP ").empty());
  for (auto const* const broken : {"filter[0 ", "filter[0][1].type ", ".. ", "[ ", "- ", "filter[0]. ",
                                   "filter[.", "filter[99999999999]."}) {
    INFO(broken);
    CHECK(completed(broken).is_array());
  }
}

TEST_CASE("references to parameters and defaults are completed") {
  auto const completed = [](std::string const& text) {
    return Conversation()
        .open("/x.lis", text)
        .ask_at("textDocument/completion", "/x.lis", 0, static_cast<int>(text.size()))
        .results()[0];
  };
  auto const labelled = [](Json const& items, std::string const& label) {
    return std::find_if(items.begin(), items.end(), [&](Json const& each) { return each["label"] == label; });
  };
  auto const references = completed("getriebe[0].dynamik.vb_max P-AXIS-002");
  auto const found = labelled(references, "P-AXIS-00212");
  REQUIRE(found != references.end());
  CHECK((*found)["detail"] == "getriebe[].dynamik.vb_max");
  CHECK((*found)["textEdit"]["range"]["start"]["character"] == 27);
  auto const standard = completed("filter[0].fg_f0 ");
  REQUIRE(labelled(standard, "30") != standard.end());
  CHECK((*labelled(standard, "30"))["detail"] == "default");
}

TEST_CASE("keywords of #FILTER are completed") {
  auto const completed = [](std::string const& text) {
    auto const items = Conversation()
                           .open("/x.nc", text)
                           .ask_at("textDocument/completion", "/x.nc", 0, static_cast<int>(text.size()))
                           .results()[0];
    std::vector<std::string> found;
    for (auto const& item : items) found.push_back(item["label"]);
    return found;
  };
  CHECK(completed("#F") == std::vector<std::string>{"#FILTER"});
  CHECK(completed("N10 #FILTER ") == std::vector<std::string>{"ON", "OFF", "["});
  auto const keywords = completed("#FILTER ON [OR");
  CHECK(std::count(keywords.begin(), keywords.end(), "ORDER=") == 1);
  CHECK(std::count(keywords.begin(), keywords.end(), "HSC") == 1);
  CHECK(completed("G01 X").empty());
}

TEST_CASE("completions say what they mean when they are asked") {
  Json const able = {{"textDocument",
                      {{"completion",
                        {{"completionItem",
                          {{"resolveSupport", {{"properties", {"documentation"}}}},
                           {"documentationFormat", {"markdown", "plaintext"}}}}}}}}};
  auto const item = [](Json const& items, std::string const& label) {
    auto const found = std::find_if(items.begin(), items.end(),
                                    [&label](Json const& each) { return each["label"] == label; });
    REQUIRE(found != items.end());
    return *found;
  };
  std::string const text = "filter[0].o\nfilter[0].order P-AXIS-0001\n";
  auto const lists = Conversation("utf-8", able)
                         .open("/x.lis", text)
                         .ask_at("textDocument/completion", "/x.lis", 0, 11)
                         .ask_at("textDocument/completion", "/x.lis", 1, 27)
                         .results();
  auto const order = item(lists[0], "order");
  auto const number = item(lists[1], "P-AXIS-00016");
  CHECK_FALSE(order.contains("documentation"));
  CHECK_FALSE(number.contains("documentation"));
  auto const resolved = Conversation("utf-8", able)
                            .open("/x.lis", text)
                            .ask("completionItem/resolve", "/x.lis", order)
                            .ask("completionItem/resolve", "/x.lis", number)
                            .ask("completionItem/resolve", "/x.lis", {{"label", "LOWPASS"}})
                            .results();
  CHECK(resolved[0]["documentation"]["kind"] == "markdown");
  CHECK(resolved[0]["documentation"]["value"].get<std::string>().starts_with("# filter[].order "));
  CHECK(resolved[0]["textEdit"] == order["textEdit"]);
  CHECK(resolved[1]["documentation"]["value"].get<std::string>().starts_with("# kopf.achs_nr "));
  CHECK_FALSE(resolved[2].contains("documentation"));
  // Who cannot ask is told at once.
  auto const plain =
      Conversation().open("/x.lis", text).ask_at("textDocument/completion", "/x.lis", 0, 11).results()[0];
  CHECK(item(plain, "order")["documentation"].is_string());
}

}  // namespace completion_test
