// The program `axisc lsp`: frames on its standard input and output, options, exit status.
#include "cli/program.hpp"
#include "editor/framing.hpp"
#include "support/catch.hpp"
#include "support/conversation.hpp"

#include <string>
#include <utility>
#include <vector>

using namespace axisc::test;
using axisc::editor::framed;

namespace {

std::string const hello = framed(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":null})");
std::string const farewell = framed(shutdown_request) + framed(exit_notification);

Outcome answer(std::string input, std::vector<std::string> options = {}) {
  Surroundings surroundings;
  surroundings.input = std::move(input);
  options.insert(options.begin(), "lsp");
  return run_axisc(options, surroundings);
}

std::vector<Json> unframed(std::string_view out) {
  std::vector<Json> found;
  while (!out.empty()) {
    auto const end = out.find("\r\n\r\n");
    REQUIRE(end != std::string_view::npos);
    auto const size = std::stoul(std::string(out.substr(16, end - 16)));
    found.push_back(Json::parse(out.substr(end + 4, size)));
    out.remove_prefix(end + 4 + size);
  }
  return found;
}

}  // namespace

TEST_CASE("the program answers on standard output as a session does") {
  auto const list = source_path("samples/mill/x.lis");
  Conversation conversation;
  conversation.open(list).change(list, "filter[0].order \xC3\xBC\n").ask("textDocument/diagnostic", list);
  conversation.ask_at("textDocument/hover", list, 0, 3);
  auto const expected = conversation.all(axisc::Language::german);
  std::string input;
  for (auto const& message : conversation.messages()) input += framed(message);
  auto const outcome = answer(input, {"--lang", "de"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(unframed(outcome.out) == expected);
}

TEST_CASE("a message that is not UTF-8 is refused, and the next one answered") {
  auto const outcome =
      answer(hello + framed("{\"jsonrpc\":\"2.0\",\"id\":2,\"method\":\"\xFC\"}") + farewell);
  CHECK(outcome.status == 0);
  auto const answers = unframed(outcome.out);
  REQUIRE(answers.size() == 3);
  CHECK(answers[1]["error"]["code"] == -32700);
}

TEST_CASE("the exit status tells how a conversation ended") {
  CHECK(answer(hello + farewell).status == 0);
  CHECK(answer(hello + framed(R"({"jsonrpc":"2.0","method":"exit"})")).status == 1);
  CHECK(answer(framed(R"({"jsonrpc":"2.0","method":"exit"})")).status == 1);
  CHECK(answer(hello).status == 1);
  CHECK(answer("").status == 1);
  CHECK(answer(hello + "Content-Length: 100\r\n\r\n{\"jsonrpc\":").status == 1);
  CHECK(answer(hello + "Content-Len").status == 1);
  auto const broken = answer("Content-Length: many\r\n\r\n{}");
  CHECK(broken.status == 2);
  CHECK(broken.err.find("begins with Content-Length: BYTES (at most 1073741824)") != std::string::npos);
  CHECK(answer("Content-Length: -5\r\n\r\n{}").status == 2);
  CHECK(answer("Content-Length: 99999999999999999999\r\n\r\n{}").status == 2);
  CHECK(answer("Content-Type: x\r\n\r\n{}").status == 2);
  CHECK(answer(std::string(100000, 'x')).status == 2);
  // Too short by one byte: no message, and no header after it.
  CHECK(answer("Content-Length: 1\r\n\r\n{}" + farewell).status == 2);
}

TEST_CASE("the language server knows the control that its options describe") {
  auto const path = source_path("samples/manual/axis-pt1.lis");
  auto const opened = framed(Json{
      {"jsonrpc", "2.0"},
      {"method", "textDocument/didOpen"},
      {"params",
       {{"textDocument",
         {{"uri", "file://" + path}, {"languageId", "axis-list"}, {"version", 1}, {"text", text_of(path)}}}}}}
                                 .dump());
  auto const codes = [&](std::vector<std::string> const& options) {
    auto const outcome = answer(hello + opened + farewell, options);
    CHECK(outcome.status == 0);
    std::vector<std::string> found;
    for (auto const& message : unframed(outcome.out)) {
      if (message.value("method", "") != "textDocument/publishDiagnostics") continue;
      for (auto const& finding : message["params"]["diagnostics"]) found.push_back(finding["code"]);
    }
    return found;
  };
  using Codes = std::vector<std::string>;
  // A time constant below the cycle time.
  CHECK(codes({}) == Codes{"AX9006"});
  CHECK(codes({"--cycle-time", "1ms"}).empty());
  CHECK(codes({"--cycle-time", "100ms"}) == Codes{"AX3004"});
  auto const outcome = answer(hello + farewell, {"--cycle-time", "soon"});
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
}
