// The report says what lint, inspect, contour and diff say, and nothing in it needs a network, a script or trust.
#include "cli/compiled_machine.hpp"
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>
#include <iomanip>
#include <sstream>

#include <nlohmann/json.hpp>

using namespace axisc::test;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

std::string const mill = AXISC_SOURCE_DIR "/samples/mill/machine.json";
std::string const mistakes = AXISC_SOURCE_DIR "/samples/mistakes/controller";

std::string report_of(std::vector<std::string> words, TemporaryFolder const& folder, int status = 0) {
  words.insert(words.begin(), "report");
  words.insert(words.end(), {"-o", "r.html"});
  auto const outcome = run_axisc(words, in_folder(folder.path()));
  CHECK(outcome.status == status);
  CHECK(outcome.out.empty());
  return folder.read("r.html");
}

/// What a browser shows: without tags, entities decoded.
std::string text_of(std::string const& html) {
  std::string const body = html.substr(html.find("<body>"), html.find("<script>") - html.find("<body>"));
  std::string text;
  bool in_tag = false;
  for (char const letter : body) {
    if (letter == '<') in_tag = true;
    if (!in_tag) text += letter;
    if (letter == '>') in_tag = false;
  }
  for (auto const& [entity, letter] : std::vector<std::pair<std::string, std::string>>{
           {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}}) {
    for (auto at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1)) {
      text.replace(at, entity.size(), letter);
    }
  }
  return text;
}

/// Every tag is closed, in the right order.
void check_nesting(std::string const& html) {
  std::vector<std::string> open{"html"};
  std::string body = html.substr(html.find("<body>"));
  if (auto const script = body.find("<script>"); script != std::string::npos) {
    body.erase(script, body.find("</script>") + std::string("</script>").size() - script);
  }
  for (auto at = body.find('<'); at != std::string::npos; at = body.find('<', at + 1)) {
    auto const end = body.find('>', at);
    REQUIRE(end != std::string::npos);
    bool const closes = body[at + 1] == '/';
    auto const begin = at + (closes ? 2 : 1);
    std::string const name = body.substr(begin, body.find_first_of(" >/", begin) - begin);
    if (body[end - 1] == '/') continue;
    if (!closes) {
      open.push_back(name);
      continue;
    }
    REQUIRE_FALSE(open.empty());
    if (open.back() != name) FAIL("</" << name << "> closes <" << open.back() << ">");
    open.pop_back();
  }
  CHECK(open.empty());
}

std::string rounded(double value) {
  std::ostringstream text;
  text << std::setprecision(4) << value;
  return text.str();
}

}  // namespace

TEST_CASE("the report's findings are those of lint, in both languages") {
  TemporaryFolder const folder;
  for (std::string const language : {"en", "de"}) {
    auto const linted = run_axisc({"lint", mistakes, "--lang", language, "--color", "never"});
    auto const text = text_of(report_of({mistakes, "--lang", language}, folder, 1));
    std::istringstream lines(linted.out);
    std::size_t compared = 0;
    for (std::string line; std::getline(lines, line);) {
      if (line.find("-->") == std::string::npos && line.find("[AX") == std::string::npos) continue;
      CHECK_THAT(text, Contains(line));
      ++compared;
    }
    CHECK(compared > 20);
  }
}

TEST_CASE("the report's figures are those of inspect and contour") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  auto const text = text_of(report_of({mill, "--feed", "1500", "--radius", "7"}, folder));
  REQUIRE(run_axisc({"compile", mill, "-o", "m.axim", "--quiet"}, there).status == 0);
  auto const inspected = json::parse(run_axisc({"inspect", "m.axim", "--format", "json"}, there).out);
  for (auto const& axis : inspected["axes"]) {
    if (axis["filters"].empty()) continue;
    auto const& chain = axis["chain"];
    CHECK_THAT(text, Contains(rounded(axis["delay_ms"].get<double>())));
    CHECK_THAT(text, Contains(rounded(chain["corner_frequency_hz"].get<double>())));
    CHECK_THAT(text, Contains(rounded(chain["overshoot_percent"].get<double>())));
    for (auto const& value : axis["values"]) {
      CHECK_THAT(text, Contains(value["name"].get<std::string>()));
    }
  }
  auto const said = json::parse(
      run_axisc({"contour", mill, "--feed", "1500", "--radius", "7", "--format", "json"}, there).out);
  for (auto const& group : said["groups"]) {
    CHECK_THAT(text, Contains(rounded(group["contour_deviation_um"].get<double>())));
    CHECK_THAT(text, Contains(rounded(group["circle"]["contour_deviation_um"].get<double>())));
  }
}

TEST_CASE("the report's programs are those of simulate") {
  TemporaryFolder const folder;
  auto const html = report_of({mill, "--lang", "de"}, folder);
  check_nesting(html);
  auto const text = text_of(html);
  auto const simulated = json::parse(
      run_axisc({"simulate", mill, "--program", AXISC_SOURCE_DIR "/samples/mill/part.nc", "--format", "json"})
          .out);
  REQUIRE(simulated["passes"].size() == 5);
  for (auto const& pass : simulated["passes"]) {
    std::ostringstream deviation;
    deviation << std::fixed << std::setprecision(4) << pass["max_contour_deviation_um"].get<double>();
    auto german = deviation.str();
    german.replace(german.find('.'), 1, ",");
    CHECK_THAT(text, Contains(german));
  }
  CHECK_THAT(text, Contains("Bahn von part.nc, Ebene X/Y") && Contains("AX9007"));
  SECTION("of each channel, and what cannot be followed says why") {
    std::filesystem::copy(AXISC_SOURCE_DIR "/samples/controller", folder.path() + "/listen",
                          std::filesystem::copy_options::recursive);
    folder.write("listen/prog/init.nc", "#FILTER ON [ORDER=10]\nG01 X1 F100\nG41 X2\nM17\n");
    auto const refused = text_of(report_of({"listen"}, folder));
    CHECK_THAT(refused, Contains("init.nc in channel Fraesen") && Contains("The program is not followed:") &&
                            Contains("AX9008") && Contains("G41"));
  }
}

TEST_CASE("a report is one file that refers to no other, whose tags fit") {
  TemporaryFolder const folder;
  for (auto const& words : std::vector<std::vector<std::string>>{
           {mill}, {AXISC_SOURCE_DIR "/samples/controller", "--lang", "de"}}) {
    auto const html = report_of(words, folder);
    check_nesting(html);
    CHECK_THAT(html, !Contains("src=") && !Contains("<link") && !Contains("url("));
    CHECK_THAT(html, !Contains(">nan") && !Contains("inf ") && !Contains(AXISC_BINARY_DIR));
    CHECK(report_of(words, folder) == html);
  }
  auto const broken = report_of({mistakes}, folder, 1);
  check_nesting(broken);
  CHECK_THAT(broken, !Contains("<svg"));
}

TEST_CASE("what lists say is text in a report") {
  TemporaryFolder const folder;
  folder.write("x.lis",
               "kopf.log_achs_name <script>alert(1)</script>\nfilter[0].enable 1\nfilter[0].type LOWPASS\n"
               "filter[0].fg_f0 50 ( </pre><img src=x onerror=alert(2)>\nfilter[0].order 99 ( <b>\n");
  auto const html = report_of({"x.lis", "--cycle-time", "1ms"}, folder, 1);
  check_nesting(html);
  CHECK_THAT(html,
             !Contains("<script>alert") && !Contains("<img") && !Contains("<b>") && Contains("&lt;b&gt;"));
}

TEST_CASE("a report of a change says each parameter and what it does") {
  TemporaryFolder const folder;
  for (std::string const name :
       {"machine.json", "default.lis", "x.lis", "y.lis", "z.lis", "spindle.lis", "part.nc"}) {
    std::string text = read_source_file("samples/mill/" + name);
    if (name == "default.lis") {
      auto const begin = text.find("filter[0].fg_f0");
      text.replace(begin, text.find('\n', begin) - begin, "filter[0].fg_f0 48");
    }
    folder.write("old/" + name, text);
  }
  auto const html = report_of({mill, "--before", "old/machine.json"}, folder);
  check_nesting(html);
  auto const text = text_of(html);
  auto const changes = text.substr(text.find("Changes", text.find("Changes") + 1));
  CHECK_THAT(changes, Contains("filter[0].fg_f0") && Contains("48") && Contains("42"));
  CHECK_THAT(html, Contains("class=\"curve before"));
}

TEST_CASE("sixteen axes fit into two megabytes") {
  TemporaryFolder const folder;
  json machine{{"cycle_time_us", 1000}, {"axes", json::array()}};
  for (int i = 0; i < 16; ++i) {
    std::string const name = "a" + std::to_string(i);
    folder.write(name + ".lis",
                 "kopf.achs_nr " + std::to_string(i + 1) +
                     "\nfilter[0].enable 1\nfilter[0].type BANDSTOP\nfilter[0].order 2\nfilter[0].fg_f0 " +
                     std::to_string(20 + i) +
                     "\nfilter[0].guete 2\nfilter[0].prototype BESSEL\nfilter[1].enable 1\n"
                     "filter[1].type LOWPASS\nfilter[1].order 4\nfilter[1].fg_f0 60\n");
    machine["axes"].push_back({{"name", name}, {"list", name + ".lis"}});
  }
  folder.write("m.json", machine.dump());
  auto const html = report_of({"m.json"}, folder);
  CHECK(html.size() < 2'000'000);
  CHECK(html.size() > 500'000);
}

TEST_CASE("of a thousand findings the first 500 are shown and the others counted") {
  TemporaryFolder const folder;
  std::string list;
  for (int i = 0; i < 1000; ++i) list += "filter[0].order 99\n";
  folder.write("x.lis", list);
  auto const text = text_of(report_of({"x.lis", "--cycle-time", "1ms"}, folder, 1));
  CHECK_THAT(text, Contains("more findings"));
}

TEST_CASE("a report needs an output that is none of its inputs") {
  TemporaryFolder const folder;
  folder.write("x.lis", "filter[0].enable 0\n");
  auto const there = in_folder(folder.path());
  for (auto const& words : std::vector<std::vector<std::string>>{{"report", "x.lis", "--cycle-time", "1ms"},
                                                                 {"report", "-o", "r.html"},
                                                                 {"report", "x.lis", "-o", "x.lis"},
                                                                 {"report", "none.lis", "-o", "r.html"},
                                                                 {"report", "x.lis", "-o", "r.html"}}) {
    auto const outcome = run_axisc(words, there);
    CHECK(outcome.status == 2);
    CHECK_FALSE(outcome.err.empty());
  }
  CHECK(folder.entries() == 1);
}
