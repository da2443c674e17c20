// The layout of lists.
#include "support/catch.hpp"
#include "support/conversation.hpp"

namespace formatting_test {

using namespace axisc::test;

namespace {

Json asked(std::string const& method, std::string const& path, std::string const& text,
           Json const& params = Json::object()) {
  return Conversation().open(path, text).ask(method, path, params).results()[0];
}

}  // namespace

TEST_CASE("only lists are aligned") {
  for (auto const* const path : {"/machine.json", "/x.nc", "/x.xml"}) {
    INFO(path);
    CHECK(Conversation()
              .open(path, "a 1\nabc   2\n")
              .ask("textDocument/formatting", path)
              .results()[0]
              .empty());
  }
}

TEST_CASE("a range is formatted as the whole list would be") {
  std::string const text = "filter[0].order 2\nfilter[0].type    PT2\nfilter[0].fg_f0  3\n";
  Json const range = {{"start", {{"line", 1}, {"character", 0}}}, {"end", {{"line", 2}, {"character", 0}}}};
  auto const edits = asked("textDocument/rangeFormatting", "/x.lis", text, {{"range", range}});
  REQUIRE(edits.size() == 1);
  // In the column of the value below, which no other value needs to leave.
  CHECK(edits[0]["newText"] == "filter[0].type   PT2");
  CHECK(edits[0]["range"]["start"] == Json({{"line", 1}, {"character", 0}}));
}

}  // namespace formatting_test
