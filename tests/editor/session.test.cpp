// The settings of a folder, in a session of the editor.
#include "support/catch.hpp"
#include "support/conversation.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>

namespace session_test {

using namespace axisc::test;

TEST_CASE("team settings apply") {
  TemporaryFolder const folder;
  folder.write("axisc.json", R"({"disable": ["AX2001"]})");
  auto const list = folder.path() + "/x.lis";
  auto const results =
      Conversation().open(list, "kopx.achs_nr 1\n").ask("textDocument/diagnostic", list).results();
  CHECK(results[0]["items"].dump().find("AX2001") == std::string::npos);
}

TEST_CASE("a mistake in the team settings is told once") {
  TemporaryFolder const folder;
  folder.write("axisc.json", R"({"disable": 5})");
  auto const list = folder.path() + "/x.lis";
  Conversation conversation;
  (void)conversation.open(list, "kopx.achs_nr 1\n")
      .ask("textDocument/diagnostic", list)
      .ask("textDocument/hover", list, {{"position", {{"line", 0}, {"character", 1}}}})
      .results();
  auto const& sent = conversation.notifications();
  CHECK(std::count_if(sent.begin(), sent.end(), [](Json const& message) {
          return message["method"] == "window/showMessage" && message["params"]["type"] == 1 &&
                 message["params"]["message"].get<std::string>().find("axisc.json") != std::string::npos;
        }) == 1);
}

}  // namespace session_test
