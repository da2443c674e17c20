// Semantic tokens.
#include "support/catch.hpp"
#include "support/conversation.hpp"

namespace tokens_test {

using namespace axisc::test;

namespace {

Json asked(std::string const& method, std::string const& path, std::string const& text,
           Json const& params = Json::object()) {
  return Conversation().open(path, text).ask(method, path, params).results()[0];
}

}  // namespace

TEST_CASE("tokens tell names, indices, values, comments and what the control ignores") {
  auto const data = asked("textDocument/semanticTokens/full", "/x.lis",
                          "# a\nfilter[0].type LOWPASS ( b\nunknown.x 5 junk\n")["data"];
  // line, character, length, type, modifiers; types: 0 property, 1 number, 2 enumMember, 5 comment
  CHECK(data == Json({0, 0, 3, 5, 0,                                                              //
                      1, 0, 6, 0, 0, 0, 7, 1, 1, 0, 0, 3, 4, 0, 0, 0, 5, 7, 2, 0, 0, 8, 3, 5, 0,  //
                      1, 0, 7, 0, 1, 0, 8, 1, 0, 1, 0, 2, 1, 1, 0, 0, 2, 4, 5, 1}));
}

TEST_CASE("tokens of text in several encodings count their units") {
  auto const text = "kopf.log_achs_name \xC3\x84\xF0\x9F\x98\x80 ( x\n";
  auto const data = [&](std::string const& encoding) {
    return Conversation(encoding)
        .open("/x.lis", text)
        .ask("textDocument/semanticTokens/full", "/x.lis")
        .results()[0]["data"];
  };
  CHECK(data("utf-8")[12] == 6);
  CHECK(data("utf-16")[12] == 3);
  CHECK(data("utf-32")[12] == 2);
}

}  // namespace tokens_test
