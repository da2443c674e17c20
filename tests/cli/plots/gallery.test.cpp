// Every picture of docs/gallery.md is what the program draws from its sample.
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>
#include <set>
#include <sstream>

namespace gallery_test {

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

struct GalleryPicture {
  std::string name;
  std::vector<std::string> words;  ///< the input, then options
};

std::vector<GalleryPicture> const gallery = {
    {"lowpass", {"samples/manual/axis-lowpass.lis", "--cycle-time", "1ms"}},
    {"lowpass-step", {"samples/manual/axis-lowpass.lis", "--cycle-time", "1ms", "--kind", "step"}},
    {"bandstop", {"samples/manual/axis-bandstop.lis", "--cycle-time", "1ms"}},
    {"bandstop-step", {"samples/manual/axis-bandstop.lis", "--cycle-time", "1ms", "--kind", "step"}},
    {"pt1", {"samples/manual/axis-pt1.lis", "--cycle-time", "1ms"}},
    {"pt2", {"samples/manual/axis-pt2.lis", "--cycle-time", "1ms"}},
    {"time-delay", {"samples/manual/axis-time-delay.lis", "--cycle-time", "1ms"}},
    {"moving-average", {"samples/manual/fir-moving-average.lis", "--cycle-time", "1ms"}},
    {"moving-average-step",
     {"samples/manual/fir-moving-average.lis", "--cycle-time", "1ms", "--kind", "step"}},
    {"gaussian", {"samples/manual/fir-gaussian.lis", "--cycle-time", "1ms"}},
    {"windowed-sinc", {"samples/manual/fir-windowed-sinc.lis", "--cycle-time", "1ms"}},
    {"hsc-mean", {"samples/manual/hsc-mean.lis", "--cycle-time", "1ms", "--at", "0:#FILTER ON [HSC]"}},
    {"hsc-novib", {"samples/manual/hsc-novib.lis", "--cycle-time", "1ms", "--at", "0:#FILTER ON [HSC]"}},
    {"mill-response", {"samples/mill"}},
    {"mill-x", {"samples/mill", "--axis", "X"}},
    {"mill-step", {"samples/mill", "--kind", "step"}},
    {"mill-delay", {"samples/mill", "--kind", "delay"}},
    {"mill-corner", {"samples/mill", "--kind", "corner", "--feed", "1000,2000,4000"}},
    {"mill-circle", {"samples/mill", "--kind", "circle", "--feed", "2000,4000,8000"}},
    {"controller-response", {"samples/controller"}},
    {"controller-delay", {"samples/controller", "--kind", "delay"}},
    {"controller-corner", {"samples/controller", "--kind", "corner", "--feed", "1000,4000", "--angle", "60"}},
    {"controller-circle", {"samples/controller", "--kind", "circle", "--feed", "4000"}},
    {"unlike-corner", {"REPAIRED", "--kind", "corner", "--feed", "4000"}},
    {"unlike-circle", {"REPAIRED", "--kind", "circle", "--feed", "4000"}},
    {"unlike-response", {"REPAIRED"}},
    {"square-dynamics", {"samples/motion/square", "--kind", "dynamics"}},
    {"dynamics-x", {"samples/motion/dynamics", "--kind", "dynamics", "--axis", "X", "--distance", "10"}},
    {"guard-robustness", {"samples/motion/guard", "--kind", "robustness"}},
    {"rack-plant",
     {"samples/motion/rack", "--kind", "plant", "--plant", "samples/motion/rack/plant.json", "--move",
      "X:800:31800"}}};

/// The tutorial's machine as its page leaves it.
void write_repaired(TemporaryFolder const& folder) {
  for (std::string const name : {"machine.json", "x.lis", "y.lis"}) {
    std::string text = read_source_file("samples/tutorial/" + name);
    for (auto const& [wrong, right] :
         std::vector<std::pair<std::string, std::string>>{{"fgf0 ", "fg_f0"}, {"3000,0", "3000"}}) {
      if (auto const at = text.find(wrong); at != std::string::npos) text.replace(at, wrong.size(), right);
    }
    folder.write("repaired/" + name, text);
  }
}

/// A machine with an axis for each curve: its name, and what its list says of filter[0].
using FilterCurves = std::vector<std::pair<std::string, std::string>>;

void write_machine(TemporaryFolder const& folder, FilterCurves const& curves) {
  std::string axes;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    auto const& [name, filter] = curves[i];
    std::string list = "kopf.achs_nr " + std::to_string(i + 1) + "\nfilter[0].enable 1\n";
    std::istringstream lines(filter);
    for (std::string line; std::getline(lines, line, ',');) list += "filter[0]." + line + "\n";
    folder.write(name + ".lis", list);
    axes += (axes.empty() ? "" : ",") + std::string(R"({"name": ")") + name + R"(", "list": ")" + name +
            R"(.lis"})";
  }
  folder.write("m.json", R"({"cycle_time_us": 1000, "axes": [)" + axes + "]}");
}

FilterCurves prototypes(std::string const& filter) {
  FilterCurves curves;
  for (std::string const prototype : {"CRIT_DAMPING", "BESSEL", "BUTTERWORTH"}) {
    curves.emplace_back(prototype, "prototype " + prototype + "," + filter);
  }
  return curves;
}

FilterCurves orders(std::string const& filter, std::vector<int> const& numbers) {
  FilterCurves curves;
  for (int const order : numbers) {
    curves.emplace_back("order_" + std::to_string(order), "order " + std::to_string(order) + "," + filter);
  }
  return curves;
}

FilterCurves delays() {
  FilterCurves curves;
  for (std::string const time : {"400", "1700", "3000", "4400"}) {
    curves.emplace_back("time_" + time, "type TIME_DELAY,order 1,time_constant " + time);
  }
  return curves;
}

}  // namespace

TEST_CASE("the page on filters shows what the program draws", "[digits]") {
  TemporaryFolder const folder;
  std::string const lowpass = "type LOWPASS,fg_f0 15";
  std::string const bandstop = "type BANDSTOP,fg_f0 30,guete 2";
  struct Picture {
    std::string name;
    FilterCurves curves;
    std::string kind;
  };
  for (auto const& [name, curves, kind] : std::vector<Picture>{
           {"lowpass-prototypes-response", prototypes(lowpass + ",order 4"), "response"},
           {"lowpass-prototypes-step", prototypes(lowpass + ",order 4"), "step"},
           {"lowpass-orders-step", orders(lowpass + ",prototype CRIT_DAMPING", {1, 2, 4, 6}), "step"},
           {"bandstop-orders-response", orders(bandstop + ",prototype BUTTERWORTH", {1, 2, 3}), "response"},
           {"bandstop-prototypes-step", prototypes(bandstop + ",order 2"), "step"},
           {"allpass-prototypes-response", prototypes("type ALLPASS,fg_f0 15,order 4"), "response"},
           {"time-delay-response", delays(), "response"}}) {
    write_machine(folder, curves);
    auto const outcome = run_axisc({"plot", "m.json", "--kind", kind, "-o", "-"}, in_folder(folder.path()));
    CHECK(outcome.status == 0);
    check_golden("docs/filters/" + name + ".svg", outcome.out);
    CHECK_THAT(read_source_file("docs/filters.md"), Contains("(filters/" + name + ".svg)"));
  }
}

TEST_CASE("the gallery shows what the program draws from the samples", "[digits]") {
  TemporaryFolder const folder;
  write_repaired(folder);
  std::string const page = read_source_file("docs/gallery.md");
  std::set<std::string> known;
  for (auto const& [name, arguments] : gallery) {
    auto words = arguments;
    for (auto& word : words) {
      if (word.starts_with("samples/")) word = AXISC_SOURCE_DIR "/" + word;
    }
    if (words.front() == "REPAIRED") words.front() = "repaired/machine.json";
    words.insert(words.begin(), "plot");
    words.insert(words.end(), {"-o", "-"});
    auto const outcome = run_axisc(words, in_folder(folder.path()));
    CHECK(outcome.status == 0);
    check_golden("docs/pictures/gallery/" + name + ".svg", outcome.out);
    CHECK_THAT(page, Contains("(pictures/gallery/" + name + ".svg)"));
    known.insert(name + ".svg");
  }
  for (auto const& entry : std::filesystem::directory_iterator(AXISC_SOURCE_DIR "/docs/pictures/gallery")) {
    CHECK(known.contains(entry.path().filename().string()));
  }
}

}  // namespace gallery_test
