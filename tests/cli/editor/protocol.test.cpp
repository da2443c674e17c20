// What the language server does with messages of every sort.
#include "cli/editor/conversation.hpp"
#include "cli/program.hpp"
#include "support/catch.hpp"

using namespace axisc::test;

namespace {

std::string const hello = framed(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":null})");
std::string const farewell = framed(R"({"jsonrpc":"2.0","id":99,"method":"shutdown"})") +
                             framed(R"({"jsonrpc":"2.0","method":"exit"})");

Outcome answer(std::string input, std::vector<std::string> options = {}) {
  Surroundings surroundings;
  surroundings.input = std::move(input);
  options.insert(options.begin(), "lsp");
  return run_axisc(options, surroundings);
}

Json only_answer(std::string const& message) {
  auto const outcome = answer(hello + framed(message) + farewell);
  CHECK(outcome.status == 0);
  auto const all = unframed(outcome.out);
  REQUIRE(all.size() == 3);
  return all[1];
}

}  // namespace

TEST_CASE("the language server refuses what it does not know by the numbers of the protocol") {
  CHECK(only_answer("{no json")["error"]["code"] == -32700);
  CHECK(only_answer("[]")["error"]["code"] == -32600);
  CHECK(only_answer(R"({"jsonrpc":"2.0","id":[[1]],"method":"x"})")["error"]["code"] == -32600);
  CHECK(only_answer(R"({"jsonrpc":"2.0","id":2,"method":7})")["error"]["code"] == -32600);
  CHECK(only_answer(R"({"jsonrpc":"2.0","id":2,"method":"initialize"})")["error"]["code"] == -32600);
  CHECK(only_answer(R"({"jsonrpc":"2.0","id":2,"method":"textDocument/unknown"})")["error"]["code"] ==
        -32601);
  for (auto const* const params :
       {"null", "[]", "7", R"({"textDocument":null})", R"({"textDocument":{"uri":5}})",
        R"({"textDocument":{"uri":"file:///x"}})"}) {
    for (auto const* const method :
         {"textDocument/formatting", "textDocument/diagnostic", "textDocument/codeAction"}) {
      INFO(method << " " << params);
      auto const error = only_answer(std::string(R"({"jsonrpc":"2.0","id":2,"method":")") + method +
                                     R"(","params":)" + params + "}");
      CHECK(error["id"] == 2);
      CHECK(error["error"]["code"] == -32602);
    }
  }
}

TEST_CASE("a message that is nested too deep is refused, wherever it is deep") {
  for (std::size_t const levels : {65, 100'000}) {
    std::string const deep = std::string(levels, '[') + std::string(levels, ']');
    struct Case {
      std::string message;
      Json id;
    };
    std::vector<Case> const cases = {
        {R"({"jsonrpc":"2.0","id":5,"method":"textDocument/hover","params":)" + deep + "}", 5},
        {R"({"jsonrpc":"2.0","id":"a","method":"unknown","params":)" + deep + "}", "a"},
        {R"({"jsonrpc":"2.0","id":)" + deep + R"(,"method":"textDocument/hover"})", nullptr},
        {R"({"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":)" + deep + "}}", nullptr},
        {R"({"jsonrpc":"2.0","id":"axisc.settings","result":[)" + deep + "]}", nullptr},
        {R"({"jsonrpc":"2.0","method":"workspace/didChangeConfiguration","params":{"settings":{"axisc":)" +
             deep + "}}}",
         nullptr},
        {deep, nullptr}};
    for (auto const& each : cases) {
      INFO(each.message.substr(0, 80) << " " << levels);
      auto const refused = only_answer(each.message);
      CHECK(refused["id"] == each.id);
      CHECK(refused["error"]["code"] == -32600);
      CHECK(refused["error"]["message"] == "the message is nested deeper than 64 levels");
    }
  }
  // Brackets in texts nest nothing.
  std::string const brackets(1000, '[');
  CHECK(only_answer(R"({"jsonrpc":"2.0","id":5,"method":"unknown","params":["\"\\)" + brackets +
                    R"("]})")["error"]["code"] == -32601);
}

TEST_CASE("the language server asks for initialize first") {
  auto const outcome =
      answer(framed(R"({"jsonrpc":"2.0","id":5,"method":"textDocument/diagnostic"})") + hello + farewell);
  CHECK(outcome.status == 0);
  CHECK(unframed(outcome.out)[0]["error"]["code"] == -32002);
}

TEST_CASE("notifications are never answered") {
  auto const outcome =
      answer(hello + framed(R"({"jsonrpc":"2.0","method":"unknown"})") +
             framed(R"({"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":3}})") +
             framed(R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":null})") +
             framed(R"({"jsonrpc":"2.0","method":"textDocument/didChange","params":{"textDocument":{}}})") +
             framed(R"({"jsonrpc":"2.0","id":3,"result":null})") + farewell);
  CHECK(outcome.status == 0);
  CHECK(unframed(outcome.out).size() == 2);
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

TEST_CASE("edits reach the text at the positions of each encoding") {
  // ü: two bytes, one UTF-16 unit; 😀: four bytes, two units.
  std::string const text = "# \xC3\xBC\xF0\x9F\x98\x80 kopx.achs_nr 1\r\nkopx.achs_nr 1\n";
  auto const shown = [&](std::string const& encoding, int line, int character) {
    Json const at = {{"line", line}, {"character", character}};
    auto const before = Json{{"line", line}, {"character", character - 1}};
    auto const results =
        Conversation(encoding)
            .open("/x.lis", text)
            .notify("textDocument/didChange",
                    {{"textDocument", {{"uri", "file:///x.lis"}, {"version", 2}}},
                     {"contentChanges",
                      Json::array({{{"range", {{"start", before}, {"end", at}}}, {"text", "kopy\nkopz "}}})}})
            .ask("textDocument/diagnostic", "/x.lis")
            .results();
    return results[0]["items"].dump();
  };
  CHECK(shown("utf-32", 0, 5).find("kopz") != std::string::npos);
  CHECK(shown("utf-16", 0, 6).find("kopz") != std::string::npos);
  CHECK(shown("utf-8", 0, 9).find("kopz") != std::string::npos);
  CHECK(shown("", 1, 4).find("kopz") != std::string::npos);
  // After the end of a line, and after the last one.
  CHECK(shown("utf-16", 1, 4000).find("kopz") != std::string::npos);
  CHECK(shown("utf-16", 2000000000, 4000).find("kopz") != std::string::npos);
}

TEST_CASE("an edit at no position changes nothing") {
  for (auto const* const number : {"-1", "1.5", "1e300", "\"0\"", "null"}) {
    INFO(number);
    auto const at = Json::parse(std::string(R"({"line":0,"character":)") + number + "}");
    auto const results =
        Conversation()
            .open("/x.lis", "kopf.achs_nr 1\n")
            .notify(
                "textDocument/didChange",
                {{"textDocument", {{"uri", "file:///x.lis"}, {"version", 2}}},
                 {"contentChanges", Json::array({{{"range", {{"start", at}, {"end", at}}}, {"text", "x"}}})}})
            .ask("textDocument/diagnostic", "/x.lis")
            .results();
    CHECK(results[0]["items"].dump().find("AX2001") == std::string::npos);
  }
}

TEST_CASE("a document without text is not open") {
  auto const results =
      Conversation()
          .notify("textDocument/didOpen", {{"textDocument", {{"uri", "file:///x.lis"}, {"version", 1}}}})
          .change("/x.lis", "kopx.achs_nr 1\n")
          .ask("textDocument/diagnostic", "/x.lis")
          .results();
  CHECK(results[0]["error"]["code"] == -32602);
}

TEST_CASE("a carriage return alone ends a line of the protocol") {
  auto const results = Conversation("utf-16")
                           .open("/x.lis", "kopf.achs_nr 1\rkopf.achs_nr 2\nkopx.achs_nr 1\n")
                           .ask("textDocument/diagnostic", "/x.lis")
                           .results();
  int seen = 0;
  for (auto const& diagnostic : results[0]["items"]) {
    if (diagnostic["code"] == "AX1001") {
      ++seen;
      CHECK(diagnostic["range"]["start"] == Json({{"line", 0}, {"character", 14}}));
      CHECK(diagnostic["range"]["end"] == Json({{"line", 1}, {"character", 0}}));
    }
    if (diagnostic["code"] == "AX2001") {
      ++seen;
      CHECK(diagnostic["range"]["start"] == Json({{"line", 2}, {"character", 0}}));
    }
  }
  CHECK(seen == 2);
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
