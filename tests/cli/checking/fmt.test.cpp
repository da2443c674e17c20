#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

namespace fmt_test {

using namespace axisc::test;

namespace {

std::string const crooked = "kopf.achs_nr 1 ( Nummer\r\nkenngr.achs_typ\t\t1\t# G\xFCte\r\nEnde\r\n";
std::string const aligned = "kopf.achs_nr     1  ( Nummer\r\nkenngr.achs_typ  1  # G\xFCte\r\nEnde\r\n";

Outcome fmt(TemporaryFolder const& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "fmt");
  return run_axisc(arguments, in_folder(folder.path()));
}

}  // namespace

TEST_CASE("fmt aligns in place, once") {
  TemporaryFolder const folder;
  folder.write("x.lis", crooked);
  auto const outcome = fmt(folder, {"x.lis"});
  CHECK(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.empty());
  CHECK(folder.read("x.lis") == aligned);
  CHECK(fmt(folder, {"--check", "x.lis"}).status == 0);
}

TEST_CASE("fmt --check and --diff write nothing") {
  TemporaryFolder const folder;
  folder.write("x.lis", crooked);
  auto const check = fmt(folder, {"--check", "x.lis"});
  CHECK(check.status == 1);
  CHECK(check.out == "x.lis would be formatted\n");
  auto const diff = fmt(folder, {"--diff", "x.lis"});
  CHECK(diff.status == 0);
  CHECK_THAT(diff.out, Catch::Matchers::StartsWith("--- x.lis\n+++ x.lis\n@@ -1,3 +1,3 @@\n-kopf.achs_nr 1"));
  CHECK(fmt(folder, {"--diff", "--check", "x.lis"}).status == 1);
  CHECK(folder.read("x.lis") == crooked);
}

TEST_CASE("fmt reads standard input and folders and machine files") {
  TemporaryFolder const folder;
  CHECK(run_axisc({"fmt", "-"},
                  {.folder = ".", .input = crooked, .out = {}, .variables = {}, .closed_pipe = false})
            .out == aligned);
  folder.write("m.json", R"({"machine": "m", "axes": [{"name": "X", "list": "lists/x.lis"}]})");
  folder.write("lists/x.lis", crooked);
  folder.write("lists/y.lis", crooked);
  CHECK(fmt(folder, {"m.json"}).status == 0);
  CHECK(folder.read("lists/x.lis") == aligned);
  CHECK(folder.read("lists/y.lis") == crooked);
  CHECK(fmt(folder, {"lists"}).status == 0);
  CHECK(folder.read("lists/y.lis") == aligned);
}

TEST_CASE("fmt names what it cannot read and goes on") {
  TemporaryFolder const folder;
  folder.write("x.lis", crooked);
  auto const outcome = fmt(folder, {"missing.lis", "x.lis"});
  CHECK(outcome.status == 2);
  CHECK(lines_of(outcome.err) == 1);
  CHECK(folder.read("x.lis") == aligned);
  CHECK(fmt(folder, {}).status == 2);
}

TEST_CASE("fmt reads the text of a file with a name from standard input") {
  TemporaryFolder const folder;
  auto there = in_folder(folder.path());
  there.input = "kopf.achs_nr 1\nkopf.log_achs_name X\n";
  auto const patch = run_axisc({"fmt", "-", "--stdin-filename", "axes/x.lis", "--diff"}, there);
  CHECK_THAT(patch.out, Catch::Matchers::StartsWith("--- axes/x.lis"));
  CHECK(run_axisc({"fmt", "-", "--stdin-filename", "axes/x.nc"}, there).out == there.input);
}

}  // namespace fmt_test
