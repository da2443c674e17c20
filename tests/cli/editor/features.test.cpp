// Hints, tokens, lenses, folding, references, formatting of a range and pages of the language server.
#include "cli/editor/conversation.hpp"
#include "cli/program.hpp"
#include "cli/temporary_folder.hpp"
#include "support/catch.hpp"

#include <algorithm>

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

Json const whole_range = {{"start", {{"line", 0}, {"character", 0}}},
                          {"end", {{"line", 100}, {"character", 0}}}};

Json asked(std::string const& method, std::string const& path, std::string const& text,
           Json const& params = Json::object()) {
  return Conversation().open(path, text).ask(method, path, params).results()[0];
}

std::vector<std::string> labels(Json const& hints) {
  std::vector<std::string> found;
  for (auto const& hint : hints) {
    found.push_back(std::to_string(hint["position"]["line"].get<int>()) + ":" +
                    std::to_string(hint["position"]["character"].get<int>()) + " " +
                    hint["label"].get<std::string>());
  }
  return found;
}

}  // namespace

TEST_CASE("hints show the quantity behind a raw number") {
  auto const hints = asked("textDocument/inlayHint", "/x.lis",
                           "# \xC3\xBC\nfilter[0].fg_f0  42.5 ( Hz\nfilter[0].type LOWPASS\n"
                           "getriebe[0].dynamik.vb_max  500000\nkenngr.achs_typ 1\nunknown 5\n",
                           {{"range", whole_range}});
  auto const found = labels(hints);
  CHECK(std::count(found.begin(), found.end(), "1:21 = 42.5 Hz") == 1);
  CHECK(std::count(found.begin(), found.end(), "3:34 = 500 mm/s") == 1);
  CHECK(std::none_of(found.begin(), found.end(), [](auto const& hint) { return hint.starts_with("4:"); }));
  CHECK(std::none_of(found.begin(), found.end(), [](auto const& hint) { return hint.starts_with("5:"); }));
}

TEST_CASE("hints name the defaults that a filter takes") {
  auto const hints =
      labels(asked("textDocument/inlayHint", "/x.lis",
                   "filter[0].enable 1\nfilter[0].order 2\nfilter[0].type BANDSTOP\nfilter[0].fg_f0 42\n",
                   {{"range", whole_range}}));
  auto const said = std::find_if(hints.begin(), hints.end(), [](auto const& hint) {
    return hint.find("by default") != std::string::npos;
  });
  REQUIRE(said != hints.end());
  CHECK(said->starts_with("2:23 "));
  CHECK(said->find("guete 1") != std::string::npos);
  CHECK(said->find("prototype CRIT_DAMPING") != std::string::npos);
  CHECK(said->find("order") == std::string::npos);
}

TEST_CASE("hints outside the range are not sent") {
  Json const range = {{"start", {{"line", 1}, {"character", 0}}}, {"end", {{"line", 2}, {"character", 0}}}};
  auto const hints =
      labels(asked("textDocument/inlayHint", "/x.lis",
                   "filter[0].fg_f0 1\nfilter[1].fg_f0 2\nfilter[2].fg_f0 3\n", {{"range", range}}));
  CHECK(hints == std::vector<std::string>{"1:17 = 2 Hz"});
}

TEST_CASE("tokens tell names, indices, values, comments and what the control ignores") {
  auto const data = asked("textDocument/semanticTokens/full", "/x.lis",
                          "# a\nfilter[0].type LOWPASS ( b\nunknown.x 5 junk\n")["data"];
  // line, character, length, type, modifiers; types: 0 property, 1 number, 2 enumMember, 5 comment
  CHECK(data == Json({0, 0, 3, 5, 0,                                                              //
                      1, 0, 6, 0, 0, 0, 7, 1, 1, 0, 0, 3, 4, 0, 0, 0, 5, 7, 2, 0, 0, 8, 3, 5, 0,  //
                      1, 0, 7, 0, 1, 0, 8, 1, 0, 1, 0, 2, 1, 1, 0, 0, 2, 4, 5, 1}));
}

TEST_CASE("tokens of text in several encodings count their units") {
  auto const text = "kopf.log_achs_name \xC3\x84\xF0\x9F\x98\x80 ( x\n";
  auto const data = [&](std::string const& encoding) {
    return Conversation(encoding)
        .open("/x.lis", text)
        .ask("textDocument/semanticTokens/full", "/x.lis")
        .results()[0]["data"];
  };
  CHECK(data("utf-8")[12] == 6);
  CHECK(data("utf-16")[12] == 3);
  CHECK(data("utf-32")[12] == 2);
}

TEST_CASE("comments fold, and so does what they head") {
  auto const ranges =
      asked("textDocument/foldingRange", "/x.lis",
            "# head\n# more\n\n# one\nfilter[0].order 1\nfilter[0].type PT2\n\n# two\nfilter[1].order 1\n");
  CHECK(std::count(ranges.begin(), ranges.end(),
                   Json({{"startLine", 0}, {"endLine", 1}, {"kind", "comment"}})) == 1);
  CHECK(std::count(ranges.begin(), ranges.end(),
                   Json({{"startLine", 3}, {"endLine", 5}, {"kind", "region"}})) == 1);
  CHECK(std::count(ranges.begin(), ranges.end(),
                   Json({{"startLine", 7}, {"endLine", 8}, {"kind", "region"}})) == 1);
  CHECK(ranges.size() == 3);
}

TEST_CASE("references of a default list are all lists of the machine that set the parameter") {
  auto const& folder = machine_folder();
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

TEST_CASE("a range is formatted as the whole list would be") {
  std::string const text = "filter[0].order 2\nfilter[0].type    PT2\nfilter[0].fg_f0  3\n";
  Json const range = {{"start", {{"line", 1}, {"character", 0}}}, {"end", {{"line", 2}, {"character", 0}}}};
  auto const edits = asked("textDocument/rangeFormatting", "/x.lis", text, {{"range", range}});
  TemporaryFolder const folder;
  folder.write("x.lis", text);
  CHECK(run_axisc({"fmt", folder / "x.lis"}).status == 0);
  auto const formatted = folder.read("x.lis");
  auto const second = formatted.substr(formatted.find('\n') + 1);
  REQUIRE(edits.size() == 1);
  CHECK(edits[0]["newText"] == second.substr(0, second.find('\n')));
  CHECK(edits[0]["range"]["start"] == Json({{"line", 1}, {"character", 0}}));
}

TEST_CASE("a lens above a cascade says what it costs") {
  auto const& folder = machine_folder();
  auto const path = folder / "x.lis";
  auto const text = folder.read("x.lis");
  auto const lenses = asked("textDocument/codeLens", path, text);
  REQUIRE(lenses.size() == 1);
  CHECK(lenses[0]["range"]["start"]["line"] == 1);
  Conversation conversation;
  conversation.open(path, text).ask("codeLens/resolve", path, lenses[0]);
  auto const title = conversation.results()[0]["command"]["title"].get<std::string>();
  // A low-pass of order 2 at 17 Hz delays by sqrt(2) / (2 pi f) = 13.24 ms.
  CHECK(title.starts_with("delay 13.2 ms, "));
  CHECK(title.find(" mm at a corner at 30000 mm/min") != std::string::npos);
  CHECK(asked("textDocument/codeLens", folder / "y.lis", "kopf.achs_nr 2\n").empty());
}

TEST_CASE("a lens says why there is no figure") {
  auto const title = [](std::string const& machine, std::string const& text) {
    TemporaryFolder const folder;
    folder.write("machine.json", machine);
    folder.write("x.lis", text);
    folder.write("y.lis", "kopf.achs_nr 2\n");
    auto const path = folder / "x.lis";
    auto const lens = asked("textDocument/codeLens", path, text)[0];
    return Conversation()
        .open(path, text)
        .ask("codeLens/resolve", path, lens)
        .results()[0]["command"]["title"]
        .get<std::string>();
  };
  std::string const machine = R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}]})";
  std::string const filter =
      "kopf.achs_nr 1\nfilter[0].enable 1\nfilter[0].type LOWPASS\nfilter[0].order 2\nfilter[0].fg_f0 ";
  CHECK(title(machine, filter + "17,5x\n").starts_with("no figures: machine.json has errors"));
  CHECK(title(machine, "kenngr.achs_typ 2\n" + filter + "17\ngetriebe[0].dynamik.vb_max 500000\n")
            .ends_with("; no corner deviation in mm: the axis is not translatory"));
  CHECK(
      title(
          R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}],
                  "groups": [{"name": "K", "axes": ["Y"]}]})",
          filter + "17\n") == "no figures: the axis is in no channel of machine.json");
  CHECK(title(R"({"axes": [{"name": "X", "list": "x.lis"}]})", filter + "17\n").find("cycle time") !=
        std::string::npos);
}

TEST_CASE("commands give pages of what is in the editor") {
  auto const& folder = machine_folder();
  auto const path = folder / "x.lis";
  auto const ask = [&](std::string const& text, std::vector<std::string> const& words) {
    Json arguments = {"file://" + path};
    for (std::size_t i = 1; i < words.size(); ++i) arguments.push_back(words[i]);
    return Conversation()
        .open(path, text)
        .ask("workspace/executeCommand", path, {{"command", words[0]}, {"arguments", arguments}})
        .results()[0];
  };
  auto const text = folder.read("x.lis");
  CHECK(ask(text, {"axisc.report"})["title"] == "Report: machine.json");
  auto const report = ask(text + "kopf.unsaved_name 1\n", {"axisc.report"})["html"].get<std::string>();
  CHECK(report.find("kopf.unsaved_name") != std::string::npos);
  for (auto const* const kind : {"response", "step", "delay", "corner", "circle"}) {
    CHECK(ask(text, {"axisc.plot", kind})["html"].get<std::string>().find("<svg") != std::string::npos);
  }
  CHECK(ask(text, {"axisc.machine"})["html"].get<std::string>().find("x.lis") != std::string::npos);
  CHECK(ask(text, {"axisc.plot", "nonsense"})["error"]["code"] == -32803);
  CHECK(ask("filter[0].enable 7\n" + text, {"axisc.plot"})["error"]["message"].get<std::string>().find(
            "has errors") != std::string::npos);
  CHECK(ask(text, {"axisc.unknown"})["error"]["code"] == -32602);
}

TEST_CASE("hovering over each parameter says what it means in both languages") {
  for (std::string const language : {"en", "de"}) {
    auto const all = Json::parse(run_axisc({"explain", "--all", "--format", "json", "--lang", language}).out);
    REQUIRE(all["parameters"].size() == 791);
    std::string text;
    for (auto const& parameter : all["parameters"]) {
      auto name = parameter["name"].get<std::string>();
      for (auto at = name.find("[]"); at != std::string::npos; at = name.find("[]")) name.insert(at + 1, "0");
      text += name + " 1\n";
    }
    Conversation conversation;
    conversation.open("/x.lis", text);
    for (int line = 0; line < 791; ++line) conversation.ask_at("textDocument/hover", "/x.lis", line, 1);
    auto const shown = conversation.results(language);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      INFO(all["parameters"][i]["name"]);
      auto const meaning = all["parameters"][i]["meaning"].get<std::string>();
      REQUIRE(!meaning.empty());
      REQUIRE(shown[i].is_object());
      CHECK(shown[i]["contents"]["value"].get<std::string>().find(meaning) != std::string::npos);
    }
  }
}

TEST_CASE("pointing at a filter's parameter shows what the filter does") {
  auto const& folder = machine_folder();
  auto const path = folder / "x.lis";
  auto const shown = [&](Json const& capabilities, int character) {
    return Conversation("utf-32", capabilities)
        .open(path, folder.read("x.lis"))
        .ask_at("textDocument/hover", path, 5, character)
        .results()[0]["contents"]["value"]
        .get<std::string>();
  };
  for (int const character : {3, 18}) {
    auto const text = shown(Json::object(), character);
    // sqrt(2) / (2 pi 17 Hz); exp(-pi), 4.32 %, of a Butterworth filter of order 2 in continuous time; -3 dB where it was asked for.
    CHECK(text.find("Delay 13.2 ms at 0 Hz, a step overshoots by 4.34 %, -3 dB at 17 Hz.") !=
          std::string::npos);
    CHECK(text.find("](data:image/svg+xml,%3Csvg") != std::string::npos);
  }
  Json const plain = {{"textDocument", {{"hover", {{"contentFormat", {"plaintext"}}}}}}};
  CHECK(shown(plain, 3).find("Delay 13.2 ms") != std::string::npos);
  CHECK(shown(plain, 3).find("svg") == std::string::npos);
}

TEST_CASE("a hover says why a filter has no figures") {
  auto const shown = [](std::string const& text) {
    auto const result =
        Conversation().open("/x.lis", text).ask_at("textDocument/hover", "/x.lis", 0, 3).results()[0];
    return result["contents"]["value"].get<std::string>();
  };
  std::string const values = "filter[0].fg_f0 17\nfilter[0].type LOWPASS\nfilter[0].order 2\n";
  CHECK(shown(values + "filter[0].enable 1\n").find("No figures") == std::string::npos);
  CHECK(shown(values + "filter[0].enable 0\n").find("No figures: this filter is switched off.") !=
        std::string::npos);
  CHECK(shown(values + "filter[0].enable 1\nfilter[0].share_percent oft\n")
            .find("No figures: a value of this filter cannot be used.") != std::string::npos);
}

TEST_CASE("a finding can be allowed on its line, and then it is gone") {
  auto const allowed = [](std::string const& text) {
    auto const actions = Conversation()
                             .open("/x.lis", text)
                             .ask("textDocument/codeAction", "/x.lis",
                                  {{"range", whole_range}, {"context", {{"diagnostics", Json::array()}}}})
                             .results()[0];
    auto const action = std::find_if(actions.begin(), actions.end(), [](Json const& each) {
      return each["title"] == "Allow AX2001 on this line";
    });
    REQUIRE(action != actions.end());
    auto const edit = (*action)["edit"]["changes"]["file:///x.lis"][0];
    auto const line = edit["range"]["start"]["line"].get<std::size_t>();
    std::size_t begin = 0;
    for (std::size_t i = 0; i < line; ++i) begin = text.find('\n', begin) + 1;
    auto changed = text;
    changed.insert(begin + edit["range"]["start"]["character"].get<std::size_t>(), edit["newText"]);
    return changed;
  };
  CHECK(allowed("unknown.name 1\n") == "unknown.name 1  ( axisc: allow AX2001\n");
  CHECK(allowed("unknown.name 1 ( old\n") == "unknown.name 1 ( old axisc: allow AX2001\n");
  CHECK(allowed("unknown.name 1 ( axisc: allow AX1005\n") == "unknown.name 1 ( axisc: allow AX1005,AX2001\n");
  for (auto const* const text :
       {"unknown.name 1\n", "unknown.name 1 ( old\n", "unknown.name 1 ( axisc: allow AX1005\n"}) {
    Conversation conversation;
    conversation.open("/x.lis", allowed(text));
    (void)conversation.results();
    for (auto const& message : conversation.notifications()) {
      for (auto const& finding : message["params"].value("diagnostics", Json::array())) {
        CHECK(finding["code"] != "AX2001");
      }
    }
  }
}

TEST_CASE("a finding's page and a number's word are actions") {
  auto const actions = [](std::string const& text) {
    Json const range = {{"start", {{"line", 0}, {"character", 3}}}, {"end", {{"line", 0}, {"character", 3}}}};
    return Conversation()
        .open("/x.lis", text)
        .ask("textDocument/codeAction", "/x.lis",
             {{"range", range}, {"context", {{"diagnostics", Json::array()}}}})
        .results()[0];
  };
  auto const explain = actions("unknown.name 1\n");
  REQUIRE(!explain.empty());
  CHECK(explain.back()["command"]["arguments"] == Json({"file:///x.lis", "AX2001"}));
  auto const words = actions("filter[0].prototype 2\n");
  auto const word = std::find_if(words.begin(), words.end(),
                                 [](Json const& each) { return each["kind"] == "refactor.rewrite"; });
  REQUIRE(word != words.end());
  CHECK((*word)["edit"]["changes"]["file:///x.lis"][0]["newText"] == "  ( BUTTERWORTH");
  auto const page = asked("workspace/executeCommand", "/x.lis", "",
                          {{"command", "axisc.explain"}, {"arguments", {"file:///x.lis", "AX2001"}}});
  CHECK(page["title"] == "AX2001");
  auto const html = page["html"].get<std::string>();
  CHECK(html.find("<h1>") != std::string::npos);
  CHECK(html.find("AX2001") != std::string::npos);
  // As a page, not as the source of one.
  CHECK(html.find("**") == std::string::npos);
}

TEST_CASE("a value with its unit is converted to the unit of the list") {
  auto const converted = [](std::string const& text) {
    Json const at = {{"line", 0}, {"character", 0}};
    auto const actions =
        asked("textDocument/codeAction", "/x.lis", text,
              {{"range", {{"start", at}, {"end", at}}}, {"context", {{"only", {"refactor.rewrite"}}}}});
    if (actions.empty()) return std::string();
    auto const edit = actions[0]["edit"]["changes"]["file:///x.lis"][0];
    auto const begin = edit["range"]["start"]["character"].get<std::size_t>();
    return text.substr(0, begin) + edit["newText"].get<std::string>() + text.substr(begin);
  };
  CHECK(converted("filter[0].time_constant 20 ms\n") == "filter[0].time_constant 20000 ( 20 ms\n");
  CHECK(converted("filter[0].time_constant 20ms\n") == "filter[0].time_constant 20000 ( 20ms\n");
  CHECK(converted("filter[0].time_constant 0,5 ms ( so\n") == "filter[0].time_constant 500 ( 0,5 ms ( so\n");
  CHECK(converted("filter[0].fg_f0 42.5Hz\n") == "filter[0].fg_f0 42.5 ( 42.5Hz\n");
  CHECK(converted("filter[0].fg_f0 0.1 kHz\n") == "filter[0].fg_f0 100 ( 0.1 kHz\n");
  CHECK(converted("getriebe[0].dynamik.vb_max 500 mm/s\n") ==
        "getriebe[0].dynamik.vb_max 500000 ( 500 mm/s\n");
  // In the list's unit, of another quantity, not whole, no unit, no number.
  for (auto const* const text :
       {"filter[0].fg_f0 42.5 Hz\n", "filter[0].time_constant 20 Hz\n", "filter[0].time_constant 0.0001 ms\n",
        "filter[0].fg_f0 42.5\n", "filter[0].fg_f0 42.5 Hallo\n", "filter[0].type 20 ms\n",
        "unknown 20 ms\n"}) {
    INFO(text);
    CHECK(converted(text).empty());
  }
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

TEST_CASE("pointing at #FILTER shows the kernels that result") {
  TemporaryFolder const folder;
  folder.write(
      "machine.json",
      R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}],
                   "programs": ["part.nc"]})");
  folder.write("x.lis", "kopf.achs_nr 1\nfilter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 10\n");
  folder.write("y.lis", "kopf.achs_nr 2\n");
  std::string const text =
      "N1 G01 X1\n#FILTER [ORDER=20]\n#FILTER [SHARE=50]\n#FILTER OFF\n#FILTER ON [HSC]\n";
  folder.write("part.nc", text);
  Conversation conversation;
  conversation.open(folder / "part.nc", text);
  for (int line = 0; line < 5; ++line) conversation.ask_at("textDocument/hover", folder / "part.nc", line, 3);
  auto const shown = conversation.results();
  auto const said = [&](std::size_t line) { return shown[line]["contents"]["value"].get<std::string>(); };
  CHECK(shown[0].is_null());
  // A moving average of order 20 has 21 taps and delays by 10 cycles.
  CHECK(
      said(1) ==
      "In force from here: ORDER=20.\n\n- X: moving average of order 20, delay 10 ms\n- Y: no FIR filter\n");
  CHECK(said(2).starts_with("In force from here: ORDER=20 SHARE=50."));
  CHECK(said(3).find("are off") != std::string::npos);
  CHECK(said(4).find("HSC") != std::string::npos);
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
