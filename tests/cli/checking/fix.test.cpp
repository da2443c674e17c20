#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <cstdlib>
#include <sys/stat.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

namespace fix_test {

using namespace axisc::test;

namespace {

Outcome lint(TemporaryFolder const& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"lint", "--cycle-time", "1ms"});
  return run_axisc(arguments, in_folder(folder.path()));
}

/// windows-1252, CR LF, tabs.
std::string const mixed =
    "KOPF.achs_nr\t\t1\t( Gr\xF6\xDF"
    "e\r\nkenngr.achs_typ   1  ( T\r\nfilter[0].ordre  0\r\nende\r\n";

}  // namespace

TEST_CASE("safe fixes change the bytes that are wrong and no others") {
  TemporaryFolder const folder;
  folder.write("x.lis", mixed);
  auto const outcome = lint(folder, {"--fix", "x.lis"});
  CHECK(outcome.status == 1);
  CHECK(folder.read("x.lis") ==
        "kopf.achs_nr\t\t1\t( Gr\xF6\xDF"
        "e\r\nkenngr.achs_typ   1  ( T\r\nfilter[0].ordre  0\r\nEnde\r\n");
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("x.lis:3:1") &&
                              Catch::Matchers::EndsWith("note: 2 findings were fixed\n1 file: 1 error\n"));
  CHECK(folder.entries() == 1);
}

TEST_CASE("all fixes are applied only when asked for") {
  TemporaryFolder const folder;
  folder.write("x.lis", mixed);
  auto const all = lint(folder, {"--fix=all", "x.lis"});
  CHECK_THAT(all.out, Catch::Matchers::Contains("note: x.lis:3: write `filter[0].order`\n"));
  CHECK_THAT(folder.read("x.lis"), Catch::Matchers::Contains("\r\nfilter[0].order  0\r\n"));
  auto const again = lint(folder, {"--fix=all", "x.lis"});
  CHECK(again.out == "1 file: no findings\n");
  CHECK(lint(folder, {"--fix=some", "x.lis"}).status == 2);
}

TEST_CASE("--diff writes a patch and nothing else") {
  TemporaryFolder const folder;
  folder.write("x.lis", mixed);
  auto const outcome = lint(folder, {"--fix=all", "--diff", "x.lis"});
  CHECK(outcome.status == 1);
  CHECK(folder.read("x.lis") == mixed);
  CHECK(outcome.err == "1 file: no findings\n");
  folder.write("x.patch", outcome.out);
  std::string const command = "cd " + folder.path() + " && patch --binary -s x.lis x.patch 2>&1";
  if (std::system("patch --version > /dev/null 2>&1") == 0) {
    CHECK(std::system(command.c_str()) == 0);
    CHECK(lint(folder, {"--fix=all", "--diff", "x.lis"}).out.empty());
  }
  folder.write("y.lis", mixed);
  CHECK_THAT(lint(folder, {"--diff", "y.lis"}).out, !Catch::Matchers::Contains("+filter[0].order"));
}

TEST_CASE("a fix that would lead to another finding is left out") {
  TemporaryFolder const folder;
  std::string const list = "filter[0].ordre 9\nEnde\n";
  folder.write("x.lis", list);
  auto const outcome = lint(folder, {"--fix=all", "x.lis"});
  CHECK(outcome.status == 1);
  CHECK(folder.read("x.lis") == list);
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("1 fix was left out: it would lead to another finding"));
}

TEST_CASE("standard input is fixed onto standard output") {
  auto const outcome =
      run_axisc({"lint", "--fix", "-", "--cycle-time", "1ms"},
                {.folder = ".", .input = mixed, .out = {}, .variables = {}, .closed_pipe = false});
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.out,
             Catch::Matchers::StartsWith("kopf.achs_nr\t\t1") && Catch::Matchers::EndsWith("\r\nEnde\r\n"));
  CHECK_THAT(outcome.err, Catch::Matchers::Contains("-:3:1"));
}

TEST_CASE("a list that several inputs share is fixed once, its mode is kept", "[posix]") {
  TemporaryFolder const folder;
  std::string const machine =
      R"({"machine": "m", "cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}]})";
  folder.write("a.json", machine);
  folder.write("b.json", machine);
  auto const path = folder.write("x.lis", "kopf.achs_nr 1\nende\n");
  REQUIRE(::chmod(path.c_str(), 0640) == 0);
  auto const outcome = lint(folder, {"--fix", "a.json", "b.json"});
  CHECK(outcome.status == 0);
  CHECK(folder.read("x.lis") == "kopf.achs_nr 1\nEnde\n");
  struct stat facts {};
  REQUIRE(::stat(path.c_str(), &facts) == 0);
  CHECK((facts.st_mode & 0777U) == 0640U);
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("1 finding was fixed"));
}

TEST_CASE("what the baseline accepts is not fixed") {
  TemporaryFolder const folder;
  folder.write("x.lis", "kopf.achs_nr 1\nende\n");
  REQUIRE(lint(folder, {"--write-baseline", "known.json", "x.lis"}).status == 0);
  CHECK(lint(folder, {"--fix", "--baseline", "known.json", "x.lis"}).status == 0);
  CHECK(folder.read("x.lis") == "kopf.achs_nr 1\nende\n");
}

TEST_CASE("the JSON summary counts the fixes") {
  TemporaryFolder const folder;
  folder.write("x.lis", mixed);
  auto const json = nlohmann::json::parse(lint(folder, {"--fix", "x.lis", "--format", "json"}).out);
  CHECK(json["summary"]["fixed"] == 2);
  CHECK(json["diagnostics"].size() == 1);
}

TEST_CASE("a list that cannot be written is a failure and stays") {
  if (::geteuid() == 0) return;  // root may write everywhere
  TemporaryFolder const folder;
  auto const path = folder.write("x.lis", "kopf.achs_nr 1\nende\n");
  REQUIRE(::chmod(path.c_str(), 0400) == 0);
  CHECK(lint(folder, {"--fix", "x.lis"}).status == 2);
  CHECK(folder.read("x.lis") == "kopf.achs_nr 1\nende\n");
}

TEST_CASE("programs are repaired whole") {
  TemporaryFolder const folder;
  std::string const before = "%MAIN\r\nN1 G01 X1 (\xFC)\r\n#FILTER ON [order=20 ORDR=3]\r\nN3 G00 X0\r\nM30";
  folder.write("part.nc", before);
  auto const there = in_folder(folder.path());
  auto const patch = run_axisc({"lint", "part.nc", "--fix=all", "--diff", "--cycle-time", "1ms"}, there);
  CHECK_THAT(patch.out, Catch::Matchers::Contains("@@ -1,5 +1,5 @@"));
  CHECK(folder.read("part.nc") == before);
  static_cast<void>(run_axisc({"lint", "part.nc", "--fix=all", "--cycle-time", "1ms"}, there));
  CHECK(folder.read("part.nc") != before);
  CHECK(folder.read("part.nc").size() > before.size() - 8);
  CHECK_THAT(folder.read("part.nc"),
             Catch::Matchers::StartsWith("%MAIN\r\nN1 G01 X1 (\xFC)\r\n#FILTER ON [ORDER=20") &&
                 Catch::Matchers::EndsWith("]\r\nN3 G00 X0\r\nM30"));
}

TEST_CASE("no fix hides what a person has to decide") {
  TemporaryFolder const folder;
  std::string const list = "kopf.mds_ident 4 0\nkenngr.vb_messen 20 000\nEnde\nkopf.achs_nr 1\n";
  folder.write("x.lis", list);
  for (char const* const choice : {"--fix", "--fix=all"}) {
    CHECK_THAT(lint(folder, {choice, "x.lis"}).out, Catch::Matchers::EndsWith("1 file: 3 warnings\n"));
    CHECK(folder.read("x.lis") == list);
  }
}

TEST_CASE("what is not a misspelt name is never changed in lists of other kinds") {
  TemporaryFolder const folder;
  std::string const tools =
      "wz[1].laenge   0 ( P-TOOL-00003\nwz[1].radius  1 5\nFilter[0].order  1 5\nende\n";
  folder.write("lists/wz.lis", tools);
  folder.write("lists/sda.lis", "path[0].type     0x03\n# comment\n\tgrp_anzahl 1\n");
  std::string const channel = folder.read("lists/sda.lis");
  auto const outcome = lint(folder, {"--fix=all", "lists"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, !Catch::Matchers::Contains("fix"));
  CHECK(run_axisc({"fmt", "lists"}, in_folder(folder.path())).status == 0);
  CHECK(folder.read("lists/wz.lis") == tools);
  CHECK(folder.read("lists/sda.lis") == channel);
}

TEST_CASE("lines that a fix adds have the line ends of their list") {
  TemporaryFolder const folder;
  folder.write("x.lis", "kopf.achs_nr 1\nfilter_fir.type 1\nfilter_fir.order 20\nEnde\n");
  folder.write("y.lis", "kopf.achs_nr 2\r\nEnde\r\n");
  folder.write(
      "m.json",
      R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}, {"name": "Y", "list": "y.lis"}]})");
  static_cast<void>(
      run_axisc({"lint", "m.json", "--fix=all", "--disable", "AX2017"}, in_folder(folder.path())));
  CHECK(folder.read("y.lis") == "kopf.achs_nr 2\r\nfilter_fir.type 4\r\nfilter_fir.order 10\r\nEnde\r\n");
}

}  // namespace fix_test
