// The report says what lint, inspect, contour and diff say, and nothing in it needs a network, a script or
// trust.
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

using Rows = std::vector<std::vector<std::string>>;

/// The texts of the first table after `mark`, its headings first.
Rows table_after(std::string const& html, std::string const& mark) {
  auto const begin = html.find("<table", html.find(mark));
  REQUIRE(begin != std::string::npos);
  std::string const table = html.substr(begin, html.find("</table>", begin) - begin);
  Rows rows;
  for (auto row = table.find("<tr>"); row != std::string::npos; row = table.find("<tr>", row + 1)) {
    auto const end = table.find("</tr>", row);
    auto& cells = rows.emplace_back();
    for (auto at = table.find("<t", row + 1); at < end; at = table.find("<t", at + 1)) {
      auto const inner = table.find('>', at) + 1;
      cells.push_back(text_of("<body>" + table.substr(inner, table.find("</t", inner) - inner)));
    }
  }
  return rows;
}

/// The cell of the row that begins with `name`, in the column whose heading begins with `heading`.
std::string cell(Rows const& rows, std::string const& name, std::string const& heading) {
  for (auto const& row : rows) {
    if (row.front() != name) continue;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (rows.front()[i].starts_with(heading)) return row[i];
    }
  }
  FAIL("no cell " << name << ", " << heading);
  return {};
}

std::size_t count_of(std::string const& text, std::string const& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

std::string fixed(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << value;
  return text.str();
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

TEST_CASE("the overview says of equal axes once what contour and its budget say") {
  TemporaryFolder const folder;
  auto const html = report_of({mill, "--feed", "1500,3000", "--radius", "7", "--tolerance", "0.05"}, folder);
  auto const overview = table_after(html, "What do the filters cost?");
  auto const said =
      json::parse(run_axisc({"contour", mill, "--feed", "3000", "--radius", "7", "--format", "json"}).out);
  auto const& group = said["groups"][0];
  auto const largest = [](json const& figures) {
    double error = 0;
    for (auto const& axis : figures["axis_error_um"]) error = std::max(error, axis.get<double>());
    return error;
  };
  std::string const axes = "X, Y, Z";
  CHECK(cell(overview, axes, "corner of 90°") == fixed(largest(group)));
  CHECK(cell(overview, axes, "circle, r 7 mm") == fixed(largest(group["circle"])));
  CHECK(cell(overview, axes, "margin to 0.05 mm") == fixed(50 - largest(group)));
  CHECK(cell(overview, "S", "corner of 90°").empty());
  auto const budget = json::parse(run_axisc({"contour", mill, "--budget", "--format", "json"}).out);
  for (auto const& axis : budget["delay_budget"]["axes"]) {
    bool const is_start = axis["state"] == "start";
    auto const name = axis["axis"] == "S" ? std::string("S") : axes;
    if (name == "S" && is_start)
      CHECK(cell(overview, name, "delay") == rounded(axis["position_ms"].get<double>()));
    if (name != "S") {
      CHECK(cell(overview, name, is_start ? "from start-up" : "delay") ==
            rounded(axis["position_ms"].get<double>()));
    }
  }
  // The lists say 42 Hz, 60 Hz, and a filter_fir that a program switches on.
  CHECK_THAT(cell(overview, axes, "filters"),
             Contains("band-stop 42 Hz, low-pass 60 Hz, ") && Contains("(once switched on)"));
  // The finding is in the default list, so that it belongs to none of them.
  CHECK(cell(overview, axes, "findings") == "0");
  CHECK(cell(overview, "several axes, machine", "findings") == "1");
  CHECK_THAT(html, Contains("Not at 3000 mm/min: the tolerance of 0.05 mm is exceeded"));
  auto const limits = json::parse(run_axisc({"contour", mill, "--feed", "1500", "--radius", "7",
                                             "--tolerance", "0.05", "--format", "json"})
                                      .out);
  CHECK_THAT(html, Contains("at the corner up to " + fixed(limits["groups"][0]["allowed_feed_mm_per_min"])));
}

TEST_CASE("equal axes are drawn once, others are not") {
  TemporaryFolder const folder;
  auto const html = report_of({mill}, folder);
  CHECK(count_of(html, ">Frequency response: ") == 2 * 2);  // the title, and what readers see
  CHECK(count_of(html, ">Frequency response: X, Y, Z<") == 2);
  CHECK(count_of(html, "<h3 id=\"axis-") == 2);
  // What each list sets stays its own.
  for (std::string const axis : {"X", "Y", "Z", "S"}) {
    CHECK(count_of(html, "<summary>" + axis + ": what its lists set, and where</summary>") == 1);
  }
  for (std::string const name :
       {"machine.json", "default.lis", "x.lis", "y.lis", "z.lis", "spindle.lis", "part.nc"}) {
    std::string text = read_source_file("samples/mill/" + name);
    if (name == "y.lis") text.insert(0, "filter[1].fg_f0 61\n");
    folder.write("other/" + name, text);
  }
  auto const other = report_of({"other/machine.json"}, folder);
  CHECK(count_of(other, "<h3 id=\"axis-") == 3);
  CHECK_THAT(other, Contains(">Frequency response: X, Z<") && Contains(">Frequency response: Y<"));
  // Equal now, but not before.
  auto const changed = report_of({mill, "--before", "other/machine.json"}, folder);
  CHECK(count_of(changed, "<h3 id=\"axis-") == 3);
}

TEST_CASE("the cover says what options and machine file say, and the options win") {
  TemporaryFolder const folder;
  folder.write("x.lis", "filter[0].enable 0\n");
  folder.write("m.json",
               R"({"machine": "Fräse <4711>", "cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}],
 "report": {"customer": "Nordwerk", "author": "I. Petersen", "date": "2026-11-27", "tolerance_mm": 0.02}})");
  auto const html = report_of({"m.json", "--customer", "Südwerk & Co"}, folder);
  check_nesting(html);
  CHECK_THAT(
      html, Contains("<h1>Fräse &lt;4711&gt;</h1>") && Contains("Südwerk &amp; Co") && !Contains("Nordwerk"));
  CHECK_THAT(html, Contains("I. Petersen") && Contains("2026-11-27") &&
                       Contains("\"Fräse \\3C 4711> · 2026-11-27\""));
  auto const german = report_of({"m.json", "--title", "Abnahme", "--lang", "de"}, folder);
  CHECK_THAT(german, Contains("<h1>Abnahme</h1>") && Contains("Ja, soweit es ihre Listen zeigen") &&
                         Contains("Nordwerk") && Contains("Für den Kunden"));
  SECTION("a start-up list has the name of the folder that was named") {
    auto const named = report_of({AXISC_SOURCE_DIR "/samples/controller/listen/"}, folder);
    CHECK_THAT(named, Contains("<h1>listen</h1>"));
  }
  SECTION("one line of visible text, or none") {
    for (std::string const option : {"--title", "--customer", "--author", "--date"}) {
      auto const refused =
          run_axisc({"report", "m.json", option, "a\nb", "-o", "no.html"}, in_folder(folder.path()));
      CHECK(refused.status == 2);
      CHECK_THAT(refused.err, Contains(option));
    }
    folder.write("bad.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}],
 "report": {"custmer": "a", "tolerance_mm": 0, "date": "a\nb"}})");
    auto const linted = run_axisc({"lint", "bad.json", "--color", "never"}, in_folder(folder.path()));
    CHECK(linted.status == 1);
    CHECK_THAT(linted.out, Contains("unknown key \"custmer\"") && Contains("tolerance_mm") &&
                               Contains("\"date\" must not"));
  }
}

TEST_CASE("findings of one rule stand together, the worst first") {
  TemporaryFolder const folder;
  std::string axes;
  for (int i = 0; i < 12; ++i) {
    auto const name = "a" + std::to_string(i);
    folder.write(name + ".lis", "kopf.achs_nr " + std::to_string(i + 1) +
                                    "\nfilter[0].order 99\nfilter[0].enable 1\nfilter[0].frequenz 3\n");
    axes += std::string(i > 0 ? "," : "") + R"({"name": ")" + name + R"(", "list": ")" + name + R"(.lis"})";
  }
  folder.write("m.json", R"({"cycle_time_us": 1000, "axes": [)" + axes + "]}");
  auto const html = report_of({"m.json"}, folder, 1);
  auto const table = table_after(html, "What must be done?");
  auto const order = text_of("<body>" + html.substr(html.find("id=\"findings\"")));
  CHECK(cell(table, "error", "places") == "12");
  REQUIRE(table.size() > 1);
  CHECK(table[1][0] == "error");
  CHECK(count_of(html, ", 12 places)</h3>") >= 1);
  CHECK_THAT(order, Contains("and 5 more"));
  CHECK_THAT(html, Contains("No: errors: 24"));
}

TEST_CASE("of several channels the cover has a table, and the costliest axes where not all fit") {
  TemporaryFolder const folder;
  json machine{{"cycle_time_us", 1000}, {"axes", json::array()}, {"groups", json::array()}};
  for (int channel = 0; channel < 4; ++channel) {
    auto axes = json::array();
    for (int i = 0; i < 4; ++i) {
      auto const name = std::string(1, "XYZA"[i]) + std::to_string(channel + 1);
      auto const number = 4 * channel + i + 1;
      folder.write(name + ".lis",
                   "kopf.achs_nr " + std::to_string(number) +
                       "\nkenngr.achs_typ 1\nfilter[0].enable 1\nfilter[0].type LOWPASS\n"
                       "filter[0].order 2\nfilter[0].prototype CRIT_DAMPING\nfilter[0].fg_f0 " +
                       std::to_string(70 - number) + "\n");
      machine["axes"].push_back({{"name", name}, {"list", name + ".lis"}});
      axes.push_back(name);
    }
    machine["groups"].push_back({{"name", "Channel " + std::to_string(channel + 1)}, {"axes", axes}});
  }
  folder.write("m.json", machine.dump());
  auto const html = report_of({"m.json", "--tolerance", "0.05"}, folder);
  check_nesting(html);
  auto const contour = json::parse(
      run_axisc({"contour", "m.json", "--feed", "4000", "--tolerance", "0.05", "--format", "json"},
                in_folder(folder.path()))
          .out);
  auto const channels = table_after(html, "the contour of each channel is off by");
  REQUIRE(contour["groups"].size() == 4);
  std::pair<double, std::string> costliest;
  for (auto const& group : contour["groups"]) {
    for (auto const& errors : {group["axis_error_um"], group["circle"]["axis_error_um"]}) {
      for (auto const& [axis, error] : errors.items()) {
        costliest = std::max(costliest, std::pair(error.get<double>(), axis));
      }
    }
    std::string const name = group["group"];
    std::ostringstream corner;
    corner << std::fixed << std::setprecision(1) << group["contour_deviation_um"].get<double>();
    CHECK(cell(channels, name, "corner of 90° [µm]") == corner.str());
    std::ostringstream feed;
    feed << std::fixed << std::setprecision(0) << group["allowed_feed_mm_per_min"].get<double>();
    CHECK(cell(channels, name, "tolerance kept at the corner up to [mm/min]") == feed.str());
  }
  // The page has no room for all sixteen.
  auto const cover = html.substr(0, html.find("</header>"));
  auto const overview = table_after(cover, "class=\"overview\"");
  CHECK(overview.size() < 1 + 16);
  CHECK(overview.at(1).at(0) == costliest.second);
  CHECK(table_after(html, "id=\"overview\"").size() == 1 + 16);
}

TEST_CASE("a cover has room for any title and any number of changes") {
  TemporaryFolder const folder;
  std::string machine;
  for (std::string const state : {"old", "new"}) {
    std::string axes;
    for (int i = 0; i < 40; ++i) {
      auto const name = "a" + std::to_string(i);
      folder.write(state + "/" + name + ".lis", "kopf.achs_nr " + std::to_string(i + 1) +
                                                    "\nfilter[0].enable 1\n" + "filter[0].fg_f0 " +
                                                    std::to_string(state == "old" ? 30 : 40 + i) + "\n");
      axes += std::string(i > 0 ? "," : "") + R"({"name": ")" + name + R"(", "list": ")" + name + R"(.lis"})";
    }
    folder.write(state + "/m.json", R"({"cycle_time_us": 1000, "axes": [)" + axes + "]}");
  }
  std::string title;
  for (int i = 0; i < 100; ++i) title += "milling machine ";
  auto const html = report_of({"new/m.json", "--before", "old/m.json", "--title", title}, folder);
  check_nesting(html);
  auto const cover = html.substr(0, html.find("</header>"));
  CHECK_THAT(cover, Contains("<h1 class=\"long\">milling") && Contains("…</h1>"));
  auto const changed = table_after(cover, "What has changed?");
  CHECK(changed.size() > 2);
  CHECK(changed.size() < 20);
  CHECK_THAT(html, Contains("<title>" + title));
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
  // First of all, once for the axes of the default list.
  auto const first = table_after(html, "What has changed?");
  REQUIRE(first.size() == 2);
  CHECK(first[1][0] == "X, Y, Z, S");
  CHECK(first[1][1] == "filter[0].fg_f0");
  CHECK_THAT(first[1][2], Contains("48") && Contains("42"));
  CHECK(html.find("What has changed?") < html.find("What do the filters cost?"));
  CHECK_THAT(text, Contains("none of the changed parameters is documented to need a restart of the control"));
  auto const same = text_of(report_of({mill, "--before", mill}, folder));
  CHECK_THAT(same, Contains("mean the same"));
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
  // After more than 500 of one rule another one is still shown in full.
  folder.write("x.lis", list + "filter[1].fg_f0 40Hz\n");
  auto const text = text_of(report_of({"x.lis", "--cycle-time", "1ms"}, folder, 1));
  CHECK_THAT(text, Contains("more findings"));
  CHECK_THAT(text, Contains("x.lis:1001:"));
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

TEST_CASE("a tolerance that cannot be judged is not called kept") {
  TemporaryFolder const folder;
  auto const list = [](std::string const& type) {
    return "kenngr.achs_typ 1\ngetriebe[0].dynamik.vb_max 500000\nfilter[0].enable 1\nfilter[0].order "
           "2\nfilter[0].type " +
           type + "\nfilter[0].prototype CRIT_DAMPING\nfilter[0].fg_f0 30\nfilter[0].share_percent 100\n";
  };
  folder.write("x.lis", list("LOWPASS"));
  folder.write("h.lis", list("HIGHPASS"));
  folder.write("k.lis", list("HIGHPASS"));
  folder.write("m.json", R"({"machine": "m", "cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"},
    {"name": "H", "list": "h.lis"}, {"name": "K", "list": "k.lis"}], "groups": [{"axes": ["X", "H", "K"]}]})");
  REQUIRE(run_axisc({"contour", "m.json", "--tolerance", "0.01"}, in_folder(folder.path())).status == 2);
  auto const text = text_of(report_of({"m.json", "--tolerance", "0.01"}, folder));
  CHECK_THAT(text, Contains("Whether the tolerance of 0.01 mm is kept cannot be told"));
  CHECK_THAT(text, Contains("H, K: a filter does not let a constant position pass"));
  CHECK_THAT(text, !Contains("- (H)"));
}

TEST_CASE("the report compares lists in their machines, and assures only what it has looked at") {
  TemporaryFolder const folder;
  for (std::string const state : {"old", "new"}) {
    folder.write(state + "/x.lis", "kopf.achs_nr 1\nkopf.log_achs_name X\nkenngr.achs_typ 1\n");
    folder.write(
        state + "/default.lis",
        "filter[0].enable 1\nfilter[0].order 2\nfilter[0].type LOWPASS\nfilter[0].prototype CRIT_DAMPING\n"
        "filter[0].fg_f0 " +
            std::string(state == "old" ? "30" : "20") + "\nfilter[0].share_percent 100\n");
    folder.write(state + "/m.json", R"({"machine": "m", "cycle_time_us": 1000, "default_list": "default.lis",
      "axes": [{"name": "X", "list": "x.lis"}]})");
  }
  auto const changed = text_of(report_of({"new/x.lis", "--before", "old/x.lis"}, folder));
  CHECK_THAT(changed, Contains("30 → 20"));
  CHECK_THAT(changed, !Contains("mean the same"));
  folder.write("new/default.lis", folder.read("old/default.lis"));
  folder.write("new/m.json", R"({"machine": "m", "cycle_time_us": 2000, "default_list": "default.lis",
    "axes": [{"name": "X", "list": "x.lis"}]})");
  CHECK_THAT(text_of(report_of({"new/m.json", "--before", "old/m.json"}, folder)),
             !Contains("need a restart"));
}
