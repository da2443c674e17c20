#include "diagnostics/writers/unified_diff.hpp"

#include "support/catch.hpp"

#include <string>

using axisc::unified_diff;

TEST_CASE("equal texts have no difference") {
  CHECK(unified_diff("x", "a\n", "a\n").empty());
}

TEST_CASE("a hunk has three lines of context") {
  CHECK(unified_diff("x.lis", "1\n2\n3\n4\n5\n6\n7\n8\n9\n", "1\n2\n3\n4\nfive\n6\n7\n8\n9\n") ==
        "--- x.lis\n+++ x.lis\n@@ -2,7 +2,7 @@\n 2\n 3\n 4\n-5\n+five\n 6\n 7\n 8\n");
}

TEST_CASE("lines that only one side has") {
  CHECK(unified_diff("x", "a\nb\nc\n", "a\nnew\nb\nc\n") ==
        "--- x\n+++ x\n@@ -1,3 +1,4 @@\n a\n+new\n b\n c\n");
  CHECK(unified_diff("x", "a\nb\nc\n", "a\nc\n") == "--- x\n+++ x\n@@ -1,3 +1,2 @@\n a\n-b\n c\n");
  CHECK(unified_diff("x", "", "a\n") == "--- x\n+++ x\n@@ -0,0 +1 @@\n+a\n");
  CHECK(unified_diff("x", "a\n", "") == "--- x\n+++ x\n@@ -1 +0,0 @@\n-a\n");
}

TEST_CASE("changes that are far apart have hunks of their own, in order") {
  std::string before;
  std::string after;
  for (int i = 0; i < 30; ++i) {
    before += std::to_string(i) + "\n";
    after += (i == 2 || i == 25 ? "x" : std::to_string(i)) + "\n";
  }
  std::string const diff = unified_diff("x", before, after);
  CHECK_THAT(diff, Catch::Matchers::Contains("@@ -1,6 +1,6 @@\n") &&
                       Catch::Matchers::Contains("@@ -23,7 +23,7 @@\n"));
}

TEST_CASE("a missing line end at the end is said, carriage returns stay") {
  CHECK(unified_diff("x", "a\r\nb", "a\nb") ==
        "--- x\n+++ x\n@@ -1,2 +1,2 @@\n-a\r\n+a\n b\n\\ No newline at end of file\n");
}
