// Hover, completion, definition, links and symbols of the language server.
#include "cli/editor/conversation.hpp"
#include "cli/program.hpp"
#include "cli/temporary_folder.hpp"
#include "support/catch.hpp"

#include <algorithm>

using namespace axisc::test;

namespace {

Json hover(std::string const& path, std::string const& text, int line, int character) {
  return Conversation().open(path, text).ask_at("textDocument/hover", path, line, character).results()[0];
}

std::string hover_text(std::string const& path, std::string const& text, int line, int character) {
  auto const shown = hover(path, text, line, character);
  return shown.is_null() ? "" : shown["contents"]["value"].get<std::string>();
}

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

bool contains(std::string const& text, std::string const& piece) {
  INFO(text);
  CHECK(text.find(piece) != std::string::npos);
  return text.find(piece) != std::string::npos;
}

TemporaryFolder const& machine_folder() {
  static TemporaryFolder const folder;
  folder.write("machine.json", R"({"default_list": "all.lis", "axes": [{"name": "X", "list": "x.lis"}]})");
  folder.write("all.lis", "# all\nfilter[0].fg_f0  42\nfilter[0].type BANDSTOP\n");
  folder.write("x.lis", "filter[0].order 2\nfilter[0].fg_f0  17\nfilter[0].fg_f0  18\n");
  return folder;
}

}  // namespace

TEST_CASE("hovering over a name shows the page that explain prints") {
  auto const page = run_axisc({"explain", "filter[0].order", "--lang", "en"}).out;
  auto const shown = hover("/x.lis", "# \xC3\xBC\nfilter[0].order  2\n", 1, 3);
  CHECK(shown["contents"]["kind"] == "markdown");
  contains(shown["contents"]["value"], page);
  CHECK(shown["range"]["start"] == Json({{"line", 1}, {"character", 0}}));
  CHECK(shown["range"]["end"] == Json({{"line", 1}, {"character", 15}}));
  CHECK(hover("/x.lis", "# comment\n", 0, 4).is_null());
  CHECK(hover("/x.lis", "kopx.unknown 1\n", 0, 4).is_null());
  CHECK(hover("/x.lis", "", 0, 0).is_null());
}

TEST_CASE("hovering over a name of each kind of list shows its page") {
  for (auto const* const path :
       {"samples/controller/listen/hochlauf.lis", "samples/controller/listen/sda_mds1.lis",
        "samples/controller/listen/werkz_d1.lis", "samples/controller/listen/achskw1.lis",
        "samples/controller/listen/hand_mds.lis", "samples/controller/listen/rtconf.lis",
        "samples/controller/listen/nullp_d1.lis"}) {
    INFO(path);
    auto const text = text_of(source_path(path));
    int line = 0;
    std::size_t shown = 0;
    for (std::size_t begin = 0; begin < text.size() && shown == 0;
         begin = text.find('\n', begin) + 1, ++line) {
      if (text.find_first_of("#\r\n/", begin) == begin) continue;
      shown = hover_text(source_path(path), text, line, 1).size();
    }
    CHECK(shown > 20);
  }
}

TEST_CASE("hovering over a value shows its quantity and its meaning") {
  contains(hover_text("/x.lis", "filter[0].time_constant 20000\n", 0, 26), "20000 = 20 ms");
  contains(hover_text("/x.lis", "filter[0].fg_f0 42.5\n", 0, 17), "42.5 Hz");
  contains(hover_text("/x.lis", "filter[0].type  BANDSTOP\n", 0, 18), "BANDSTOP: band-stop");
  contains(hover_text("/x.lis", "kenngr.antr_typ 2\n", 0, 16), "2: SERCOS");
  contains(hover_text("/x.lis", "filter[0].type  4\n", 0, 16), "4: band-stop");
}

TEST_CASE("hovering over the number of a parameter shows its page anywhere") {
  auto const page = run_axisc({"explain", "P-AXIS-00140", "--lang", "en"}).out;
  contains(hover_text("/x.lis", "kopf.achs_nr 1 ( see P-AXIS-00140 : order\n", 0, 25), page);
  contains(hover_text("/x.lis", "# P-AXIS-00140\n", 0, 2), page);
  contains(hover_text("/x.nc", "N10 ( P-AXIS-00140\n", 0, 10), page);
  auto const channel = run_axisc({"explain", "P-CHAN-00035", "--lang", "en"}).out;
  contains(hover_text("/x.lis", "# P-CHAN-00035\n", 0, 14), channel);
  CHECK(hover("/x.lis", "# P-XXXX-00035 P-AXIS-99999999\n", 0, 5).is_null());
  CHECK(hover("/x.lis", "# P-XXXX-00035 P-AXIS-99999999\n", 0, 20).is_null());
}

TEST_CASE("hovering over a name says which value is in effect and which list it comes from") {
  auto const list = machine_folder() / "x.lis";
  auto const text = text_of(list);
  contains(hover_text(list, text, 1, 3), "In effect: 18 Hz, from x.lis, line 3.");
  CHECK(hover_text(list, text, 2, 3).find("In effect") == std::string::npos);
}

TEST_CASE("clients without Markdown get plain text") {
  auto const results =
      Conversation("utf-16", {{"textDocument", {{"hover", {{"contentFormat", {"plaintext"}}}}}}})
          .open("/x.lis", "filter[0].order 2\n")
          .ask_at("textDocument/hover", "/x.lis", 0, 2)
          .results();
  CHECK(results[0]["contents"]["kind"] == "plaintext");
}

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

TEST_CASE("a name leads to the lines that set it in the order in which the control reads them") {
  auto const list = machine_folder() / "x.lis";
  auto const results = Conversation()
                           .open(list)
                           .ask_at("textDocument/definition", list, 1, 4)
                           .ask_at("textDocument/definition", list, 0, 30)
                           .results();
  REQUIRE(results[0].size() == 3);
  CHECK(results[0][0]["uri"] == "file://" + (machine_folder() / "all.lis"));
  CHECK(results[0][0]["range"]["start"]["line"] == 1);
  CHECK(results[0][1]["range"]["start"]["line"] == 1);
  CHECK(results[0][2]["range"]["start"]["line"] == 2);
  CHECK(results[0][2]["uri"] == "file://" + list);
  CHECK(results[1].empty());
}

TEST_CASE("the names of files lead to the files") {
  auto const machine = machine_folder() / "machine.json";
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
  CHECK(results[0][0]["target"] == "file://" + (machine_folder() / "all.lis"));
  CHECK(results[1].size() >= 15);
  CHECK(results[1][0]["target"].get<std::string>().ends_with(".lis"));
  CHECK(results[2]["uri"] == "file://" + (machine_folder() / "all.lis"));
  CHECK(results[3].contains("error"));
}

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
