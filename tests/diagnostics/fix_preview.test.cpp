#include "diagnostics/writers/fix_preview.hpp"

#include "example_findings.hpp"
#include "support/catch.hpp"

#include <string>

using namespace axisc;
using namespace axisc::test;

namespace {

struct Change {
  std::string_view bytes;
  std::string text;
};

// "@line:column", then "-N text" and "+N text" for each block.
std::string preview_of(std::string bytes, std::vector<Change> const& changes) {
  SourceSet sources;
  SourceId const id = sources.add(SourceText("x.lis", std::move(bytes)));
  Fix fix;
  for (Change const& change : changes) {
    fix.edits.push_back({.place = place_of(sources, id, change.bytes), .text = change.text});
  }
  std::string shown;
  for (PreviewBlock const& block : preview(fix, sources)) {
    shown += "@" + std::to_string(block.begin.line) + ":" + std::to_string(block.begin.column) + "\n";
    for (PreviewLine const& line : block.lines) {
      shown += (line.added ? "+" : "-") + std::to_string(line.number) + " " + line.text + "\n";
    }
  }
  return shown;
}

}  // namespace

TEST_CASE("a replaced token shows the line before and after") {
  CHECK(preview_of("a 1\nb 2,5 (c)\nd 3\n", {{",", "."}}) == "@2:4\n-2 b 2,5 (c)\n+2 b 2.5 (c)\n");
}

TEST_CASE("edits of one line are shown together, in any order") {
  CHECK(preview_of("Name 2,5\n", {{",", "."}, {"N", "n"}}) == "@1:1\n-1 Name 2,5\n+1 name 2.5\n");
}

TEST_CASE("edits of several lines are shown one by one") {
  CHECK(preview_of("a 1,5\nb 1\nc 2;5\n", {{";", "."}, {",", "."}}) ==
        "@1:4\n-1 a 1,5\n+1 a 1.5\n@3:4\n-3 c 2;5\n+3 c 2.5\n");
}

TEST_CASE("a removed line has nothing in its place") {
  CHECK(preview_of("a 1\nb 2\nc 3\n", {{"b 2\n", ""}}) == "@2:1\n-2 b 2\n");
  CHECK(preview_of("a 1\r\nb 2\r\nc 3\r\n", {{"b 2\r\n", ""}}) == "@2:1\n-2 b 2\n");
}

TEST_CASE("inserted lines leave their neighbours out") {
  CHECK(preview_of("a 1\nb 2\n", {{"b", "x 1\nx 2\nb"}}) == "@2:1\n+2 x 1\n+3 x 2\n");
}

TEST_CASE("an edit across lines is shown whole") {
  CHECK(preview_of("a 1\nb 2\nc 3\n", {{"1\nb", "1 b"}}) == "@1:3\n-1 a 1\n-2 b 2\n+1 a 1 b 2\n");
}

TEST_CASE("text of a windows-1252 source is shown as UTF-8") {
  CHECK(preview_of("a 1,5 (G\xFCte)\n", {{",", "."}}) == "@1:4\n-1 a 1,5 (Güte)\n+1 a 1.5 (Güte)\n");
}

TEST_CASE("the place of the first change is known in characters") {
  SourceSet sources;
  SourceId const id = sources.add(SourceText("x.lis", "Güte 1,5\n"));
  Fix fix;
  fix.edits.push_back({.place = place_of(sources, id, ","), .text = "."});
  auto const blocks = preview(fix, sources);
  REQUIRE(blocks.size() == 1);
  REQUIRE(blocks[0].lines.size() == 2);
  CHECK(blocks[0].lines[0].first_change == 6);
  CHECK(blocks[0].lines[1].first_change == 6);
}

TEST_CASE("characters that begin alike differ as a whole, a line may begin like the other") {
  SourceSet sources;
  SourceId const id = sources.add(SourceText("x.lis", "Güte 1\n"));
  Fix fix;
  fix.edits.push_back({.place = place_of(sources, id, "ü"), .text = "ä"});
  CHECK(preview(fix, sources).front().lines.front().first_change == 1);
  fix.edits = {{.place = place_of(sources, id, " 1"), .text = ""}};
  CHECK(preview(fix, sources).front().lines.front().first_change == 4);
}

TEST_CASE("a fix without edits shows nothing") {
  CHECK(preview({}, SourceSet{}).empty());
}
