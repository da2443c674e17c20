// axisc.h gives what the program gives: the page and other languages see one verdict.
#include "axisc/axisc.h"
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/file_contents.hpp"
#include "support/golden.hpp"
#include "support/sarif_schema.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace interface_test {

using namespace axisc::test;

namespace {

namespace fs = std::filesystem;

std::string const samples = std::string(AXISC_SOURCE_DIR) + "/samples";

using Json = nlohmann::json;

class Opened {
 public:
  explicit Opened(std::string const& options = "{}", axisc_files const* files = nullptr)
      : status(axisc_open(options.c_str(), files, &workspace_)) {}
  Opened(Opened const&) = delete;
  Opened& operator=(Opened const&) = delete;
  ~Opened() { axisc_close(workspace_); }

  template <typename Function>
  std::string call(Function function, std::string const& text) {
    axisc_bytes bytes{};
    status = function(workspace_, text.c_str(), &bytes);
    std::string result(bytes.data != nullptr ? bytes.data : "", bytes.size);
    axisc_free(&bytes);
    return result;
  }
  std::string fix(std::string const& path) {
    auto const repair = [](axisc_workspace* workspace, char const* file, axisc_bytes* changed) {
      return axisc_fix(workspace, file, AXISC_FIX_SAFE, changed);
    };
    return call(repair, path);
  }
  std::string compile(std::string const& path, char const* options = nullptr) {
    auto const make = [options](axisc_workspace* workspace, char const* file, axisc_bytes* image) {
      return axisc_compile(workspace, file, options, image, nullptr);
    };
    return call(make, path);
  }
  void put(std::string const& path, std::string const& bytes) {
    status = axisc_put(workspace_, path.c_str(), bytes.data(), bytes.size());
  }
  std::string error() const { return axisc_error(workspace_); }
  axisc_workspace* get() { return workspace_; }

 private:
  axisc_workspace* workspace_ = nullptr;

 public:
  int status;
};

/// Without what the program alone says: its version, and fingerprints that count from a repository.
Json findings_in(std::string const& json) {
  return json.empty() ? Json() : Json::parse(json).at("diagnostics");
}

std::vector<std::string> complaints(std::string const& json, std::string const& schema) {
  return schema_complaints(json, read_source_file("docs/schemas/" + schema + ".schema.json"));
}

std::vector<std::string> lists_and_programs() {
  std::vector<std::string> paths;
  for (auto const& entry : fs::recursive_directory_iterator(samples)) {
    auto const extension = entry.path().extension();
    if (extension == ".lis" || extension == ".nc") paths.push_back(entry.path().string());
  }
  return paths;
}

}  // namespace

TEST_CASE("axisc.h finds in every sample what lint finds") {
  Opened opened;
  auto const paths = lists_and_programs();
  REQUIRE(paths.size() > 90);
  for (auto const& path : paths) {
    INFO(path);
    auto const found = findings_in(opened.call(axisc_check, path));
    auto const lint = run_axisc({"lint", "--format", "json", path});
    CHECK(found == findings_in(lint.out));
    CHECK((opened.status < 0 ? 2 : opened.status) == lint.status);
  }
}

TEST_CASE("axisc.h finds in a folder what lint finds") {
  Opened opened(R"({"language": "de"})");
  for (auto const* const folder : {"mistakes", "controller", "mill", "motion/rack"}) {
    INFO(folder);
    auto const path = samples + "/" + folder;
    CHECK(findings_in(opened.call(axisc_check, path)) ==
          findings_in(run_axisc({"lint", "--lang", "de", "--format", "json", path}).out));
  }
  opened.call(axisc_check, samples + "/none");
  CHECK(opened.status == AXISC_NOT_FOUND);
  CHECK(opened.error().find("nicht lesbar") != std::string::npos);
}

TEST_CASE("axisc.h compiles the image that compile writes") {
  TemporaryFolder const folder;
  auto const image = folder / "x.axim";
  for (auto const* const input : {"controller", "mill", "motion/rack"}) {
    INFO(input);
    auto const path = samples + "/" + input;
    Opened opened;
    auto const bytes = opened.compile(path);
    CHECK(opened.status == AXISC_OK);
    REQUIRE(run_axisc({"compile", "-o", image, path}).status == 0);
    CHECK(bytes == file_contents(image));
  }
  auto const mill = samples + "/mill";
  REQUIRE(
      run_axisc({"compile", "-o", image, mill, "--strip", "--no-bounds", "--image-version", "7"}).status ==
      0);
  Opened opened;
  CHECK(opened.compile(mill, R"({"strip": "yes", "bounds": "no", "image_version": "7"})") ==
        file_contents(image));
  CHECK(opened.compile(mill, R"({"image_version": "-1"})").empty());
  CHECK(opened.status == AXISC_BAD_ARGUMENT);
}

TEST_CASE("axisc.h gives the findings of what it compiles") {
  Opened opened;
  auto const list = samples + "/tutorial/machine.json";
  axisc_bytes image{};
  axisc_bytes findings{};
  CHECK(axisc_compile(opened.get(), list.c_str(), nullptr, &image, &findings) == AXISC_FINDINGS);
  CHECK(image.data == nullptr);
  CHECK(findings_in(std::string(findings.data, findings.size)) ==
        findings_in(opened.call(axisc_check, list)));
  CHECK(opened.status == AXISC_FINDINGS);
  CHECK(opened.error().empty());  // the findings say it
  axisc_free(&findings);
}

TEST_CASE("axisc.h repairs as lint --fix does, and writes nothing") {
  TemporaryFolder const folder;
  auto const list = folder / "typing.lis";
  fs::copy_file(samples + "/mistakes/typing.lis", list);
  auto const before = file_contents(list);
  Opened opened;
  auto const report = opened.fix(list);
  CHECK(complaints(report, "fix").empty());
  auto const repaired = opened.call(axisc_read, list);
  CHECK(file_contents(list) == before);
  auto const lint = run_axisc({"lint", "--fix", list});
  CHECK(repaired == file_contents(list));
  auto const parsed = Json::parse(report);
  CHECK(parsed.at("files") == Json::array({list}));
  CHECK_THAT(lint.out + lint.err, Catch::Matchers::Contains(parsed.at("fixed").dump() + " findings"));
  CHECK(Json::parse(opened.fix(list)) == Json{{"version", 1}, {"files", Json::array()}, {"fixed", 0}});
}

TEST_CASE("axisc.h takes unsaved text in the place of a file, and settings as they are now") {
  TemporaryFolder const folder;
  auto const list = folder / "x.lis";
  Opened opened(R"({"cycle_time": "1ms"})");
  opened.put(list, "kopf.achs_nr 01\n");
  CHECK(findings_in(opened.call(axisc_check, list)).at(0).at("code") == "AX1006");
  std::ofstream(folder / "axisc.json") << R"({"disable": ["AX1006"]})";
  CHECK(findings_in(opened.call(axisc_check, list)).empty());
  CHECK(axisc_drop(opened.get(), list.c_str()) == AXISC_OK);
  opened.call(axisc_check, list);
  CHECK(opened.status == AXISC_NOT_FOUND);
}

TEST_CASE("axisc.h answers in the formats of the commands", "[digits]") {
  Opened opened;
  auto const mill = samples + "/mill";
  auto const ask = [&](Json const& question) { return opened.call(axisc_answer, question.dump()); };
  CHECK(ask({{"question", "machine"}, {"input", mill}, {"format", "json"}}) ==
        run_axisc({"machine", "--format", "json", mill}).out);
  CHECK(ask({{"question", "contour"}, {"input", mill}, {"format", "csv"}}) ==
        run_axisc({"contour", "--format", "csv", mill}).out);
  CHECK(ask({{"question", "get"}, {"input", mill}, {"words", "X filter[0].order"}}) ==
        run_axisc({"get", mill, "X", "filter[0].order"}).out);
  auto const y = samples + "/tutorial/y.lis";
  CHECK(ask({{"question", "diff"}, {"before", y}, {"input", mill}}) == run_axisc({"diff", y, mill}).out);
  TemporaryFolder const folder;
  auto const image = folder / "mill.axim";
  REQUIRE(run_axisc({"compile", "-o", image, mill}).status == 0);
  auto const as_bytes = file_contents(image);
  for (auto const* const question : {"inspect", "response"}) {
    auto const wanted = run_axisc({question, image, "--axis", "X", "--format", "json"}).out;
    CHECK(ask({{"question", question}, {"input", image}, {"axis", "X"}, {"format", "json"}}) == wanted);
    opened.put("elsewhere.axim", as_bytes);
    auto answer =
        ask({{"question", question}, {"input", "elsewhere.axim"}, {"axis", "X"}, {"format", "json"}});
    CHECK(answer.size() > 100);
  }
  CHECK(ask({{"question", "explain"}, {"word", "AX3005"}, {"format", "markdown"}}) ==
        run_axisc({"explain", "AX3005"}).out);
  CHECK(ask({{"question", "report"}, {"input", mill}}) == run_axisc({"report", mill, "-o", "-"}).out);
  auto const recorded = samples + "/recording/";
  for (std::string const format : {"json", "markdown"}) {
    CHECK(ask({{"question", "compare"},
               {"input", recorded + "x.lis"},
               {"recording", recorded + "scope.csv"},
               {"format", format}}) ==
          run_axisc({"compare", recorded + "x.lis", recorded + "scope.csv", "--format", format}).out);
  }
  auto const resonance = samples + "/resonance/";
  CHECK(ask({{"question", "identify"},
             {"input", resonance + "x.lis"},
             {"recording", resonance + "moves.csv"},
             {"actual", "2"},
             {"format", "json"}}) == run_axisc({"identify", resonance + "x.lis", resonance + "moves.csv",
                                                "--actual", "2", "--format", "json"})
                                         .out);
  CHECK(ask({{"question", "picture"},
             {"kind", "compare"},
             {"input", recorded + "x.lis"},
             {"recording", recorded + "scope.csv"}}) ==
        run_axisc({"plot", recorded + "x.lis", "--kind", "compare", "--recording", recorded + "scope.csv",
                   "-o", "-"})
            .out);
  auto const fmu = folder / "mill.fmu";
  for (std::string const version : {"2", "3"}) {
    REQUIRE(run_axisc({"export", mill, "--to", "fmu" + version, "--binaries", "none", "-o", fmu}).status ==
            0);
    CHECK(ask({{"question", "fmu"}, {"input", mill + "/x.lis"}, {"version", version}, {"name", "mill"}}) ==
          file_contents(fmu));
  }
  CHECK(ask({{"question", "fmu"}, {"input", image}}).starts_with("PK"));
  for (auto const* const kind : {"response", "step", "delay", "corner", "circle"}) {
    INFO(kind);
    CHECK(ask({{"question", "picture"}, {"input", mill}, {"kind", kind}}) ==
          run_axisc({"plot", mill, "--kind", kind, "-o", "-"}).out);
  }
}

TEST_CASE("axisc.h answers about circles as the command does", "[digits]") {
  Opened opened(R"({"language": "de"})");
  auto const ask = [&](Json question) {
    question["question"] = "circle";
    return opened.call(axisc_answer, question.dump());
  };
  auto const command = [](std::vector<std::string> words) {
    words.insert(words.begin(), {"circle", "--lang", "de"});
    return run_axisc(words).out;
  };
  auto const mill = samples + "/mill";
  for (std::string const format : {"text", "json", "csv", "markdown", "html"}) {
    INFO(format);
    Json const question{{"input", mill},  {"feed", "1000,4000"}, {"radius", "50"},
                        {"plane", "X,Y"}, {"tolerance", "10"},   {"format", format}};
    CHECK(ask(question) == command({mill, "--feed", "1000,4000", "--radius", "50", "--plane", "XY",
                                    "--tolerance", "10", "--format", format}));
    CHECK(opened.status == AXISC_OK);  // whether or not a circle keeps the tolerance
  }
  auto const sample = samples + "/circle";
  auto const ccw = sample + "/ccw.csv";
  auto const cw = sample + "/cw.csv";
  Json const both{{"input", sample}, {"recording", {ccw, cw}}, {"format", "svg"}};
  CHECK(ask(both) == command({sample, ccw, cw, "-o", "-"}));
  Json const columns{{"input", sample}, {"recording", ccw},         {"setpoint", {"X=2", "Y=3"}},
                     {"unit", "mm"},    {"actual", {"X=4", "Y=5"}}, {"numbers", "raw"},
                     {"format", "json"}};
  auto const recorded = ask(columns);
  CHECK(recorded == command({sample, ccw, "--unit", "mm", "--raw", "--setpoint", "X=2", "--setpoint", "Y=3",
                             "--actual", "X=4", "--actual", "Y=5", "--format", "json"}));
  CHECK(complaints(recorded, "circle").empty());
}

TEST_CASE("axisc.h answers about the circles of axes that are out of step") {
  TemporaryFolder const folder;
  fs::copy(std::string(AXISC_SOURCE_DIR) + "/validator/rules/AX4011-group-delay-mismatch/fail", folder.path(),
           fs::copy_options::recursive);
  folder.write("axisc.json", R"({"severity": {"AX4011": "error"}})");
  auto const machine = folder / "machine.json";
  Opened opened;
  opened.put(folder / "y.lis", file_contents(folder / "y.lis") + " ");
  opened.call(axisc_answer, Json{{"question", "contour"}, {"input", machine}}.dump());
  CHECK(opened.status == AXISC_FINDINGS);
  Json const circle{{"question", "circle"}, {"input", machine}, {"feed", "1000"}, {"radius", "50"}};
  CHECK(opened.call(axisc_answer, circle.dump()) ==
        run_axisc({"circle", machine, "--feed", "1000", "--radius", "50"}).out);
  CHECK(opened.status == AXISC_OK);
}

TEST_CASE("axisc.h says what a circle lacks") {
  Opened opened;
  auto const sample = samples + "/circle";
  auto const refused = [&](Json question, int status) {
    question["question"] = "circle";
    question["input"] = sample;
    CHECK(opened.call(axisc_answer, question.dump()).empty());
    CHECK(opened.status == status);
    return opened.error();
  };
  using Catch::Matchers::Contains;
  CHECK_THAT(refused(Json::object(), AXISC_UNUSABLE), Contains("needs --feed and --radius"));
  CHECK_THAT(refused({{"feed", "fast"}, {"radius", "50"}}, AXISC_UNUSABLE), Contains("fast"));
  CHECK_THAT(refused({{"recording", sample + "/ccw.csv"}, {"setpoint", "2"}}, AXISC_UNUSABLE),
             Contains("X=COLUMN"));
  CHECK_THAT(refused({{"radius", {"50", "60"}}}, AXISC_BAD_ARGUMENT), Contains("\"radius\" is one text"));
  CHECK_THAT(refused({{"radius", {50}}}, AXISC_BAD_ARGUMENT), Contains("arrays of texts"));
  CHECK_THAT(refused({{"format", "pdf"}}, AXISC_BAD_ARGUMENT), Contains("html, svg"));
}

namespace {

/// The answer to `machines`, without its version.
Json machines_of(Opened& opened, std::string const& input) {
  auto const text = opened.call(
      axisc_answer, Json({{"question", "machines"}, {"input", input}, {"format", "json"}}).dump());
  INFO(opened.error());
  REQUIRE(opened.status == AXISC_OK);
  CHECK(complaints(text, "machines").empty());
  return Json::parse(text).at("machines");
}

}  // namespace

TEST_CASE("axisc.h finds the machines of a folder and of a file, and what says their cycle time") {
  Opened opened(R"({"cycle_time": "3ms"})");
  auto const mill = samples + "/mill/machine.json";
  auto const of_list = machines_of(opened, samples + "/mill/y.lis");
  REQUIRE(of_list.size() == 1);
  CHECK(of_list[0] == Json{{"path", mill},
                           {"machine", "mill-3ax"},
                           {"axes", {"X", "Y", "Z", "S"}},
                           {"alone", false},
                           {"axis", "Y"},
                           {"cycle_time_us", 1000},
                           {"cycle_time_from", mill}});
  auto of_folder = machines_of(opened, samples + "/mill");
  CHECK(of_folder[0].at("axis") == Json());
  of_folder[0]["axis"] = "Y";
  CHECK(of_folder == of_list);

  // samples/controller/listen/rtconf.lis, line 5: the cycle of the thread that interpolates
  auto const controller = machines_of(opened, samples + "/controller").at(0);
  CHECK(controller.at("path") == samples + "/controller/listen/hochlauf.lis");
  CHECK(controller.at("cycle_time_us") == 2000);
  CHECK(controller.at("cycle_time_from") == samples + "/controller/listen/rtconf.lis:5");
  CHECK(machines_of(opened, samples + "/motion").size() > 1);

  TemporaryFolder const folder;
  auto const list = folder.write("x.lis", "kopf.achs_nr 1\nkopf.log_achs_name Q\n");
  auto const alone = machines_of(opened, list).at(0);
  CHECK(alone.at("path") == list);
  CHECK(alone.at("alone") == true);
  CHECK(alone.at("axis") == "Q");
  CHECK(alone.at("cycle_time_us") == 3000);
  CHECK(alone.at("cycle_time_from") == Json());
  folder.write("axisc.json", R"({"cycle_time_us": 500})");
  CHECK(machines_of(opened, list).at(0).at("cycle_time_us") == 500);
  CHECK(fs::equivalent(machines_of(opened, list).at(0).at("cycle_time_from").get<std::string>(),
                       folder / "axisc.json"));
  CHECK(machines_of(opened, folder / ".").empty());
  opened.call(axisc_answer, Json({{"question", "machines"}, {"input", folder / "none.lis"}}).dump());
  CHECK(opened.status == AXISC_NOT_FOUND);
}

TEST_CASE("axisc.h says filters in words, with the figures that inspect has") {
  TemporaryFolder const folder;
  auto const image = folder / "mill.axim";
  REQUIRE(run_axisc({"compile", "-o", image, samples + "/mill"}).status == 0);
  auto const inspected = Json::parse(run_axisc({"inspect", image, "--format", "json"}).out).at("axes");
  for (auto const* const language : {"en", "de"}) {
    Opened opened(Json({{"language", language}}).dump());
    for (auto const& input : {samples + "/mill", samples + "/mill/x.lis", image}) {
      INFO(language << " " << input);
      auto const text = opened.call(
          axisc_answer, Json({{"question", "filters"}, {"input", input}, {"format", "json"}}).dump());
      CHECK(complaints(text, "filters").empty());
      auto const axes = Json::parse(text).at("axes");
      REQUIRE(axes.size() == inspected.size());
      for (std::size_t i = 0; i < axes.size(); ++i) {
        CHECK(axes[i].at("axis") == inspected[i].at("name"));
        CHECK(axes[i].at("delay_ms") == inspected[i].at("delay_ms"));
        for (auto const* const key : {"corner_frequency_hz", "overshoot_percent", "settling_ms"}) {
          CHECK(axes[i].at(key) == inspected[i].at("chain").at(key));
        }
      }
      // samples/mill/x.lis: a band-stop filter at 42 Hz
      CHECK_THAT(
          axes[0].at("filters").get<std::string>(),
          Catch::Matchers::Contains(std::string(language) == "de" ? "Bandsperre 42 Hz" : "band-stop 42 Hz"));
    }
  }
  Opened opened;
  // The title is the machine's name, whichever of its files is asked about.
  CHECK_THAT(
      opened.call(axisc_answer, Json({{"question", "filters"}, {"input", samples + "/mill/x.lis"}}).dump()),
      Catch::Matchers::StartsWith("filters of mill-3ax"));
  opened.call(axisc_answer,
              Json({{"question", "filters"}, {"input", samples + "/tutorial/machine.json"}}).dump());
  CHECK(opened.status == AXISC_FINDINGS);
  CHECK_FALSE(opened.error().empty());
}

TEST_CASE("axisc.h says what is wrong with a question") {
  Opened opened;
  auto const wrong = [&](std::string const& question) {
    CHECK(opened.call(axisc_answer, question).empty());
    CHECK(opened.status == AXISC_BAD_ARGUMENT);
    return opened.error();
  };
  CHECK(wrong("soon").find("JSON object") != std::string::npos);
  CHECK(wrong(R"({"question": "weather"})").find("machine, machines, filters, get") != std::string::npos);
  CHECK(wrong(R"({"question": "machine", "file": "x"})").find("\"file\"") != std::string::npos);
  CHECK(wrong(R"({"question": "machine", "input": 1})").find("texts") != std::string::npos);
  CHECK(wrong(R"({"question": "picture", "input": ".", "kind": "cat"})").find("response, step") !=
        std::string::npos);
  opened.call(axisc_answer,
              Json({{"question", "contour"}, {"input", samples + "/mistakes/typing.lis"}}).dump());
  CHECK(opened.status != AXISC_OK);
  CHECK_FALSE(opened.error().empty());
  CHECK(Opened(R"({"cycle_time": "soon"})").status == AXISC_BAD_ARGUMENT);
  CHECK(Opened("{").status == AXISC_BAD_ARGUMENT);
  CHECK(Opened(R"({"language": "fr"})").error().find("en, de") != std::string::npos);
  CHECK(Opened(R"({"lang": "de"})").error().find("cycle_time") != std::string::npos);
  CHECK(opened.fix(samples + "/none.lis").empty());
  CHECK(opened.status == AXISC_NOT_FOUND);
  CHECK(opened.error().find("none.lis") != std::string::npos);
}

TEST_CASE("axisc.h speaks the protocol of language servers") {
  Opened opened(R"({"language": "de"})");
  auto const message = [](Json value) {
    value["jsonrpc"] = "2.0";
    return value.dump();
  };
  auto const send = [&](std::vector<std::string> const& messages) {
    auto const text = opened.call(axisc_message, Json(messages).dump());
    auto replies = Json::parse(text);
    CHECK(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) ==
          (replies.empty() ? 0 : replies.size() + 1));
    return replies;
  };
  auto const replies =
      send({message({{"id", 1}, {"method", "initialize"}, {"params", {{"capabilities", Json::object()}}}}),
            message({{"method", "initialized"}, {"params", Json::object()}})});
  CHECK(replies.at(0).at("result").contains("capabilities"));
  auto const document = Json{
      {"uri", "file:///x.lis"}, {"languageId", "axis-list"}, {"version", 1}, {"text", "kopf.achs_nr 01\n"}};
  auto const told =
      send({message({{"method", "textDocument/didOpen"}, {"params", {{"textDocument", document}}}})});
  CHECK(told.dump().find("AX1006") != std::string::npos);
  CHECK(opened.status == AXISC_OK);
  auto const shutdown = message({{"id", 2}, {"method", "shutdown"}});
  auto const exit = message({{"method", "exit"}});
  CHECK(send({shutdown, exit}).at(0).at("id") == 2);
  CHECK(opened.status == AXISC_ENDED);
  CHECK(send({shutdown}).empty());
  CHECK(opened.status == AXISC_ENDED);
  Opened left;
  left.call(axisc_message, Json({exit}).dump());
  CHECK(left.status == AXISC_BROKEN_OFF);
  CHECK(left.error().empty());
}

TEST_CASE("options of axisc_open override what files say, or fill in what they do not say") {
  auto const cycle_time_with = [](std::string const& options, std::string const& path) {
    Opened opened(options);
    REQUIRE(opened.status == AXISC_OK);
    return Json::parse(opened.call(axisc_answer,
                                   Json{{"question", "machine"}, {"input", path}, {"format", "json"}}.dump()))
        .at("cycle_time_us");
  };
  auto const machine = samples + "/mill/machine.json";
  CHECK(cycle_time_with("{}", machine) == 1000);
  CHECK(cycle_time_with(R"({"cycle_time": "2ms"})", machine) == 1000);
  CHECK(cycle_time_with(R"({"override_cycle_time": "2ms"})", machine) == 2000);
  for (auto const* const bad : {R"({"override_cycle_time": "soon"})", R"({"kind": "axes"})",
                                R"({"axis_type": "X"})", R"({"build": "3"})"}) {
    Opened const opened(bad);
    CHECK(opened.status == AXISC_BAD_ARGUMENT);
    CHECK(!opened.error().empty());
  }
}

TEST_CASE("axisc.h refuses null pointers, unknown numbers and workspaces that were not opened") {
  axisc_bytes bytes{};
  CHECK(axisc_abi_version() == AXISC_ABI_VERSION);
  CHECK(axisc_open("{}", nullptr, nullptr) == AXISC_BAD_ARGUMENT);
  CHECK(axisc_check(nullptr, "x.lis", &bytes) == AXISC_BAD_ARGUMENT);
  CHECK(std::string(axisc_error(nullptr)).empty());
  axisc_close(nullptr);
  axisc_cancel(nullptr);
  axisc_free(nullptr);
  Opened opened;
  CHECK(axisc_check(opened.get(), nullptr, &bytes) == AXISC_BAD_ARGUMENT);
  CHECK(axisc_check(opened.get(), "x.lis", nullptr) == AXISC_BAD_ARGUMENT);
  CHECK(opened.error().find("null") != std::string::npos);
  CHECK(axisc_fix(opened.get(), "x.lis", 2, &bytes) == AXISC_BAD_ARGUMENT);
  CHECK(axisc_put(opened.get(), "x.lis", nullptr, 1) == AXISC_BAD_ARGUMENT);
  CHECK(axisc_put(opened.get(), "x.lis", nullptr, 0) == AXISC_OK);
  CHECK(axisc_check(opened.get(), "\xff.lis", &bytes) == AXISC_BAD_ARGUMENT);
  CHECK(axisc_copy(&bytes, nullptr, 1) == AXISC_BAD_ARGUMENT);
  axisc_files files{};
  CHECK(Opened("{}", &files).status == AXISC_BAD_ARGUMENT);
  Opened refused(R"({"language": "fr"})");
  auto const why = refused.error();
  CHECK(refused.call(axisc_check, samples).empty());
  CHECK(refused.status == AXISC_BAD_ARGUMENT);
  CHECK(why != refused.error());
}

namespace {

/// Files of a caller: they count how often they are asked for, and what happens then.
struct Shelf {
  std::string text;
  int result = AXISC_OK;
  std::map<std::string, int> asked = {};
  axisc_workspace* cancelled = nullptr;
  axisc_workspace* called = nullptr;  ///< checks once more within the callback
  int called_result = 0;

  static int read(void* context, char const* path, axisc_bytes* file) {
    auto& shelf = *static_cast<Shelf*>(context);
    ++shelf.asked[path];
    axisc_bytes findings{};
    if (shelf.cancelled != nullptr) axisc_cancel(shelf.cancelled);
    if (shelf.called != nullptr) shelf.called_result = axisc_check(shelf.called, path, &findings);
    if (std::string(path) != "shelf/x.lis") return AXISC_NOT_FOUND;
    static_cast<void>(axisc_copy(file, shelf.text.data(), shelf.text.size()));
    return shelf.result;
  }
  static int list(void* /*context*/, char const* /*folder*/, axisc_bytes* names) {
    return axisc_copy(names, "x.lis", 5);  // without the NUL at its end
  }
  axisc_files files() {
    return {.size = sizeof(axisc_files), .reserved = 0, .context = this, .read = read, .list = list};
  }
};

}  // namespace

TEST_CASE("axisc.h reads files by the caller's functions, each once in a call") {
  Shelf shelf{.text = "kopf.achs_nr 01\n"};
  auto const files = shelf.files();
  Opened opened(R"({"cycle_time": "1ms"})", &files);
  CHECK(findings_in(opened.call(axisc_check, "shelf/x.lis")).at(0).at("code") == "AX1006");
  CHECK(opened.call(axisc_read, "shelf/x.lis") == shelf.text);
  opened.call(axisc_check, samples + "/mill/x.lis");
  CHECK(opened.status == AXISC_NOT_FOUND);  // it is on the disk alone
  for (std::string const path : {"shelf/x.lis", "shelf/missing.lis"}) {
    INFO(path);
    shelf.asked.clear();
    opened.call(axisc_check, path);
    CHECK(shelf.asked[path] == 1);
    shelf.asked.clear();
    opened.call(axisc_read, path);
    CHECK(shelf.asked[path] == 1);
  }
}

TEST_CASE("axisc.h: unsaved text counts however the path is spelt, and so do unsaved images") {
  TemporaryFolder const folder;
  auto const path = folder.write("x.lis", "kopf.achs_nr 1\n");
  Opened opened(R"({"cycle_time": "1ms"})");
  std::string const bad = "kopf.achs_nr 01\n";
  opened.put(folder / "./x.lis", bad);
  CHECK(findings_in(opened.call(axisc_check, path)).at(0).at("code") == "AX1006");
  REQUIRE(axisc_drop(opened.get(), path.c_str()) == AXISC_OK);
  CHECK(findings_in(opened.call(axisc_check, path)).empty());

  std::string const name = folder / "unsaved.axim";
  opened.put(name, opened.compile(samples + "/motion/rack/machine.json"));
  for (std::string const question : {"inspect", "response", "picture"}) {
    INFO(question);
    auto const asked = nlohmann::json{{"question", question}, {"input", name}};
    CHECK_THAT(opened.call(axisc_answer, asked.dump()), Catch::Matchers::Contains("X"));
    CHECK(opened.status == AXISC_OK);
  }
}

TEST_CASE("axisc.h outlives functions that fail, lie, cancel or call again") {
  Shelf shelf{.text = "kopf.achs_nr 1\n"};
  auto const files = shelf.files();
  Opened opened(R"({"cycle_time": "1ms"})", &files);
  for (int const result : {static_cast<int>(AXISC_UNUSABLE), 1, 77, -77}) {
    shelf.result = result;
    opened.call(axisc_check, "shelf/x.lis");
    CHECK(opened.status == AXISC_UNUSABLE);
    CHECK_FALSE(opened.error().empty());
  }
  shelf.result = AXISC_OK;
  shelf.called = opened.get();
  opened.call(axisc_check, "shelf/x.lis");
  CHECK(opened.status == AXISC_OK);
  CHECK(shelf.called_result == AXISC_BUSY);
  shelf.cancelled = opened.get();
  CHECK(opened.call(axisc_check, "shelf/x.lis").empty());
  CHECK(opened.status == AXISC_CANCELLED);
  shelf.cancelled = nullptr;
  opened.call(axisc_check, "shelf/x.lis");
  CHECK(opened.status == AXISC_OK);
}

}  // namespace interface_test
