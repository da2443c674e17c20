#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/sarif_schema.hpp"
#include "support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

namespace lint_test {

using namespace axisc::test;

namespace {

std::string const data = std::string(AXISC_SOURCE_DIR) + "/tests/cli/data";
Surroundings const in_data = in_folder(data);

std::string const clean = "kopf.achs_nr 1\nkenngr.achs_typ 1\nEnde\n";
std::string const wrong = "kopf.achs_nr 1,5\nEnde\n";

}  // namespace

TEST_CASE("findings in every format and both languages") {
  // A repository of its own: reports name paths from its root.
  TemporaryFolder const repository;
  repository.write(".git/HEAD", "");
  repository.write("axes/mistakes.lis", read_source_file("tests/cli/data/mistakes.lis"));
  for (std::string const language : {"en", "de"}) {
    for (std::string const format : {"text", "json", "sarif", "github", "gitlab", "junit"}) {
      auto const outcome =
          run_axisc({"lint", "mistakes.lis", "--cycle-time", "1ms", "--lang", language, "--format", format},
                    in_folder(repository / "axes"));
      if (format == "sarif") CHECK(sarif_complaints(outcome.out) == std::vector<std::string>{});
      CHECK(outcome.status == 1);
      CHECK(outcome.err.empty());
      check_golden("tests/cli/data/golden/lint/" + language + "." + format, outcome.out);
    }
  }
}

TEST_CASE("exit status of lint") {
  CHECK(run_axisc({"lint", "machine"}, in_data).status == 0);
  CHECK(run_axisc({"lint", "warning.lis", "--cycle-time", "1ms"}, in_data).status == 0);
  CHECK(run_axisc({"lint", "warning.lis", "--cycle-time", "1ms", "--werror"}, in_data).status == 1);
  CHECK(run_axisc({"lint", "warning.lis", "--cycle-time", "1ms", "--werror", "--disable", "AX3015"}, in_data)
            .status == 0);
  CHECK(run_axisc({"lint", "mistakes.lis", "--cycle-time", "1ms"}, in_data).status == 1);
  CHECK(run_axisc({"lint"}, in_data).status == 2);
  CHECK(run_axisc({"lint", "missing.lis"}, in_data).status == 2);
}

TEST_CASE("a missing file is one line, the other inputs are still checked") {
  auto const outcome = run_axisc({"lint", "missing.lis", "mistakes.lis", "--cycle-time", "1ms"}, in_data);
  CHECK(outcome.status == 2);
  CHECK(outcome.err ==
        "axisc: error[AX9001]: cannot read missing.lis: there is no such file; check the name and the "
        "folder\n");
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("mistakes.lis:4:"));
  auto const alone = run_axisc({"lint", "missing.lis"}, in_data);
  CHECK(alone.out.empty());
  CHECK(lines_of(alone.err) == 1);
}

TEST_CASE("what is no list is one line") {
  TemporaryFolder const folder;
  auto const check = [&](std::string const& name, std::string_view bytes, std::string const& expected) {
    auto const outcome = run_axisc({"lint", folder.write(name, bytes)});
    INFO(name);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(lines_of(outcome.err) == 1);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains(expected));
  };
  check("binary.lis", std::string(4096, '\x01'), "AX9001]");
  check("image.lis", std::string("AXIM") + std::string(200, '\0'), "coefficient image");
  check("utf16.lis", std::string("\xFF\xFEk\0o\0p\0f\0", 10), "UTF-16");
  check("long.lis", std::string(100'000'000, 'a'), "AX9003]");
  std::filesystem::create_directories(folder / "empty");
  CHECK_THAT(run_axisc({"lint", folder / "empty"}).err, Catch::Matchers::Contains("holds no list"));
}

TEST_CASE("an NC program is an input") {
  TemporaryFolder const folder;
  auto const part = folder.write("part.nc", "N10 #FILTER ON [ORDR=20]\nN20 M30\n");
  auto const outcome = run_axisc({"lint", part});
  CHECK(outcome.status == 1);
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out,
             Catch::Matchers::Contains("AX5002") && Catch::Matchers::Contains("1 file: 1 error"));
  CHECK(run_axisc({"lint", folder.write("clean.NC", "N10 G01 X5\n")}).status == 0);
  auto const compiled = run_axisc({"compile", part, "-o", folder / "out.axim", "--cycle-time", "1ms"});
  CHECK(compiled.status == 2);
  CHECK_THAT(compiled.err, Catch::Matchers::Contains("is an NC program"));
}

TEST_CASE("an empty list is a list") {
  TemporaryFolder const folder;
  auto const outcome = run_axisc({"lint", folder.write("empty.lis", "")});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
}

TEST_CASE("standard input is a list named -") {
  auto const outcome =
      run_axisc({"lint", "-", "--format", "json"},
                {.folder = ".", .input = wrong, .out = {}, .variables = {}, .closed_pipe = false});
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("\"file\": \"-\""));
}

TEST_CASE("the output is the same for every number of threads") {
  TemporaryFolder const folder;
  std::string const list = axisc::test::read_source_file("tests/cli/data/mistakes.lis");
  for (int i = 0; i < 40; ++i) folder.write("axis" + std::to_string(i) + ".lis", list);
  folder.write("machine/x.lis", list);
  folder.write("machine/part.nc", "#FILTER ON [ORDER=999]\n#VIB GUARD ON [MODE=7]\n");
  folder.write(
      "machine/m.json",
      R"({"axes": [{"name": "X", "list": "x.lis"}], "programs": ["part.nc"], "filter_sets": ["#FILTER ON [ORDR=1]"]})");
  folder.write("other.nc", "#FILTER ON [ORDER=20 ORDER=30]\n");
  for (std::string const format : {"text", "json", "sarif", "github", "gitlab", "junit"}) {
    auto const one = run_axisc({"lint", folder.path(), "-j", "1", "--format", format});
    auto const eight = run_axisc({"lint", folder.path(), "-j", "8", "--format", format});
    CHECK(one.status == 1);
    CHECK(one.out.size() > 1000);
    CHECK(one.out == eight.out);
    CHECK(one.err == eight.err);
  }
}

TEST_CASE("the assumed cycle time is said once per run") {
  TemporaryFolder const folder;
  for (auto const* const name : {"a.lis", "b.lis", "c.lis"})
    folder.write(name, read_source_file("tests/cli/data/warning.lis"));
  auto const times = [](std::string const& text) {
    std::size_t count = 0;
    for (auto at = text.find("AX9006"); at != std::string::npos; at = text.find("AX9006", at + 1)) ++count;
    return count;
  };
  auto const outcome = run_axisc({"lint", folder.path()});
  CHECK(times(outcome.out) == 1);
  CHECK_THAT(outcome.out, Catch::Matchers::StartsWith("note[AX9006]"));
  CHECK(times(run_axisc({"lint", folder.path(), "--format", "json"}).out) == 1);
  CHECK(times(run_axisc({"lint", folder.path(), "--disable", "AX9006"}).out) == 0);
  CHECK(times(run_axisc({"lint", folder.path(), "--quiet"}).out) == 0);
  CHECK(times(run_axisc({"lint", folder.path(), "--cycle-time", "1ms"}).out) == 0);
}

TEST_CASE("a list is linted once, through its machine file") {
  auto const outcome =
      run_axisc({"lint", "machine/x.lis", "machine", "--format", "json", "--pedantic"}, in_data);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("\"files\": 3"));
  CHECK_THAT(outcome.out, !Catch::Matchers::Contains("AX9006"));
}

TEST_CASE("the build of the control is named on the command line") {
  TemporaryFolder const folder;
  auto const path = folder.write("x.lis", "filter_fir.quality 0.5\nEnde\n");
  CHECK(run_axisc({"lint", path}).out.find("AX2016") == std::string::npos);
  CHECK_THAT(run_axisc({"lint", path, "--build", "V3.1.3075.02"}).out, Catch::Matchers::Contains("AX2016"));
  CHECK(run_axisc({"lint", path, "--build", "V3.1.3075.04"}).out.find("AX2016") == std::string::npos);
  for (auto const* const build : {"3075", "V3.1", "V3.1.x", "V3.1.3075.04.1", ""}) {
    auto const outcome = run_axisc({"lint", path, "--build", build});
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains("V3.1.3075.04"));
  }
}

TEST_CASE("quiet means findings alone") {
  auto const outcome = run_axisc({"lint", "machine", "--quiet"}, in_data);
  CHECK(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.empty());
}

TEST_CASE("the language comes from the locale, colours only when asked for") {
  auto german = in_data;
  german.variables = {"LANG=de_DE.UTF-8"};
  CHECK_THAT(run_axisc({"lint", "missing.lis"}, german).err,
             Catch::Matchers::StartsWith("axisc: Fehler[AX9001]: "));
  auto const colored = run_axisc({"lint", "warning.lis", "--color", "always"}, in_data);
  CHECK_THAT(colored.out, Catch::Matchers::Contains("\x1B["));
  CHECK_THAT(run_axisc({"lint", "warning.lis"}, in_data).out, !Catch::Matchers::Contains("\x1B["));
}

TEST_CASE("mistakes on the command line are one line with a way out") {
  auto const check = [](std::vector<std::string> const& arguments, std::string const& expected) {
    auto const outcome = run_axisc(arguments);
    INFO(expected);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err == "axisc: error: " + expected + "\n");
  };
  check({"lnit"}, "there is no command \"lnit\"; did you mean \"lint\"?");
  check({"lint", "x.lis", "--cycle-time", "1,5ms"},
        "\"1,5ms\" is not a valid cycle time; write 1ms, 250us or 1000 (µs), in whole nanoseconds");
  check({"lint", "x.lis", "--disable", "AX3O05"}, "there is no code \"AX3O05\"; did you mean AX3005?");
  check({"lint", "x.lis", "--axis-type", "X"}, "--axis-type does not know \"X\"; choose from T, R, S");
  check({"lint", "x.lis", "-j", "0"}, "-j needs a positive whole number, not \"0\"");
  check({"lint", "-x"}, "\"axisc lint\" has no option -x; `axisc lint --help` lists them");
  check({"--foo"}, "there is no option --foo; `axisc --help` lists the commands");
  check({"-x"}, "there is no option -x; `axisc --help` lists the commands");
}

TEST_CASE("the program alone shows the commands") {
  auto const help = run_axisc({"--help"});
  CHECK(help.status == 0);
  for (auto const& arguments : {std::vector<std::string>{}, {"--color", "never"}}) {
    auto const alone = run_axisc(arguments);
    CHECK(alone.status == 2);
    CHECK(alone.out.empty());
    CHECK(alone.err == help.out);
  }
  CHECK(run_axisc({"help"}).out == help.out);
  CHECK(run_axisc({"help", "lint"}).out == run_axisc({"lint", "--help"}).out);
  CHECK(run_axisc({"--lang", "de", "help", "lint"}).out == run_axisc({"lint", "--help", "--lang", "de"}).out);
  for (std::string const word : {"version", "-V"})
    CHECK(run_axisc({word}).out == run_axisc({"--version"}).out);
  CHECK(run_axisc({"lint", "-V"}).out == run_axisc({"--version"}).out);
}

TEST_CASE("every command has its own help in both languages") {
  for (std::string const command :
       {"lint", "fmt", "compile", "inspect", "run", "response", "explain", "diff"}) {
    auto const english = run_axisc({command, "--help"});
    auto const german = run_axisc({command, "--help", "--lang", "de"});
    CHECK(english.status == 0);
    CHECK_THAT(english.out, Catch::Matchers::Contains("Usage: axisc " + command) &&
                                Catch::Matchers::Contains("Examples:"));
    CHECK_THAT(german.out, Catch::Matchers::Contains("Aufruf: axisc " + command) &&
                               Catch::Matchers::Contains("Beispiele:"));
    CHECK_THAT(run_axisc({"--help"}).out, Catch::Matchers::Contains("  " + command + " "));
    CHECK_THAT(run_axisc({command, "--version"}).out, Catch::Matchers::StartsWith("axisc "));
  }
}

TEST_CASE("placeholders are in the language of the help") {
  CHECK_THAT(run_axisc({"explain", "--help", "--lang", "de"}).out,
             Catch::Matchers::Contains("[OPTIONEN] WÖRTER"));
  CHECK_THAT(run_axisc({"set", "--help", "--lang", "de"}).out,
             Catch::Matchers::Contains("[OPTIONEN] EINGABE ACHSE PARAMETER=WERT..."));
  auto const compile = run_axisc({"compile", "--help", "--lang", "de"}).out;
  CHECK_THAT(compile, Catch::Matchers::Contains("[OPTIONEN] EINGABE...") &&
                          Catch::Matchers::Contains("--output ZIEL.axim") &&
                          Catch::Matchers::Contains("--depfile DATEI"));
  CHECK_THAT(run_axisc({"compile", "--lang", "de"}).err, Catch::Matchers::Contains("EINGABE fehlt"));
  CHECK_THAT(run_axisc({"compile", "--help"}).out, Catch::Matchers::Contains("[OPTIONS] INPUT..."));
}

TEST_CASE("a report says which inputs could not be read") {
  auto const outcome = run_axisc({"lint", "missing.lis", "warning.lis", "--format", "sarif"}, in_data);
  CHECK(outcome.status == 2);
  CHECK(sarif_complaints(outcome.out) == std::vector<std::string>{});
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("\"executionSuccessful\": false") &&
                              Catch::Matchers::Contains("cannot read missing.lis"));
}

TEST_CASE("standard input is a machine file if it begins with a brace") {
  TemporaryFolder const folder;
  folder.write("x.lis", "kopf.achs_nr 1\nfilter[0].order 9\n");
  auto there = in_folder(folder.path());
  there.input = R"({"machine": "m", "cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}]})";
  auto const outcome = run_axisc({"lint", "-"}, there);
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.out,
             Catch::Matchers::Contains("--> x.lis:2:17") && Catch::Matchers::Contains("2 files: "));
}

TEST_CASE("standard input may be the text of a file with a name") {
  TemporaryFolder const folder;
  folder.write("axes/x.lis", "on disk\n");
  folder.write("axes/axisc.json",
               R"({"cycle_time_us": 2000, "paths": [{"pattern": "x.lis", "disable": ["AX2001"]}]})");
  auto there = in_folder(folder.path());
  there.input = "filter[0].enable 1\nfilter[0].order 2\nfilter[0].fg_f0 300\nfoo.bar 1\n";
  auto const outcome = run_axisc({"lint", "-", "--stdin-filename", "axes/x.lis"}, there);
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.out, Catch::Matchers::Contains("--> axes/x.lis:3:17") &&
                              Catch::Matchers::Contains("250 Hz") && !Catch::Matchers::Contains("foo.bar"));
  there.input = "Filter[0].order 2\n";
  auto const fixed = run_axisc({"lint", "-", "--stdin-filename", "axes/x.lis", "--fix"}, there);
  CHECK(fixed.out == "filter[0].order 2\n");
  CHECK(folder.read("axes/x.lis") == "on disk\n");
}

TEST_CASE("a cycle time that no control has is a mistaken unit") {
  TemporaryFolder const folder;
  folder.write("x.lis", "filter[0].enable 1\nfilter[0].order 2\nfilter[0].fg_f0 600\n");
  auto const there = in_folder(folder.path());
  auto const refused = [&](std::string const& time, std::string const& said) {
    auto const outcome = run_axisc({"lint", "x.lis", "--cycle-time", time}, there);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains(said));
  };
  refused("1", "1 µs? A cycle time is between 20 µs and 100 ms; write 1ms");
  refused("0.5", "write 0.5ms");
  refused("0.001", "write 1ms");
  refused("1s", "write 1ms");
  refused("19us", "19 µs?");
  for (std::string const time : {"20us", "62.5us", "100ms"}) {
    CHECK(run_axisc({"lint", "x.lis", "--cycle-time", time}, there).status != 2);
  }
  folder.write("axisc.json", R"({"cycle_time_us": 1})");
  auto const settings = run_axisc({"lint", "x.lis"}, there);
  CHECK(settings.status == 2);
  CHECK_THAT(settings.err, Catch::Matchers::Contains("axisc.json:1:19"));
}

TEST_CASE("the text of an editor is judged in the machine of its file") {
  TemporaryFolder const folder;
  folder.write(
      "machine.json",
      R"({"cycle_time_us": 1000, "default_list": "all.lis", "axes": [{"name": "X", "list": "./x.lis"}]})");
  folder.write("all.lis", "filter[0].enable 1\nfilter[0].type LOWPASS\nunknown.of.defaults 1\n");
  folder.write("x.lis", "kopf.achs_nr 1\n");
  auto surroundings = in_folder(folder.path());
  // 600 Hz is above half the sampling frequency of the machine; alone the list has no such filter and no
  // cycle time.
  surroundings.input = "kopf.achs_nr 1\nfilter[0].order 2\nfilter[0].fg_f0 600\n";
  auto const outcome =
      run_axisc({"lint", "-", "--stdin-filename", "x.lis", "--format", "json", "--lang", "en"}, surroundings);
  auto const findings = nlohmann::json::parse(outcome.out)["diagnostics"];
  REQUIRE(findings.size() == 1);
  CHECK(findings[0]["code"] == "AX3002");
  CHECK(findings[0]["file"] == "./x.lis");
  CHECK(outcome.status == 1);
}

TEST_CASE("a named list is judged in the machine that reads it") {
  TemporaryFolder const folder;
  folder.write("machine.json",
               R"({"cycle_time_us": 2000,
          "axes": [{"name": "X", "list": "lists/x.lis"}, {"name": "Y", "list": "lists/y.lis"}]})");
  // Above half of the sampling frequency with 2 ms alone.
  folder.write(
      "lists/x.lis",
      "kopf.achs_nr 1\nfilter[0].enable 1\nfilter[0].type LOWPASS\nfilter[0].order 1\nfilter[0].fg_f0 300\n");
  folder.write("lists/y.lis", "kopf.achs_nr 1\nnonsense 3\n");
  auto const lint = [&](std::vector<std::string> words, std::string const& where = "") {
    words.insert(words.begin(), {"lint", "--lang", "en"});
    return run_axisc(words, in_folder(folder.path() + where));
  };
  SECTION("from every working folder, with what is wrong elsewhere") {
    auto const named = lint({"lists/x.lis"});
    CHECK(named.status == 1);
    CHECK_THAT(named.out, Catch::Matchers::Contains("AX3002"));
    CHECK_THAT(named.out, !Catch::Matchers::Contains("nonsense"));
    CHECK_THAT(named.err, Catch::Matchers::Contains(
                              "lists/x.lis was judged in machine.json, which has errors in other files: 1"));
    auto const below = lint({"x.lis"}, "/lists");
    CHECK(below.status == 1);
    CHECK_THAT(below.out, Catch::Matchers::Contains("AX3002"));
    CHECK_THAT(lint({"."}, "/lists").out,
               Catch::Matchers::Contains("AX3002") && Catch::Matchers::Contains("nonsense"));
  }
  SECTION("alone") {
    auto const alone = lint({"lists/x.lis", "--alone", "--cycle-time", "1ms"});
    CHECK(alone.status == 0);
    CHECK(alone.err.empty());
  }
  SECTION("fixes change the named file alone") {
    folder.write("lists/x.lis", "kopf.achs_nr 1\nfilter[0].order 1,0\n");
    folder.write("lists/y.lis", "kopf.achs_nr 2\nfilter[0].order 1,0\n");
    CHECK(lint({"lists/x.lis", "--fix=all"}).status == 0);
    CHECK(folder.read("lists/x.lis") == "kopf.achs_nr 1\nfilter[0].order 1\n");
    CHECK(folder.read("lists/y.lis") == "kopf.achs_nr 2\nfilter[0].order 1,0\n");
  }
}

TEST_CASE("a list whose lines end with CR alone is not to become one line") {
  TemporaryFolder const folder;
  folder.write("x.lis", "kopf.achs_nr 1\rkenngr.achs_typ 1\rEnde\r");
  auto const outcome = run_axisc({"lint", "x.lis", "--cycle-time", "1ms"}, in_folder(folder.path()));
  CHECK_THAT(outcome.out,
             Catch::Matchers::Contains("help: where it was meant to end a line, save the file again"));
}

TEST_CASE("one cycle is one cycle in both languages") {
  TemporaryFolder const folder;
  folder.write("x.lis", "kopf.achs_nr 1\nfilter_fir.type 4\nfilter_fir.order 1\nfilter_fir.enable 1\nEnde\n");
  folder.write("y.lis", "kopf.achs_nr 2\nEnde\n");
  folder.write("machine.json", R"({"cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"},
                                   {"name": "Y", "list": "y.lis"}]})");
  auto const said = [&](std::string const& language) {
    return run_axisc({"lint", "machine.json", "--lang", language}, in_folder(folder.path())).out;
  };
  CHECK_THAT(said("en"), Catch::Matchers::Contains("delays differ by 1 cycle (1 ms)") &&
                             Catch::Matchers::Contains("axis \"Y\": 0 cycles"));
  CHECK_THAT(said("de"), Catch::Matchers::Contains("um 1 Zyklus (1 ms)") &&
                             Catch::Matchers::Contains("Achse „Y“: 0 Zyklen"));
}

}  // namespace lint_test
