#include "diagnostics/fix_batch.hpp"

#include "example_findings.hpp"
#include "support/catch.hpp"

#include <string>
#include <vector>

using namespace axisc;
using namespace axisc::test;

namespace {

Fix fix_of(std::vector<Edit> edits) {
  return {.title = say("title"), .edits = std::move(edits), .safety = FixSafety::safe};
}

}  // namespace

TEST_CASE("edits replace their bytes and no others") {
  SourceSet sources;
  SourceId const first = sources.add(SourceText("a", "\xEF\xBB\xBFone two\r\nthree"));
  SourceId const second = sources.add(SourceText("b", "G\xFCte 1\n"));
  Fix const late = fix_of({{.place = place_of(sources, first, "three"), .text = "3\n4"},
                           {.place = place_of(sources, second, "1"), .text = "\xC3\xBC"}});
  Fix const early = fix_of({{.place = place_of(sources, first, "one"), .text = ""}});
  FixBatch batch(sources);
  CHECK(batch.add(late));
  CHECK(batch.add(early));
  auto const edited = batch.apply();
  REQUIRE(edited.size() == 2);
  CHECK(edited[0].bytes == "\xEF\xBB\xBF two\r\n3\r\n4");
  CHECK(edited[1].bytes == "G\xFCte \xFC\n");
}

TEST_CASE("of fixes that touch one another the first is taken, whole") {
  SourceSet sources;
  SourceId const list = sources.add(SourceText("a", "abcdef\n"));
  Fix const first = fix_of({{.place = place_of(sources, list, "cd"), .text = "X"}});
  Fix const beside = fix_of({{.place = place_of(sources, list, "a"), .text = "Y"},
                             {.place = place_of(sources, list, "e"), .text = "Y"}});
  Fix const before = fix_of({{.place = place_of(sources, list, "b"), .text = "Y"}});
  Fix const apart = fix_of({{.place = place_of(sources, list, "a"), .text = "Y"}});
  FixBatch batch(sources);
  CHECK(batch.add(first));
  CHECK(!batch.add(beside));
  CHECK(!batch.add(before));
  CHECK(batch.add(apart));
  CHECK(batch.apply().front().bytes == "YbXef\n");
}

TEST_CASE("a character that the encoding lacks is no fix") {
  SourceSet sources;
  SourceId const list = sources.add(SourceText("a", "\xFC x\n"));
  Fix const fix = fix_of({{.place = place_of(sources, list, "x"), .text = "\xE2\x89\xA4"}});
  FixBatch batch(sources);
  CHECK(!batch.add(fix));
  CHECK(batch.apply().empty());
}

TEST_CASE("what stands behind a gap keeps its column where the blanks allow it") {
  auto const replaced = [](std::string const& line, std::string const& by) {
    SourceSet sources;
    SourceId const list = sources.add(SourceText("a", line));
    Fix const fix = fix_of({{.place = place_of(sources, list, "old"), .text = by}});
    FixBatch batch(sources);
    REQUIRE(batch.add(fix));
    return batch.apply().front().bytes;
  };
  CHECK(replaced("old    1   # c\n", "o") == "o      1   # c\n");
  CHECK(replaced("old    1   # c\n", "older") == "older  1   # c\n");
  CHECK(replaced("old  1\n", "much longer") == "much longer 1\n");
  CHECK(replaced("old    # \xFC\n", "\xC3\xBC") == "\xFC      # \xFC\n");
  // One blank is no column, and a tab finds its own.
  CHECK(replaced("old 1\n", "o") == "o 1\n");
  CHECK(replaced("old\t1\n", "o") == "o\t1\n");
  CHECK(replaced("old  \t1\n", "o") == "o  \t1\n");
  CHECK(replaced("old   \r\n", "o") == "o   \r\n");
}
