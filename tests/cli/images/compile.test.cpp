#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/sarif_schema.hpp"
#include "support/temporary_folder.hpp"

#include <sys/stat.h>

namespace compile_test {

using namespace axisc::test;
namespace fs = std::filesystem;

namespace {

std::string const data = std::string(AXISC_SOURCE_DIR) + "/tests/cli/data/";
std::string const machine = data + "machine/machine.json";
std::string const list = data + "machine/x.lis";

}  // namespace

TEST_CASE("a machine and a single list compile") {
  TemporaryFolder const folder;
  auto const alone = folder.write("x.lis", read_source_file("tests/cli/data/machine/x.lis"));
  auto const outcome = run_axisc({"compile", machine, "-o", folder / "m.axim"});
  CHECK(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, Catch::Matchers::Contains("m.axim: written, axes: 2, filters: 3, "));
  CHECK(folder.read("m.axim").substr(0, 4) == "AXIM");
  auto const single =
      run_axisc({"compile", alone, "-o", folder / "x.axim", "--cycle-time", "1ms", "--quiet"});
  CHECK(single.status == 0);
  CHECK(single.err.empty());
}

TEST_CASE("a list that a machine names is not compiled without what the machine adds") {
  TemporaryFolder const folder;
  std::string const notch =
      "filter[0].enable 1\nfilter[0].type BANDSTOP\nfilter[0].prototype BUTTERWORTH\nfilter[0].order 1\n"
      "filter[0].fg_f0 40\nfilter[0].guete 2\n";
  folder.write("default.lis", notch);
  folder.write("x.lis", "kopf.achs_nr 1\nkopf.log_achs_name X\nkenngr.achs_typ 1\n");
  folder.write(
      "machine.json",
      R"({"cycle_time_us": 1000, "default_list": "default.lis", "axes": [{"name": "X", "list": "x.lis"}]})");
  auto const there = in_folder(folder / ".");
  auto const refused = run_axisc({"compile", "x.lis", "-o", "x.axim", "--cycle-time", "1ms"}, there);
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Catch::Matchers::Contains("x.lis is part of machine.json: compile that"));
  CHECK(folder.entries() == 3);
  auto const batch = run_axisc({"compile", "x.lis", "machine.json", "--output-folder", "images"}, there);
  CHECK(batch.status == 0);
  CHECK_THAT(batch.err, Catch::Matchers::Contains("images: 1 written, 0 unchanged, 0 not written"));
  CHECK(run_axisc({"compile", "x.lis", "--output-folder", "images"}, there).status == 2);
  CHECK(run_axisc({"compile", "x.lis", "-o", "x.axim", "--cycle-time", "1ms", "--alone"}, there).status == 0);
  // The notch takes 40 Hz away, and the list by itself knows nothing of it.
  auto const magnitude = [&](char const* input) {
    auto const rows = run_axisc({"response", input, "--frequencies", "40"}, there);
    return rows.status == 0 ? rows.out : rows.err;
  };
  CHECK(magnitude("x.lis") == magnitude("images/machine.axim"));
  CHECK_THAT(magnitude("x.lis"), !Catch::Matchers::Contains("X,40,1,"));
  CHECK_THAT(magnitude("x.axim"), Catch::Matchers::Contains("X,40,1,"));
}

TEST_CASE("equal inputs give equal bytes, wherever they lie") {
  TemporaryFolder const folder;
  fs::copy(data + "machine", folder / "elsewhere");
  REQUIRE(run_axisc({"compile", machine, "-o", folder / "a.axim"}).status == 0);
  REQUIRE(
      run_axisc({"compile", "machine.json", "-o", "../b.axim", "-j", "7"}, in_folder(folder / "elsewhere"))
          .status == 0);
  CHECK(folder.read("a.axim") == folder.read("b.axim"));
}

TEST_CASE("with errors nothing is written and an old image stays") {
  TemporaryFolder const folder;
  auto const old = folder.write("out.axim", "old");
  auto const outcome = run_axisc(
      {"compile", data + "mistakes.lis", "-o", old, "--cycle-time", "1ms", "--depfile", folder / "d"});
  CHECK(outcome.status == 1);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, Catch::Matchers::Contains("error[AX"));
  CHECK(run_axisc({"compile", data + "warning.lis", "-o", old, "--cycle-time", "1ms", "--werror"}).status ==
        1);
  CHECK(folder.read("out.axim") == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("an image that a controller would refuse is not written") {
  TemporaryFolder const folder;
  auto const old = folder.write("u.axim", "old");
  std::string const filter =
      "filter[0].order 3\nfilter[0].type BANDSTOP\nfilter[0].prototype BESSEL\nfilter[0].fg_f0 124.9\n"
      "filter[0].guete 1\n";
  std::vector<std::string> const compile{"compile", folder / "u.lis", "-o", old, "--cycle-time", "4ms"};
  folder.write("u.lis", "filter[0].enable 1\n" + filter);
  auto const found = run_axisc(compile);
  CHECK(found.status == 1);
  CHECK_THAT(found.err, Catch::Matchers::Contains("AX6001"));
  folder.write("u.lis", "filter[0].enable 1 ( axisc: allow AX6001\n" + filter);
  auto const silenced = run_axisc(compile);
  CHECK(silenced.status == 2);
  CHECK_THAT(silenced.err, Catch::Matchers::Contains("AXISRT_UNSTABLE"));
  CHECK(folder.read("u.axim") == "old");
}

TEST_CASE("a list without cycle time is refused") {
  TemporaryFolder const folder;
  auto const alone = folder.write("alone.lis", "kopf.achs_nr 1\nEnde\n");
  auto const outcome = run_axisc({"compile", alone, "-o", folder / "x.axim"});
  CHECK(outcome.status == 2);
  CHECK(lines_of(outcome.err) == 1);
  CHECK_THAT(outcome.err, Catch::Matchers::Contains("--cycle-time 1ms"));
  folder.write("x.lis", "kopf.achs_nr 1\nEnde\n");
  folder.write("m.json", R"({"machine": "m", "axes": [{"name": "X", "list": "x.lis"}]})");
  auto const without = run_axisc({"compile", folder / "m.json", "-o", folder / "x.axim"});
  CHECK(without.status == 2);
  CHECK_THAT(without.err, Catch::Matchers::Contains("\"cycle_time_us\""));
  CHECK(run_axisc({"compile", folder / "m.json", "-o", folder / "x.axim", "--cycle-time", "2ms"}).status ==
        0);
}

TEST_CASE("a configured filter that cannot be compiled is refused") {
  TemporaryFolder const folder;
  auto const path = folder.write("x.lis",
                                 "kopf.achs_nr 1\nfilter_fir.enable 1\nfilter_fir.type 1\n"
                                 "filter_fir.order 201 ( axisc: allow AX3001\nEnde\n");
  auto const outcome = run_axisc({"compile", path, "-o", folder / "x.axim", "--cycle-time", "1ms"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Catch::Matchers::Contains("x.lis:") && Catch::Matchers::Contains("filter_fir"));
  CHECK(folder.entries() == 1);
}

TEST_CASE("the target keeps what it is", "[posix]") {
  TemporaryFolder const folder;
  CHECK(run_axisc({"compile", machine, "-o", "/dev/null", "--quiet"}).status == 0);
  struct stat facts {};
  REQUIRE(::stat("/dev/null", &facts) == 0);
  CHECK(S_ISCHR(facts.st_mode));

  folder.write("real.axim", "old");
  fs::permissions(folder / "real.axim", static_cast<fs::perms>(0600));
  fs::create_symlink("real.axim", folder / "link.axim");
  CHECK(run_axisc({"compile", machine, "-o", folder / "link.axim"}).status == 0);
  CHECK(fs::is_symlink(folder / "link.axim"));
  CHECK(folder.read("real.axim").substr(0, 4) == "AXIM");
  CHECK(fs::status(folder / "real.axim").permissions() == static_cast<fs::perms>(0600));

  auto const to_stream = run_axisc({"compile", machine, "-o", "-"});
  CHECK(to_stream.out == folder.read("real.axim"));
}

TEST_CASE("what cannot be read or written is one line") {
  TemporaryFolder const folder;
  auto const check = [](std::vector<std::string> const& arguments, std::string const& expected) {
    auto const outcome = run_axisc(arguments);
    INFO(expected);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(lines_of(outcome.err) == 1);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains(expected));
  };
  auto const copy = folder.write("x.lis", "kopf.achs_nr 1\nEnde\n");
  check({"compile", machine, "-o", folder / "missing/x.axim"}, "AX9002]: cannot write");
  check({"compile", machine, "-o", folder.path()}, "it is a folder");
  check({"compile", machine, "-o", "/dev/full"}, "no space is left");
  check({"compile", machine}, "-o is missing");
  check({"compile", "-o", folder / "x.axim"}, "INPUT is missing");
  check({"compile", machine, list, "-o", folder / "x.axim"}, "need --output-folder");
  check({"compile", folder.path(), "-o", folder / "x.axim"}, "holds no machine");
  check({"compile", folder / "missing.lis", "-o", folder / "x.axim"}, "AX9001]");
  check({"compile", copy, "-o", copy, "--cycle-time", "1ms"}, "is one of the inputs");
  check({"compile", machine, "-o", folder / "x.axim", "--image-version", "4294967296"},
        "--image-version needs");
  CHECK(folder.entries() == 1);
}

TEST_CASE("the dependency file names every file that was read") {
  TemporaryFolder const folder;
  fs::copy(data + "machine", folder / "m");
  Surroundings const there = in_folder(folder.path());
  REQUIRE(run_axisc({"compile", "m/machine.json", "-o", "m.axim", "--depfile", "m.d"}, there).status == 0);
  CHECK(folder.read("m.d") == "m.axim: \\\n  m/machine.json \\\n  m/x.lis \\\n  m/y.lis\n");
}

TEST_CASE("findings of compile as JSON go to standard error") {
  TemporaryFolder const folder;
  auto const outcome = run_axisc({"compile", machine, "-o", folder / "m.axim", "--format", "json"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err, Catch::Matchers::StartsWith("{") && Catch::Matchers::Contains("\"summary\""));
}

TEST_CASE("compile reports to code hosts on standard error") {
  TemporaryFolder const folder;
  folder.write("x.lis", "filter[0].order 7\nEnde\n");
  for (std::string const format : {"sarif", "gitlab", "github"}) {
    auto const outcome =
        run_axisc({"compile", "x.lis", "-o", "x.axim", "--cycle-time", "1ms", "--format", format},
                  in_folder(folder.path()));
    CHECK(outcome.status == 1);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.err, Catch::Matchers::Contains("AX3001"));
    if (format == "sarif") CHECK(sarif_complaints(outcome.err) == std::vector<std::string>{});
  }
}

}  // namespace compile_test
