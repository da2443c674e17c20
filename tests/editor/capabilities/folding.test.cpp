// Folding ranges.
#include "support/catch.hpp"
#include "support/conversation.hpp"

#include <algorithm>

namespace folding_test {

using namespace axisc::test;

namespace {

Json asked(std::string const& method, std::string const& path, std::string const& text,
           Json const& params = Json::object()) {
  return Conversation().open(path, text).ask(method, path, params).results()[0];
}

}  // namespace

TEST_CASE("comments fold, and so does what they head") {
  auto const ranges =
      asked("textDocument/foldingRange", "/x.lis",
            "# head\n# more\n\n# one\nfilter[0].order 1\nfilter[0].type PT2\n\n# two\nfilter[1].order 1\n");
  CHECK(std::count(ranges.begin(), ranges.end(),
                   Json({{"startLine", 0}, {"endLine", 1}, {"kind", "comment"}})) == 1);
  CHECK(std::count(ranges.begin(), ranges.end(),
                   Json({{"startLine", 3}, {"endLine", 5}, {"kind", "region"}})) == 1);
  CHECK(std::count(ranges.begin(), ranges.end(),
                   Json({{"startLine", 7}, {"endLine", 8}, {"kind", "region"}})) == 1);
  CHECK(ranges.size() == 3);
}

}  // namespace folding_test
