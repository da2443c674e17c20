// The line above a cascade, and pages.
#include "folders.hpp"
#include "support/catch.hpp"

namespace lenses_test {

using namespace axisc::test;

TEST_CASE("a lens above a cascade says what it costs") {
  auto const& folder = folder_of_two_axes();
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
  auto const& folder = folder_of_two_axes();
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
  for (auto const* const kind : {"response", "step", "delay", "corner", "circle", "dynamics", "robustness"}) {
    CHECK(ask(text, {"axisc.plot", kind})["html"].get<std::string>().find("<svg") != std::string::npos);
  }
  CHECK(ask(text, {"axisc.machine"})["html"].get<std::string>().find("x.lis") != std::string::npos);
  CHECK(ask(text, {"axisc.plot", "nonsense"})["error"]["code"] == -32803);
  CHECK(ask("filter[0].enable 7\n" + text, {"axisc.plot"})["error"]["message"].get<std::string>().find(
            "has errors") != std::string::npos);
  CHECK(ask(text, {"axisc.unknown"})["error"]["code"] == -32602);
}

TEST_CASE("a lens above feedforward says how far it leads") {
  // The default shift of PROFIdrive is 3 cycles: a L/Kv = 3 m/s² · 3 ms / 60 1/s = 150 µm.
  std::string const text =
      "kenngr.antr_typ 3\nantr.operation_mode CNC_POSITION_CONTROL\ngetriebe[0].kv 6000\n"
      "getriebe[0].dynamik.a_max 3000\nvorsteuer.vorsteuerung VEL\nvorsteuer.default_active 1\n";
  auto const lenses = asked("textDocument/codeLens", "/x.lis", text);
  REQUIRE(lenses.size() == 1);
  CHECK(lenses[0]["range"]["start"]["line"] == 4);
  CHECK(lenses[0]["command"]["title"] == "velocity feedforward leads by 3 cycles: 150 µm at a_max");
  CHECK(lenses[0]["command"]["arguments"][1] == "delay");
  // Together with the position, and without feedforward, there is nothing to say.
  CHECK(asked("textDocument/codeLens", "/x.lis", text + "vorsteuer.shift_time 0\n").empty());
  CHECK(asked("textDocument/codeLens", "/x.lis", text + "vorsteuer.default_active 0\n").empty());
}

}  // namespace lenses_test
