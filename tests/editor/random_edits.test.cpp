// Random edits: the server's text stays the client's, and what it shows is what a new check of that text
// shows.
#include "support/catch.hpp"
#include "support/editor_client.hpp"
#include "support/sanitized.hpp"

#include <random>

namespace random_edits_test {

namespace {

using namespace axisc::test;

void edit_at_random(int edits, int between_checks) {
  std::mt19937 random(20240229);
  auto const below = [&random](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  EditorClient client("kopf.achs_nr 1\r\nfilter[0].order 2\n");
  constexpr std::size_t longest = 1500;
  for (int i = 0; i < edits; ++i) {
    auto const& text = client.text();
    auto const begin = boundary(text, below(text.size() + 1));
    std::size_t const most = text.size() > longest ? text.size() : 12;
    auto const end = boundary(text, std::min(text.size(), begin + below(most + 1)));
    // A carriage return and a line feed that come together are one line end from then on.
    client.edit(begin, end, pieces[below(pieces.size())]);
    if (i % between_checks != 0) continue;
    INFO("edit " << i << ": " << client.text());
    EditorClient fresh(client.text());
    REQUIRE(client.shown() == fresh.shown());
    Json const at = {{"position", {{"line", below(20)}, {"character", below(30)}}}};
    for (auto const* const method :
         {"textDocument/hover", "textDocument/completion", "textDocument/references",
          "textDocument/semanticTokens/full", "textDocument/foldingRange"}) {
      REQUIRE(client.ask(method, at) == fresh.ask(method, at));
    }
    Json const everything = {
        {"range", {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 9999}, {"character", 0}}}}}};
    REQUIRE(client.ask("textDocument/inlayHint", everything) ==
            fresh.ask("textDocument/inlayHint", everything));
  }
}

}  // namespace

TEST_CASE("after random edits the server shows what it shows of the same text opened anew") {
  edit_at_random(sanitized ? 300 : 3000, 3);
}

TEST_CASE("after a hundred thousand random edits, too", "[.long]") {
  edit_at_random(100'000, 10);
}

}  // namespace random_edits_test
