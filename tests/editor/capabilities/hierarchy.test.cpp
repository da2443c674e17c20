// The hierarchy of values: from a parameter to all places that set it.
#include "support/catch.hpp"
#include "support/conversation.hpp"
#include "support/temporary_folder.hpp"

#include <string>
#include <vector>

namespace hierarchy_test {

using namespace axisc::test;

namespace {

TemporaryFolder const& machine_folder() {
  static TemporaryFolder const folder;
  folder.write("machine.json",
               R"({"cycle_time_us": 1000, "default_list": "all.lis",
                   "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}],
                   "groups": [{"name": "K1", "axes": ["X", "Y"]}]})");
  folder.write("all.lis", "filter[0].fg_f0  42\nfilter[0].order 4\n");
  folder.write("x.lis", "kopf.achs_nr 1\nfilter[0].fg_f0 17\nfilter[0].fg_f0 18\n# P-AXIS-00067\n");
  folder.write("y.lis", "kopf.achs_nr 2\nfilter[0].fg_f0 19\n");
  return folder;
}

Json items_at(std::string const& name, int line, int character) {
  auto const path = machine_folder() / name;
  return Conversation()
      .open(path, machine_folder().read(name))
      .ask_at("textDocument/prepareTypeHierarchy", path, line, character)
      .results()[0];
}

std::vector<std::string> details(Json const& items) {
  std::vector<std::string> found;
  for (auto const& item : items) found.push_back(item["detail"]);
  return found;
}

/// Of the parameter at a place: what it overrides, or what overrides it.
std::vector<std::string> related(std::string const& method, Json const& item) {
  auto const path = machine_folder() / "x.lis";
  return details(Conversation()
                     .open(path, machine_folder().read("x.lis"))
                     .open(machine_folder() / "all.lis", machine_folder().read("all.lis"))
                     .ask(method, path, {{"item", item}})
                     .results()[0]);
}

using Details = std::vector<std::string>;

}  // namespace

TEST_CASE("a line's value overrides those that the control reads before it, and the default last") {
  auto const items = items_at("x.lis", 2, 3);
  REQUIRE(items.size() == 1);
  CHECK(items[0]["name"] == "filter[0].fg_f0");
  CHECK(items[0]["detail"] == "18 in x.lis");
  CHECK(items[0]["selectionRange"]["start"] == Json({{"line", 2}, {"character", 0}}));
  CHECK(items[0]["selectionRange"]["end"] == Json({{"line", 2}, {"character", 15}}));
  CHECK(items[0]["range"]["end"] == Json({{"line", 2}, {"character", 18}}));
  CHECK(related("typeHierarchy/supertypes", items[0]) ==
        Details{"42 in all.lis", "17 in x.lis", "30, the default"});
  CHECK(related("typeHierarchy/subtypes", items[0]).empty());
  CHECK(related("typeHierarchy/subtypes", items_at("x.lis", 1, 16)[0]) == Details{"18 in x.lis"});
}

TEST_CASE("a default list's value is overridden by all axes") {
  auto const items = items_at("all.lis", 0, 0);
  REQUIRE(items.size() == 1);
  CHECK(related("typeHierarchy/supertypes", items[0]) == Details{"30, the default"});
  CHECK(related("typeHierarchy/subtypes", items[0]) == Details{"17 in x.lis", "18 in x.lis", "19 in y.lis"});
}

TEST_CASE("the default leads to all lines that set the parameter") {
  auto const path = machine_folder() / "x.lis";
  auto const above = Conversation()
                         .open(path, machine_folder().read("x.lis"))
                         .ask("typeHierarchy/supertypes", path, {{"item", items_at("x.lis", 2, 3)[0]}})
                         .results()[0];
  REQUIRE(above.size() == 3);
  CHECK(related("typeHierarchy/supertypes", above[2]).empty());
  CHECK(related("typeHierarchy/subtypes", above[2]) ==
        Details{"42 in all.lis", "17 in x.lis", "18 in x.lis"});
}

TEST_CASE("a parameter's number in a comment leads to the lines that set it") {
  CHECK(details(items_at("x.lis", 3, 5)) == Details{"42 in all.lis", "17 in x.lis", "18 in x.lis"});
  CHECK(items_at("x.lis", 3, 0).is_null());
  auto const alone = Conversation()
                         .open("/x.lis", "# P-AXIS-00067\nunknown 1\n")
                         .ask_at("textDocument/prepareTypeHierarchy", "/x.lis", 0, 5)
                         .ask_at("textDocument/prepareTypeHierarchy", "/x.lis", 1, 2)
                         .results();
  REQUIRE(alone[0].size() >= 1);
  CHECK(alone[0][0]["detail"] == "30, the default");
  CHECK(alone[1].is_null());
}

TEST_CASE("an item of a document that was closed is refused") {
  auto item = items_at("x.lis", 2, 3)[0];
  item["data"]["document"] = "file:///closed.lis";
  auto const results = Conversation()
                           .open("/x.lis", "")
                           .ask("typeHierarchy/supertypes", "/x.lis", {{"item", item}})
                           .ask("typeHierarchy/subtypes", "/x.lis", {{"item", {{"data", 5}}}})
                           .results();
  CHECK(results[0]["error"]["code"] == -32602);
  CHECK(results[1]["error"]["code"] == -32602);
}

}  // namespace hierarchy_test
