// axisc.h gives what the program gives: the page and other languages see one verdict.
#include "cli/program.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "web/interface/axisc.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

using namespace axisc::test;

namespace {

namespace fs = std::filesystem;

std::string const samples = std::string(AXISC_SOURCE_DIR) + "/samples";

using Json = nlohmann::json;

class Opened {
 public:
  explicit Opened(std::string const& options = "{}") : status(axisc_open(options.c_str(), &workspace_)) {}
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

std::string bytes_of(fs::path const& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Without what the program alone says: its version, and fingerprints that count from a repository.
Json findings_in(std::string const& json) {
  return json.empty() ? Json() : Json::parse(json).at("diagnostics");
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
    CHECK(opened.status == lint.status);
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
  CHECK(opened.status == AXISC_FAILED);
  CHECK(opened.error().find("nicht lesbar") != std::string::npos);
}

TEST_CASE("axisc.h compiles the image that compile writes") {
  TemporaryFolder const folder;
  auto const image = folder / "x.axim";
  for (auto const* const input : {"controller", "mill", "motion/rack"}) {
    INFO(input);
    auto const path = samples + "/" + input;
    Opened opened;
    auto const bytes = opened.call(axisc_compile, path);
    CHECK(opened.status == AXISC_OK);
    REQUIRE(run_axisc({"compile", "-o", image, path}).status == 0);
    CHECK(bytes == bytes_of(image));
  }
}

TEST_CASE("axisc.h repairs as lint --fix does, and writes nothing") {
  TemporaryFolder const folder;
  auto const list = folder / "typing.lis";
  fs::copy_file(samples + "/mistakes/typing.lis", list);
  auto const before = bytes_of(list);
  Opened opened;
  CHECK(Json::parse(opened.call(axisc_fix, list)) == Json::array({list}));
  auto const repaired = opened.call(axisc_read, list);
  CHECK(bytes_of(list) == before);
  static_cast<void>(run_axisc({"lint", "--fix", list}));
  CHECK(repaired == bytes_of(list));
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
  CHECK(opened.status == AXISC_FAILED);
}

TEST_CASE("axisc.h answers in the formats of the commands") {
  Opened opened;
  auto const mill = samples + "/mill";
  auto const ask = [&](Json const& question) { return opened.call(axisc_answer, question.dump()); };
  CHECK(ask({{"question", "machine"}, {"input", mill}, {"format", "json"}}) ==
        run_axisc({"machine", "--format", "json", mill}).out);
  CHECK(ask({{"question", "contour"}, {"input", mill}, {"format", "csv"}}) ==
        run_axisc({"contour", "--format", "csv", mill}).out);
  CHECK(ask({{"question", "explain"}, {"word", "AX3005"}, {"format", "markdown"}}) ==
        run_axisc({"explain", "AX3005"}).out);
  CHECK(ask({{"question", "report"}, {"input", mill}}) == run_axisc({"report", mill, "-o", "-"}).out);
  CHECK(ask({{"question", "machine_of"}, {"input", mill + "/x.lis"}}) == mill + "/machine.json");
  for (auto const* const kind : {"response", "step", "delay", "corner", "circle"}) {
    INFO(kind);
    CHECK(ask({{"question", "picture"}, {"input", mill}, {"kind", kind}}) ==
          run_axisc({"plot", mill, "--kind", kind, "-o", "-"}).out);
  }
}

TEST_CASE("axisc.h says what is wrong with a question") {
  Opened opened;
  auto const wrong = [&](std::string const& question) {
    CHECK(opened.call(axisc_answer, question).empty());
    CHECK(opened.status == AXISC_FAILED);
    return opened.error();
  };
  CHECK(wrong("soon").find("JSON object") != std::string::npos);
  CHECK(wrong(R"({"question": "weather"})").find("machine, machine_of, contour") != std::string::npos);
  CHECK(wrong(R"({"question": "machine", "file": "x"})").find("\"file\"") != std::string::npos);
  CHECK(wrong(R"({"question": "machine", "input": 1})").find("texts") != std::string::npos);
  CHECK(wrong(R"({"question": "picture", "input": ".", "kind": "cat"})").find("response, step") !=
        std::string::npos);
  opened.call(axisc_answer,
              Json({{"question", "contour"}, {"input", samples + "/mistakes/range.lis"}}).dump());
  CHECK(opened.status != AXISC_OK);
  CHECK_FALSE(opened.error().empty());
  CHECK(Opened(R"({"cycle_time": "soon"})").status == AXISC_FAILED);
  CHECK(Opened("{").status == AXISC_FAILED);
  CHECK(Opened(R"({"language": "fr"})").error().find("en, de") != std::string::npos);
  CHECK(Opened(R"({"lang": "de"})").error().find("cycle_time") != std::string::npos);
  CHECK(opened.call(axisc_fix, samples + "/none.lis").empty());
  CHECK(opened.status == AXISC_FAILED);
  CHECK(opened.error().find("none.lis") != std::string::npos);
}

TEST_CASE("axisc.h speaks the protocol of language servers") {
  Opened opened(R"({"language": "de"})");
  auto const message = [](Json value) {
    value["jsonrpc"] = "2.0";
    return value.dump();
  };
  auto const send = [&](std::vector<std::string> const& messages) {
    return Json::parse(opened.call(axisc_message, Json(messages).dump()));
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
}
