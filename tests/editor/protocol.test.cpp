// What the language server does with messages of every sort.
#include "editor/session.hpp"
#include "support/catch.hpp"
#include "support/conversation.hpp"

#include <string>
#include <vector>

namespace protocol_test {

using namespace axisc::test;

namespace {

std::string const hello = R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":null})";

/// The answers to messages that arrive together, and how the conversation ends.
struct Answers {
  explicit Answers(std::vector<std::string> const& messages) {
    axisc::editor::Session session({}, axisc::Language::english);
    for (auto const& message : session.take(messages)) all.push_back(Json::parse(message));
    has_ended = session.has_ended();
    ended_properly = session.ended_properly();
  }

  std::vector<Json> all;
  bool has_ended = false;
  bool ended_properly = false;
};

Json only_answer(std::string const& message) {
  Answers const answers({hello, message, shutdown_request, exit_notification});
  CHECK(answers.ended_properly);
  REQUIRE(answers.all.size() == 3);
  return answers.all[1];
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
  for (std::size_t const levels : {65U, 100'000U}) {
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
  Answers const answers({R"({"jsonrpc":"2.0","id":5,"method":"textDocument/diagnostic"})", hello});
  REQUIRE(answers.all.size() == 2);
  CHECK(answers.all[0]["error"]["code"] == -32002);
}

TEST_CASE("notifications are never answered") {
  Answers const answers(
      {hello, R"({"jsonrpc":"2.0","method":"unknown"})",
       R"({"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":3}})",
       R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":null})",
       R"({"jsonrpc":"2.0","method":"textDocument/didChange","params":{"textDocument":{}}})",
       R"({"jsonrpc":"2.0","id":3,"result":null})", shutdown_request, exit_notification});
  CHECK(answers.ended_properly);
  CHECK(answers.all.size() == 2);
}

TEST_CASE("a conversation ends with exit, properly after shutdown alone") {
  Answers const proper({hello, shutdown_request, exit_notification, hello});
  CHECK(proper.has_ended);
  CHECK(proper.ended_properly);
  CHECK(proper.all.size() == 2);
  Answers const abrupt({hello, exit_notification});
  CHECK(abrupt.has_ended);
  CHECK_FALSE(abrupt.ended_properly);
  Answers const open({hello, shutdown_request, hello});
  CHECK_FALSE(open.has_ended);
  CHECK(open.all.back()["error"]["code"] == -32600);
}

TEST_CASE("a request that is cancelled while it waits is refused") {
  Conversation conversation;
  conversation.open("/x.lis", "kopf.achs_nr 1\n")
      .ask_at("textDocument/hover", "/x.lis", 0, 2)
      .ask_at("textDocument/hover", "/x.lis", 0, 2)
      .notify("$/cancelRequest", {{"id", 2}})
      .notify("$/cancelRequest", {{"id", 99}})
      .notify("$/cancelRequest", {{"id", "2"}})
      .notify("$/cancelRequest", nullptr)
      .ask_at("textDocument/hover", "/x.lis", 0, 2);
  auto const results = conversation.results();
  CHECK(results[0]["error"]["code"] == -32800);
  CHECK(results[1].contains("contents"));
  CHECK(results[2].contains("contents"));
}

}  // namespace protocol_test
