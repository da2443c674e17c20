// Definitions, references, links, and why names cannot be renamed.
#include "folders.hpp"
#include "support/catch.hpp"

#include <algorithm>

namespace navigation_test {

using namespace axisc::test;

namespace {

TemporaryFolder const& group_folder() {
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

}  // namespace

TEST_CASE("a name leads to the lines that set it in the order in which the control reads them") {
  auto const list = folder_of_one_axis() / "x.lis";
  auto const results = Conversation()
                           .open(list)
                           .ask_at("textDocument/definition", list, 1, 4)
                           .ask_at("textDocument/definition", list, 0, 30)
                           .results();
  REQUIRE(results[0].size() == 3);
  CHECK(results[0][0]["uri"] == "file://" + (folder_of_one_axis() / "all.lis"));
  CHECK(results[0][0]["range"]["start"]["line"] == 1);
  CHECK(results[0][1]["range"]["start"]["line"] == 1);
  CHECK(results[0][2]["range"]["start"]["line"] == 2);
  CHECK(results[0][2]["uri"] == "file://" + list);
  CHECK(results[1].empty());
}

TEST_CASE("the names of files lead to the files") {
  auto const machine = folder_of_one_axis() / "machine.json";
  auto const start_up = source_path("samples/controller/listen/hochlauf.lis");
  auto const results = Conversation()
                           .open(machine)
                           .open(start_up)
                           .ask("textDocument/documentLink", machine)
                           .ask("textDocument/documentLink", start_up)
                           .ask_at("textDocument/definition", machine, 0, 20)
                           .ask("textDocument/documentLink", source_path("samples/mill/x.lis"))
                           .results();
  REQUIRE(results[0].size() == 2);
  CHECK(results[0][0]["target"] == "file://" + (folder_of_one_axis() / "all.lis"));
  CHECK(results[1].size() >= 15);
  CHECK(results[1][0]["target"].get<std::string>().ends_with(".lis"));
  CHECK(results[2]["uri"] == "file://" + (folder_of_one_axis() / "all.lis"));
  CHECK(results[3].contains("error"));
}

TEST_CASE("the names of channel lists in a machine file lead to them") {
  TemporaryFolder const folder;
  folder.write("m.json", R"({"default_channel_list": "all.lis", "axes": [{"name": "X", "list": "x.lis"}],
                             "groups": [{"axes": ["X"], "channel_list": "sda.lis"}]})");
  for (std::string const name : {"all.lis", "x.lis", "sda.lis"}) folder.write(name, "\n");
  auto const machine = folder / "m.json";
  auto const links = Conversation().open(machine).ask("textDocument/documentLink", machine).results()[0];
  REQUIRE(links.size() == 3);
  CHECK(links[0]["target"] == "file://" + (folder / "all.lis"));
  CHECK(links[2]["target"] == "file://" + (folder / "sda.lis"));
}

TEST_CASE("references of a default list are all lists of the machine that set the parameter") {
  auto const& folder = folder_of_two_axes();
  auto const found = Conversation()
                         .open(folder / "all.lis", folder.read("all.lis"))
                         .ask_at("textDocument/references", folder / "all.lis", 1, 3)
                         .ask_at("textDocument/definition", folder / "all.lis", 1, 3)
                         .results();
  REQUIRE(found[0].size() == 2);
  CHECK(found[0][0]["uri"] == "file://" + (folder / "all.lis"));
  CHECK(found[0][1]["uri"] == "file://" + (folder / "x.lis"));
  CHECK(found[0][1]["range"]["start"]["line"] == 5);
  CHECK(found[1].size() == 1);
}

TEST_CASE("names cannot be renamed, and the server says why") {
  auto const answer = asked("textDocument/rename", "/x.lis", "filter[0].order 2\n",
                            {{"position", {{"line", 0}, {"character", 1}}}, {"newName", "a"}});
  CHECK(answer["error"]["code"] == -32803);
  CHECK(answer["error"]["message"].get<std::string>().find("belong to the control") != std::string::npos);
  // Before the user has typed another name.
  auto const prepared = asked("textDocument/prepareRename", "/x.lis", "filter[0].order 2\n",
                              {{"position", {{"line", 0}, {"character", 1}}}});
  CHECK(prepared["error"] == answer["error"]);
}

TEST_CASE("an axis that a channel or a machine file names leads to its list") {
  auto const path = group_folder() / "machine.json";
  auto const text = group_folder().read("machine.json");
  auto const line = text.substr(text.rfind('\n') + 1);
  auto const at = static_cast<int>(line.find("\"Y\"")) + 1;
  auto const found =
      Conversation().open(path, text).ask_at("textDocument/definition", path, 2, at).results()[0];
  CHECK(found["uri"] == "file://" + (group_folder() / "y.lis"));

  auto const channel = source_path("samples/controller/listen/sda_mds1.lis");
  auto const lines = text_of(channel);
  auto const name = lines.find("gruppe[0].achse[1].log_achs_nr");
  REQUIRE(name != std::string::npos);
  auto const end = lines.find('\n', name);
  auto const number = lines.find_last_of("0123456789", lines.find_first_of("(#\n", name));
  REQUIRE(number < end);
  auto const row =
      static_cast<int>(std::count(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(name), '\n'));
  auto const begin = name == 0 ? 0 : lines.rfind('\n', name) + 1;
  auto const axis = Conversation()
                        .open(channel)
                        .ask_at("textDocument/definition", channel, row, static_cast<int>(number - begin))
                        .results()[0];
  REQUIRE(axis.is_object());
  auto const list = text_of(axis["uri"].get<std::string>().substr(std::string("file://").size()));
  CHECK(list.find("kopf.achs_nr") != std::string::npos);
}

}  // namespace navigation_test
