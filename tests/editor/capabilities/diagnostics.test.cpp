// Findings as the client shows them.
#include "support/catch.hpp"
#include "support/conversation.hpp"

namespace diagnostics_test {

using namespace axisc::test;

TEST_CASE("ignored text is marked as unnecessary") {
  auto const results = Conversation()
                           .open("/x.lis", "kopf.achs_nr 1\nEnde\nkopf.achs_nr 2\n")
                           .ask("textDocument/diagnostic", "/x.lis")
                           .results();
  bool found = false;
  for (auto const& diagnostic : results[0]["items"]) {
    if (diagnostic["code"] != "AX1008") continue;
    found = true;
    CHECK(diagnostic["tags"] == Json::array({1}));
  }
  CHECK(found);
}

}  // namespace diagnostics_test
