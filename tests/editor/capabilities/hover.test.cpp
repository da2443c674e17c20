// Hovers over names, values, numbers and commands.
#include "folders.hpp"
#include "support/catch.hpp"

#include <array>
#include <vector>

namespace hover_test {

using namespace axisc::test;

namespace {

Json hover(std::string const& path, std::string const& text, int line, int character) {
  return Conversation().open(path, text).ask_at("textDocument/hover", path, line, character).results()[0];
}

std::string hover_text(std::string const& path, std::string const& text, int line, int character) {
  auto const shown = hover(path, text, line, character);
  return shown.is_null() ? "" : shown["contents"]["value"].get<std::string>();
}

bool contains(std::string const& text, std::string const& piece) {
  INFO(text);
  CHECK(text.find(piece) != std::string::npos);
  return text.find(piece) != std::string::npos;
}

}  // namespace

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

TEST_CASE("hovering over a name says which value is in effect and which list it comes from") {
  auto const list = folder_of_one_axis() / "x.lis";
  auto const text = text_of(list);
  contains(hover_text(list, text, 1, 3), "In effect: 18 Hz, from x.lis, line 3.");
  CHECK(hover_text(list, text, 2, 3).find("In effect") == std::string::npos);
}

TEST_CASE("hovering over what drives an axis says which value counts, and the jerk") {
  std::string const list =
      "getriebe[0].slope_profil.a_beschl 2000\ngetriebe[0].slope_profil.tr_beschl_zu 5000\n";
  // Defaults: at most 1000 mm/s², at least 10 ms; 1000 mm/s² in 10 ms are 100 m/s³.
  contains(hover_text("/x.lis", list, 0, 36), "P-AXIS-00008 limits it: 1000 mm/s² counts.");
  contains(hover_text("/x.lis", list, 1, 5), "P-AXIS-00201 limits it: 10 ms counts.");
  contains(hover_text("/x.lis", list, 1, 5), "The jerk a/tr of this ramp is 100 m/s³.");
}

TEST_CASE("clients without Markdown get plain text") {
  auto const results =
      Conversation("utf-16", {{"textDocument", {{"hover", {{"contentFormat", {"plaintext"}}}}}}})
          .open("/x.lis", "filter[0].order 2\n")
          .ask_at("textDocument/hover", "/x.lis", 0, 2)
          .results();
  CHECK(results[0]["contents"]["kind"] == "plaintext");
}

TEST_CASE("pointing at a filter's parameter shows what the filter does") {
  auto const& folder = folder_of_two_axes();
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
    // sqrt(2) / (2 pi 17 Hz); exp(-pi), 4.32 %, of a Butterworth filter of order 2 in continuous time; -3 dB
    // where it was asked for.
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

TEST_CASE("a hover over a guard tells its delay, its interval, and what it costs at a corner") {
  // 30 Hz, D = 0.1, T = 1 ms: at 1000 mm/min another program computed 76.86, 89.18, 116.51 and 68.08 µm at a
  // corner of 90°, of mode 4 v h K/(1 + K)²; at 3000 mm/min it is three times as much.
  TemporaryFolder const folder;
  folder.write("machine.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}]})");
  auto const shown = [&](std::string const& mode, std::string const& more) {
    auto const text = "vib_guard.active 1\nvib_guard.mode " + mode +
                      "\nvib_guard.freq 30\nvib_guard.damping 0.1\n" + more + "Ende\n";
    folder.write("x.lis", text);
    return hover_text(folder / "x.lis", text, 1, 3);
  };
  std::string const velocity = "getriebe[0].dynamik.vb_max 50000\n";
  for (auto const& [mode, delay, error] : std::vector<std::array<std::string, 3>>{
           {"1", "7.06", "231"}, {"2", "14.1", "268"}, {"3", "21.2", "350"}, {"4", "17", "204"}}) {
    contains(shown(mode, velocity), "Vibration Guard: mode " + mode + " at 30 Hz, delay " + delay + " ms");
    contains(shown(mode, velocity),
             "axis error " + error + " µm at a corner of 90° at 3000 mm/min (vb_max).");
  }
  contains(shown("2", velocity), "at most 5 % left from 25 to 35.3 Hz (a reading)");
  // ° are no µm.
  CHECK(shown("2", velocity + "kenngr.achs_typ 2\n").find("corner") == std::string::npos);
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

TEST_CASE("pointing at a word that says how the path is driven shows what it does") {
  std::string const text = "N1 G01 G60 X1 (G360)\nN2 #SLOPE [TYPE=SIN2]\nN3 G131=50 #CONTOUR MODE OFF\n";
  auto const shown = [&](int line, int column) {
    return Conversation()
        .open("/p.nc", text)
        .ask_at("textDocument/hover", "/p.nc", line, column)
        .results()[0];
  };
  auto const said = [&](int line, int column) {
    return shown(line, column)["contents"]["value"].get<std::string>();
  };
  CHECK(said(0, 8).find("G60") < 3);
  CHECK(said(0, 8).find("Exact stop at the end of this block") != std::string::npos);
  CHECK(shown(0, 8)["range"]["start"]["character"] == 7);
  CHECK(shown(0, 8)["range"]["end"]["character"] == 10);
  CHECK(shown(0, 4).is_null());
  // Text in a comment is no word.
  CHECK(shown(0, 16).is_null());
  CHECK(said(1, 5).find("sin²") != std::string::npos);
  CHECK(said(2, 4).find("G131=percent") != std::string::npos);
  CHECK(said(2, 20).find("#CONTOUR MODE OFF") < 3);
}

TEST_CASE("hovering over what delays says its share, and what the axis comes to") {
  std::string const text =
      "kenngr.antr_typ 3\nvorsteuer.vorsteuerung ADD_VEL\nvorsteuer.default_active 1\n"
      "vorsteuer.shift_time 3\nvorsteuer.velocity_delay_time 1500\n";
  // 5 cycles for both, 3 earlier and 1.5 later for the velocity: 3.5.
  std::string const sums =
      "position 5 ms, velocity feedforward 3.5 ms: the velocity arrives 1.5 ms before its position";
  auto const shift = hover_text("/x.lis", text, 3, 3);
  contains(shift, "Its share: velocity feedforward -3 cycles (-3 ms)");
  contains(shift, "At the start of programs: " + sums);
  auto const delay = hover_text("/x.lis", text, 4, 3);
  contains(delay, "Its share: velocity feedforward 1.5 cycles (1.5 ms).");
  contains(hover_text("/x.lis", text, 2, 3), sums);
}

}  // namespace hover_test
