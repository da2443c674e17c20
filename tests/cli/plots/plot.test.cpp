// Pictures show what response and run compute: the curves are read back from the SVG.
#include "cli/compiled_machine.hpp"
#include "cli/program.hpp"
#include "presentation/pictures/projection.hpp"
#include "support/golden.hpp"
#include "support/sanitized.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <random>
#include <sstream>

#include <nlohmann/json.hpp>

namespace plot_test {

using namespace axisc::test;
using namespace axisc::pictures;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using nlohmann::json;
using namespace std::string_literals;

namespace {

constexpr double nyquist = 500;
constexpr double floor_db = -80;

struct Place {
  double x, y;
};

/// Places of the first path from here on, in its order.
std::vector<Place> places_of(std::string const& svg, std::size_t begin) {
  auto const path = svg.find(" d=\"", begin) + 4;
  std::string text = svg.substr(path, svg.find('"', path) - path);
  std::replace_if(
      text.begin(), text.end(), [](char letter) { return letter == 'M' || letter == 'L'; }, ' ');
  std::istringstream in(text);
  std::vector<Place> places;
  for (Place place{}; in >> place.x >> place.y;) places.push_back(place);
  return places;
}

/// Of the first curve that has this class.
std::vector<Place> curve_of(std::string const& svg, std::string const& kind) {
  auto const begin = svg.find("class=\"curve " + kind);
  REQUIRE(begin != std::string::npos);
  return places_of(svg, begin);
}

/// The edge of the first panel: top and height.
double top_of(std::string const& svg) {
  auto const at = svg.find(" y=\"", svg.find("<rect class=\"edge\"")) + 4;
  return std::stod(svg.substr(at));
}

/// How far the place is from the curve.
double distance(std::vector<Place> const& curve, Place const& place) {
  double least = 1e18;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    Place const& a = curve[i - 1];
    double const dx = curve[i].x - a.x;
    double const dy = curve[i].y - a.y;
    double const square = dx * dx + dy * dy;
    double const along = square == 0 ? 0 : ((place.x - a.x) * dx + (place.y - a.y) * dy) / square;
    double const share = along < 0 ? 0 : along > 1 ? 1 : along;
    double const x = a.x + share * dx - place.x;
    double const y = a.y + share * dy - place.y;
    least = std::min(least, x * x + y * y);
  }
  return std::sqrt(least);
}

/// The picture's place of a label of the horizontal axis.
double tick_of(std::string const& svg, std::string const& label) {
  auto const end = svg.find("text-anchor=\"middle\">" + label + "</text>");
  REQUIRE(end != std::string::npos);
  auto const at = svg.rfind(" x=\"", end) + 4;
  return std::stod(svg.substr(at));
}

/// The sample mill with three parameters of its default list changed, in the folder `old`.
void write_changed_mill(TemporaryFolder const& folder) {
  for (std::string const name :
       {"machine.json", "default.lis", "x.lis", "y.lis", "z.lis", "spindle.lis", "part.nc"}) {
    std::string text = read_source_file("samples/mill/" + name);
    if (name == "default.lis") {
      for (auto const& [parameter, value] : std::map<std::string, std::string>{
               {"filter[0].fg_f0", "48"}, {"filter[0].guete", "3"}, {"filter[1].order", "3"}}) {
        auto const begin = text.find(parameter);
        text.replace(begin, text.find('\n', begin) - begin, parameter + " " + value);
      }
    }
    folder.write("old/" + name, text);
  }
}

std::string rounded(double value) {
  std::ostringstream text;
  text << std::setprecision(4) << value;
  return text.str();
}

std::string random_list(std::mt19937& random) {
  auto const number = [&](double low, double high) {
    return std::to_string(std::uniform_real_distribution(low, high)(random));
  };
  auto const count = [&](int low, int high) {
    return std::to_string(std::uniform_int_distribution(low, high)(random));
  };
  std::string list;
  char const* const types[] = {"LOWPASS", "BANDSTOP", "BANDPASS", "HIGHPASS"};
  char const* const prototypes[] = {"CRIT_DAMPING", "BUTTERWORTH", "BESSEL"};
  for (int i = 0; i < 2; ++i) {
    std::string const name = "filter[" + std::to_string(i) + "].";
    bool const is_band = i == 0;
    list += name + "enable 1\n" + name + "type " + types[is_band ? 1 : 0] + "\n" + name + "prototype " +
            prototypes[std::uniform_int_distribution(0, 2)(random)] + "\n" + name + "order " +
            (is_band ? "2" : count(1, 4)) + "\n" + name + "fg_f0 " + number(5, 200) + "\n";
    if (is_band) list += name + "guete " + number(1, 10) + "\n";
  }
  return list + "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order " + count(1, 100) + "\n";
}

}  // namespace

TEST_CASE("a drawn magnitude is the response, for random chains") {
  constexpr int chains = sanitized ? 5 : 60;
  constexpr int frequencies = 1000;
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  std::mt19937 random(20240229);
  std::string asked;
  std::vector<double> shown;
  for (int i = 0; i < frequencies; ++i) {
    double const frequency = nyquist * std::pow(10.0, -4.0 * (frequencies - 1 - i) / (frequencies - 1));
    asked += (i == 0 ? "" : ",") + std::to_string(frequency);
    shown.push_back(std::stod(std::to_string(frequency)));
  }
  double largest = 0;
  for (int chain = 0; chain < chains; ++chain) {
    folder.write("x.lis", random_list(random));
    std::vector<std::string> const compile{"compile", "x.lis",  "--cycle-time", "1ms",
                                           "-o",      "x.axim", "--quiet"};
    REQUIRE(run_axisc(compile, there).status == 0);
    std::string const svg = run_axisc({"plot", "x.axim", "-o", "-"}, there).out;
    auto const curve = curve_of(svg, "whole");
    double const top = top_of(svg);
    std::istringstream rows(run_axisc({"response", "x.axim", "--frequencies", asked}, there).out);
    std::string row;
    std::getline(rows, row);
    Axis const x{.scale = Scale::logarithmic, .low = 0.05, .high = nyquist};
    // No filter amplifies: 0 dB and 4 dB above are the upper end, unless a band-stop overshoots in frequency.
    for (double const frequency : shown) {
      std::getline(rows, row);
      std::istringstream fields(row);
      std::string name;
      std::string magnitude;
      std::getline(fields, name, ',');
      std::getline(fields, magnitude, ',');
      std::getline(fields, magnitude, ',');
      double const decibels = std::max(20 * std::log10(std::stod(magnitude)), floor_db);
      Projection const across(x, panel_left, panel_right);
      Projection const up({.low = floor_db, .high = 4}, top + usual_panel_height, top);
      largest = std::max(largest, distance(curve, {.x = across(frequency), .y = up(decibels)}));
    }
  }
  CHECK(largest < 0.25);
}

TEST_CASE("a notch of quality 10 reaches the floor of its picture") {
  TemporaryFolder const folder;
  folder.write("x.lis",
               "filter[0].enable 1\nfilter[0].type BANDSTOP\nfilter[0].order 2\nfilter[0].fg_f0 "
               "42\nfilter[0].guete 10\n");
  auto const outcome =
      run_axisc({"plot", "x.lis", "--cycle-time", "1ms", "-o", "-"}, in_folder(folder.path()));
  double const top = top_of(outcome.out);
  auto const curve = curve_of(outcome.out, "whole");
  auto const lowest =
      std::max_element(curve.begin(), curve.end(), [](Place a, Place b) { return a.y < b.y; });
  CHECK(lowest->y == Approx(top + usual_panel_height));
}

TEST_CASE("approved pictures, in both languages, from a machine and from its image") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  std::string const mill = AXISC_SOURCE_DIR "/samples/mill/machine.json";
  REQUIRE(run_axisc({"compile", mill, "-o", "m.axim", "--quiet"}, there).status == 0);
  for (std::string const language : {"en", "de"}) {
    for (std::string const kind : {"response", "step", "delay"}) {
      for (std::string const axis : {"", "X"}) {
        std::vector<std::string> words{"plot", "m.axim", "--kind", kind, "-o", "p.svg", "--lang", language};
        if (!axis.empty()) words.insert(words.end(), {"--axis", axis});
        auto const outcome = run_axisc(words, there);
        CHECK(outcome.status == 0);
        CHECK(outcome.out.empty());
        std::string const svg = folder.read("p.svg");
        check_golden("tests/cli/data/golden/plots/" + kind + (axis.empty() ? "" : "." + axis) + "." +
                         language + ".svg",
                     svg);
        words[1] = mill;
        REQUIRE(run_axisc(words, there).status == 0);
        CHECK(folder.read("p.svg") == svg);
      }
    }
  }
}

TEST_CASE("the documentation shows what the program draws") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  std::string const mill = AXISC_SOURCE_DIR "/samples/mill/machine.json";
  std::string const rack = AXISC_SOURCE_DIR "/samples/motion/rack/";
  std::string const square = AXISC_SOURCE_DIR "/samples/motion/square/";
  std::string const scope = AXISC_SOURCE_DIR "/samples/recording/";
  write_changed_mill(folder);
  for (auto const& [name, options] : std::map<std::string, std::vector<std::string>>{
           {"response", {"--axis", "X"}},
           {"step", {"--kind", "step", "--axis", "X"}},
           {"delay", {"--kind", "delay"}},
           {"corner", {"--kind", "corner", "--feed", "1000,2000,4000"}},
           {"circle", {"--kind", "circle", "--feed", "2000,4000"}},
           {"dynamics", {"--kind", "dynamics", "--axis", "X"}},
           {"robustness", {"--kind", "robustness"}},
           {"path", {"--kind", "path", "--program", square + "square.nc", "--tolerance", "0.1"}},
           {"plant", {"--kind", "plant", "--plant", rack + "plant.json", "--move", "X:800:31800"}},
           {"compare", {"--kind", "compare", "--recording", scope + "scope.csv", "--cycle-time", "1ms"}},
           {"change", {"--before", "old/machine.json", "--axis", "X"}}}) {
    std::vector<std::string> words{
        "plot",
        name == "plant"        ? rack + "machine.json"
        : name == "path"       ? square + "machine.json"
        : name == "robustness" ? AXISC_SOURCE_DIR "/samples/motion/guard/machine.json"
        : name == "dynamics"   ? AXISC_SOURCE_DIR "/samples/motion/dynamics/machine.json"
        : name == "compare"    ? scope + "x.lis"
                               : mill,
        "-o", "-"};
    words.insert(words.end(), options.begin(), options.end());
    auto const outcome = run_axisc(words, there);
    CHECK(outcome.status == 0);
    check_golden("docs/pictures/" + name + ".svg", outcome.out);
  }
}

TEST_CASE("approved pictures of contours, of changes and in the terminal") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  std::string const mill = AXISC_SOURCE_DIR "/samples/mill/machine.json";
  write_changed_mill(folder);
  for (std::string const language : {"en", "de"}) {
    auto const golden = [&](std::string const& name, std::vector<std::string> words) {
      words.insert(words.begin(), {"plot", mill});
      words.insert(words.end(), {"--lang", language});
      auto const outcome = run_axisc(words, there);
      CHECK(outcome.status == 0);
      check_golden("tests/cli/data/golden/plots/" + name + "." + language +
                       (words.back() == "-" || outcome.out.starts_with("<svg") ? ".svg" : ".txt"),
                   outcome.out);
    };
    std::vector<std::string> const before{"--before", "old/machine.json", "-o", "-"};
    auto const with_before = [&](std::vector<std::string> words) {
      words.insert(words.end(), before.begin(), before.end());
      return words;
    };
    golden("corner", {"--kind", "corner", "--feed", "1000,2000,4000", "-o", "-"});
    golden("circle", {"--kind", "circle", "--feed", "1000,4000", "--radius", "5", "-o", "-"});
    golden("response.change", with_before({"--axis", "X", "--mark", "48Hz"}));
    golden("step.change", with_before({"--kind", "step", "--axis", "X"}));
    golden("delay.change", with_before({"--kind", "delay"}));
    golden("corner.change", with_before({"--kind", "corner", "--angle", "60"}));
    golden("circle.change", with_before({"--kind", "circle"}));
    golden("terminal", {"--kind", "delay", "--before", "old/machine.json"});
    golden("terminal.response", {"--axis", "X"});
  }
}

TEST_CASE("what is read off the picture of a contour is what contour says") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  std::string const mill = AXISC_SOURCE_DIR "/samples/mill/machine.json";
  auto const said = json::parse(
      run_axisc({"contour", mill, "--feed", "4000", "--angle", "60", "--format", "json"}, there).out);
  auto const& figures = said["groups"][0];
  std::string const corner =
      run_axisc({"plot", mill, "--kind", "corner", "--feed", "4000", "--angle", "60", "-o", "-"}, there).out;
  // The corner is the bend of the programmed path; a tick of 100 µm gives the scale.
  auto const programmed = curve_of(corner, "guide");
  REQUIRE(programmed.size() == 3);
  double const um_per_pixel = 100 / (tick_of(corner, "0") - tick_of(corner, "-100"));
  double const read = distance(curve_of(corner, "whole"), programmed[1]) * um_per_pixel;
  CHECK(read == Approx(figures["contour_deviation_um"].get<double>()).epsilon(0.005));

  std::string const circle =
      run_axisc({"plot", mill, "--kind", "circle", "--feed", "4000", "-o", "-"}, there).out;
  auto const ring = curve_of(circle, "guide");
  auto const drawn = curve_of(circle, "whole");
  auto const radius = [](std::vector<Place> const& curve) {
    auto const [left, right] =
        std::minmax_element(curve.begin(), curve.end(), [](Place a, Place b) { return a.x < b.x; });
    return (right->x - left->x) / 2;
  };
  auto const at = circle.find("× ") + std::string("× ").size();
  double const factor = std::stod(circle.substr(at));
  double const deviation = (radius(ring) - radius(drawn)) / radius(ring) * 10'000 / factor;
  CHECK(deviation == Approx(figures["circle"]["contour_deviation_um"].get<double>()).epsilon(0.02));
}

TEST_CASE("what was measured is drawn, and added to what the filter does") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  // A resonance of 12 dB at 50 Hz, read back from the picture.
  folder.write("m.csv",
               "frequency_hz,coherence,magnitude_db,phase_deg\n20,1,0,0\n50,1,12,-90\n100,0.9,-6,-170\n");
  auto const plot = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"plot", "m.axim", "--measured", "m.csv", "--axis", "X", "-o", "-"});
    return run_axisc(more, there);
  };
  std::string const svg = plot({}).out;
  auto const measured = curve_of(svg, "measured");
  REQUIRE(measured.size() == 3);
  auto const response = json::parse(
      run_axisc({"response", "m.axim", "--axis", "X", "--frequencies", "20,50,100", "--format", "json"},
                there)
          .out);
  auto const behind = svg.find("measured × X</title>");
  REQUIRE(behind != std::string::npos);
  auto const filtered = places_of(svg, svg.rfind(" d=\"", behind));
  REQUIRE(filtered.size() == 3);
  // 80 dB and what the picture adds above 12 dB are its height.
  double const pixels_per_db = usual_panel_height / (80 + 12 + 4);
  for (std::size_t i = 0; i < 3; ++i) {
    double const decibels = response["response"][i]["magnitude_db"].get<double>();
    CHECK((filtered[i].y - measured[i].y) / pixels_per_db == Approx(-decibels).margin(0.02));
  }
  for (std::string const wrong : {"", "frequency_hz,x\n1,2\n", "frequency_hz,magnitude_db\n1,x\n",
                                  "frequency_hz,magnitude_db\n0,1\n"}) {
    folder.write("m.csv", wrong);
    auto const outcome = plot({});
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.err, Contains("m.csv"));
  }
}

TEST_CASE(
    "a program's picture says the largest deviation that simulate finds, and marks what exceeds a "
    "tolerance") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  std::string const square = AXISC_SOURCE_DIR "/samples/motion/square/";
  std::vector<std::string> const program{square + "machine.json", "--program", square + "square.nc"};
  auto const with = [&](std::vector<std::string> words, std::vector<std::string> const& more) {
    words.insert(words.end(), program.begin(), program.end());
    words.insert(words.end(), more.begin(), more.end());
    return run_axisc(words, there);
  };
  auto const said = json::parse(with({"simulate"}, {"--format", "json"}).out);
  double largest = 0;
  for (auto const& block : said["blocks"]) {
    largest = std::max(largest, block["max_contour_deviation_um"].get<double>());
  }
  REQUIRE(largest > 0);
  auto const plot = [&](std::vector<std::string> const& more) {
    return with({"plot", "--kind", "path"}, more);
  };
  std::string const svg = plot({"-o", "-"}).out;
  CHECK_THAT(svg, Contains(rounded(largest) + " µm in line"));
  CHECK_THAT(svg, !Contains(">line "));
  CHECK_THAT(plot({"-o", "-", "--tolerance", "0.04"}).out, Contains(">line ") && Contains(">tolerance<"));
  CHECK_THAT(plot({"-o", "-", "--tolerance", "1"}).out, !Contains(">line "));
  CHECK(plot({"-o", "-", "--plane", "YX"}).out != svg);
  for (auto const& wrong : std::vector<std::vector<std::string>>{
           {"--plane", "XQ"}, {"--tolerance", "0"}, {"--feed", "1"}, {"--program", "none.nc"}}) {
    CHECK(plot(wrong).status == 2);
  }
  folder.write("bad.nc", "G01 X1 F1000\nG41\nM30\n");
  auto const refused =
      run_axisc({"plot", square + "machine.json", "--kind", "path", "--program", "bad.nc"}, there);
  CHECK(refused.status == 1);
  CHECK(refused.out.empty());
  folder.write("still.nc", "M30\n");
  auto const still =
      run_axisc({"plot", square + "machine.json", "--kind", "path", "--program", "still.nc"}, there);
  CHECK_THAT(still.out, Contains("moves nothing"));
}

TEST_CASE("a plant's picture shows the oscillation that simulate names") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  std::string const rack = AXISC_SOURCE_DIR "/samples/motion/rack/";
  std::vector<std::string> const move{"--plant", rack + "plant.json", "--move", "X:800:31800"};
  std::vector<std::string> words{"simulate", rack + "machine.json", "--format", "json"};
  words.insert(words.end(), move.begin(), move.end());
  auto const said = json::parse(run_axisc(words, there).out);
  words = {"plot", rack + "machine.json", "--kind", "plant", "--table"};
  words.insert(words.end(), move.begin(), move.end());
  auto const table = run_axisc(words, there);
  CHECK(table.status == 0);
  for (auto const& oscillation : said["oscillations"]) {
    CHECK_THAT(table.out, Contains(rounded(oscillation["frequency_hz"].get<double>())));
  }
  for (auto const& wrong : std::vector<std::vector<std::string>>{
           {"plot", rack + "machine.json", "--kind", "plant"},
           {"plot", rack + "machine.json", "--kind", "plant", "--plant", rack + "plant.json"},
           {"plot", rack + "machine.json", "--kind", "plant", "--plant", "none.json", "--move", "X:1"},
           {"plot", rack + "machine.json", "--kind", "step", "--move", "X:1"}}) {
    CHECK(run_axisc(wrong, there).status == 2);
  }
}

TEST_CASE("a change of three parameters is said in numbers") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  write_changed_mill(folder);
  std::string const mill = AXISC_SOURCE_DIR "/samples/mill/machine.json";
  auto const outcome =
      run_axisc({"plot", mill, "--before", "old/machine.json", "--axis", "X", "--table"}, there);
  CHECK(outcome.status == 0);
  // Delay of both states as inspect says it, and their difference.
  auto const delay = [&](std::string const& machine) {
    REQUIRE(run_axisc({"compile", machine, "-o", "m.axim", "--quiet"}, there).status == 0);
    auto const said = json::parse(run_axisc({"inspect", "m.axim", "--format", "json"}, there).out);
    return said["axes"][0]["delay_ms"].get<double>();
  };
  double const now = delay(mill);
  double const before = delay("old/machine.json");
  CHECK(now != before);
  CHECK_THAT(outcome.out,
             Contains(rounded(before)) && Contains(rounded(now)) && Contains(rounded(now - before)));
}

TEST_CASE("pictures for a page, and what does not go together") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  REQUIRE(run_axisc({"plot", "m.axim", "-o", "p.html", "--lang", "de"}, there).status == 0);
  std::string const page = folder.read("p.html");
  CHECK_THAT(page,
             Contains("<html lang=\"de\">") && Contains("<svg") && Contains("<table") && !Contains("src="));
  REQUIRE(run_axisc({"plot", "m.axim", "-o", "q.x", "--format", "svg"}, there).status == 0);
  CHECK_THAT(folder.read("q.x"), StartsWith("<svg"));
  for (auto const& wrong : std::vector<std::vector<std::string>>{{"-o", "q.x"},
                                                                 {"-o", "-", "--table"},
                                                                 {"--kind", "corner", "--order", "4"},
                                                                 {"--kind", "corner", "--axis", "X"},
                                                                 {"--kind", "corner", "--radius", "4"},
                                                                 {"--kind", "circle", "--angle", "4"},
                                                                 {"--kind", "circle", "--feed", "0"},
                                                                 {"--feed", "100"},
                                                                 {"--group", "kanal_1"},
                                                                 {"--before", "nothing.axim"}}) {
    auto words = wrong;
    words.insert(words.begin(), {"plot", "m.axim"});
    auto const outcome = run_axisc(words, there);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK_FALSE(outcome.err.empty());
  }
}

TEST_CASE("options of the response change its picture") {
  TemporaryFolder const folder;
  auto const there = compiled(folder);
  auto const plot = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"plot", "m.axim", "-o", "-"});
    return run_axisc(more, there);
  };
  std::string const plain = plot({}).out;
  CHECK_THAT(plain, Contains("magnitude [dB]") && Contains("group delay [ms]") && Contains("40 Hz"));
  CHECK_THAT(plot({"--mark", "17.5Hz"}).out, Contains("17.5 Hz"));
  CHECK_THAT(plot({"--magnitude", "linear"}).out, Contains(">magnitude<"));
  CHECK_THAT(plot({"--wrap"}).out, Contains(">-90<"));
  CHECK(plot({"--linear"}).out != plain);
  for (auto const& wrong : std::vector<std::vector<std::string>>{{"--kind", "step", "--mark", "5"},
                                                                 {"--mark", "501"},
                                                                 {"--mark", "x"},
                                                                 {"--axis", "Q"},
                                                                 {"--kind", "foo"}}) {
    auto const outcome = plot(wrong);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK_FALSE(outcome.err.empty());
  }
  CHECK_THAT(run_axisc({"plot", "m.axim"}, there).out, StartsWith("Frequency response"));
  CHECK(run_axisc({"plot", "m.axim", "-o", "m.axim"}, there).status == 2);
}

TEST_CASE("a picture without a filter says so") {
  TemporaryFolder const folder;
  folder.write("x.lis", "kopf.achs_nr 1\n");
  auto const there = in_folder(folder.path());
  auto const outcome = run_axisc({"plot", "x.lis", "--cycle-time", "1ms", "-o", "-", "--lang", "de"}, there);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("Keine Achse hat einen Filter"));
  auto const step = run_axisc({"plot", "x.lis", "--cycle-time", "1ms", "-o", "-", "--kind", "step"}, there);
  CHECK(step.status == 0);
  CHECK_THAT(step.out, !Contains("nan") && !Contains("inf"));
}

TEST_CASE("errors in lists are printed, and nothing is drawn") {
  TemporaryFolder const folder;
  folder.write("x.lis", "filter[0].enable 1\nfilter[0].order 99\n");
  auto const outcome =
      run_axisc({"plot", "x.lis", "--cycle-time", "1ms", "-o", "p.svg"}, in_folder(folder.path()));
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("AX3001"));
  CHECK_FALSE(outcome.err.empty());
}

TEST_CASE("a recording's picture shows the deviation that compare names") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  std::string const scope = AXISC_SOURCE_DIR "/samples/recording/";
  auto const told = json::parse(
      run_axisc({"compare", scope + "x.lis", scope + "scope.csv", "--cycle-time", "1ms", "--format", "json"},
                there)
          .out);
  std::vector<std::string> const plot{"plot", scope + "x.lis", "--cycle-time", "1ms", "--kind", "compare"};
  auto const with = [&](std::vector<std::string> const& more) {
    auto words = plot;
    words.insert(words.end(), more.begin(), more.end());
    return run_axisc(words, there);
  };
  std::string const svg = with({"--recording", scope + "scope.csv", "-o", "-"}).out;
  // The second panel has the difference in µm: its highest and lowest points are the largest deviation apart
  // from 0.
  auto const second = svg.find("class=\"curve before", svg.find("class=\"curve before") + 1);
  REQUIRE(second != std::string::npos);
  auto const drawn = places_of(svg, second);
  auto const [top, bottom] =
      std::minmax_element(drawn.begin(), drawn.end(), [](Place a, Place b) { return a.y < b.y; });
  double const zero = drawn.front().y;
  double const reach = std::max(zero - top->y, bottom->y - zero) / (bottom->y - top->y);
  CHECK(reach > 0.4);
  CHECK_THAT(svg, Contains(told["fitting"][0]["meaning"].get<std::string>()));
  CHECK_THAT(svg, Contains("µm"));
  auto const table = with({"--recording", scope + "scope.csv", "--table"});
  CHECK(table.status == 0);
  CHECK_THAT(table.out, Contains("11.8"));
  for (auto const& wrong :
       std::vector<std::vector<std::string>>{{},
                                             {"--recording", "none.csv"},
                                             {"--recording", scope + "x.lis"},
                                             {"--recording", scope + "scope.csv", "--mark", "48"}}) {
    auto const outcome = with(wrong);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
  }
}

TEST_CASE("a picture of more axes than anybody tells apart is refused") {
  TemporaryFolder const folder;
  folder.write("x.lis", "filter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 20\nEnde\n");
  auto const there = in_folder(folder.path());
  auto const write = [&folder](int count) {
    std::string axes;
    for (int i = 0; i < count; ++i) {
      axes += (i == 0 ? "" : ", ") + R"({"name": "A)"s + std::to_string(i) + R"(", "list": "x.lis"})";
    }
    folder.write("m.json", R"({"machine": "m", "cycle_time_us": 1000, "axes": [)" + axes + "]}");
  };
  write(101);
  for (std::string const kind : {"response", "step", "delay", "dynamics"}) {
    auto const outcome = run_axisc({"plot", "m.json", "--kind", kind, "-o", "p.svg"}, there);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains("a picture shows at most 100 axes, not 101; choose one with --axis"));
    CHECK(run_axisc({"plot", "m.json", "--kind", kind, "--axis", "A100", "-o", "p.svg"}, there).status == 0);
  }
  write(100);
  CHECK(run_axisc({"plot", "m.json", "--kind", "delay", "-o", "p.svg"}, there).status == 0);
}

TEST_CASE("the delay is that with FIR filters on, as AX4011 compares it, and beside it that of start-up") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  // Programs switch the filters on: half of the orders, 20 and 10 cycles of 1 ms.
  std::string const off = "kenngr.achs_typ 1\nfilter_fir.enable 0\nfilter_fir.type 1\nfilter_fir.order ";
  folder.write("x.lis", off + "40\nEnde\n");
  folder.write("y.lis", off + "20\nEnde\n");
  folder.write("machine.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"},
    {"name": "Y", "list": "y.lis"}], "groups": [{"name": "path", "axes": ["X", "Y"]}]})");
  CHECK_THAT(run_axisc({"lint", "machine.json"}, there).out, Contains("AX4011") && Contains("10 ms"));
  auto const plot = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"plot", "machine.json", "--kind", "delay"});
    return run_axisc(more, there).out;
  };
  /// Cells of a table without their blanks.
  auto const rows = [](std::string const& table) {
    std::vector<std::string> found;
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) {
      std::string cells;
      for (char const letter : line) {
        if (letter != ' ' || (!cells.empty() && cells.back() != ' ')) cells += letter;
      }
      found.push_back(cells);
    }
    return found;
  };
  std::vector<std::string> wanted{"X FIR/HSC filter 20", "X sum 20", "X sum at start-up 0",
                                  "Y FIR/HSC filter 10", "Y sum 10", "Y sum at start-up 0"};
  auto const table = rows(plot({"--table"}));
  for (auto const& row : wanted) {
    INFO(row);
    CHECK(std::find(table.begin(), table.end(), row) != table.end());
  }
  CHECK_THAT(plot({"-o", "-"}), Contains("all filters on: X, Y") &&
                                    Contains("X 20 ms, at start-up 0 ms; Y 10 ms, at start-up 0 ms"));
  // What --at switches is shown alone.
  CHECK_THAT(plot({"-o", "-", "--at", "0:#FILTER OFF"}), Contains("No axis has a delay."));
  auto const report = run_axisc({"report", "machine.json", "-o", "r.html"}, there);
  CHECK_THAT(folder.read("r.html"), Contains("X 20 ms, at start-up 0 ms"));
  // On from start-up there is one delay.
  for (std::string const list : {"x.lis", "y.lis"}) {
    auto text = folder.read(list);
    text.replace(text.find("enable 0"), 8, "enable 1");
    folder.write(list, text);
  }
  CHECK_THAT(plot({"-o", "-"}), Contains("X 20 ms; Y 10 ms") && !Contains("start-up"));
}

}  // namespace plot_test
