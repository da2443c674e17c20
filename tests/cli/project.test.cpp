// A TwinCAT 3 project: the same machine as a controller's folder, and repairs inside CDATA sections only.
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>

namespace project_test {

using namespace axisc::test;
namespace fs = std::filesystem;

namespace {

constexpr char const* project = "project/hochlauf.tsproj";

Surroundings copy_of_sample(TemporaryFolder const& folder, std::string const& name = "controller-project") {
  fs::copy(std::string(AXISC_SOURCE_DIR "/samples/") + name, folder.path(), fs::copy_options::recursive);
  return in_folder(folder.path());
}

/// Replaces every occurrence.
std::string replaced(std::string text, std::string const& from, std::string const& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace

TEST_CASE("a stock project is checked as the machine that it is, in silence") {
  TemporaryFolder const folder;
  auto const there = copy_of_sample(folder);
  for (std::string const input : {".", "project", project}) {
    auto const outcome = run_axisc({"lint", input, "--pedantic"}, there);
    CHECK(outcome.status == 0);
    CHECK(outcome.out == "2 files: no findings\n");
  }
}

TEST_CASE("the machine of a project as it was understood, which no machine file can name") {
  TemporaryFolder const folder;
  auto const there = copy_of_sample(folder);
  for (std::string const language : {"en", "de"}) {
    auto const outcome = run_axisc({"machine", ".", "--lang", language}, there);
    CHECK(outcome.status == 0);
    check_golden("tests/cli/data/golden/machine.project." + language, outcome.out);
  }
  auto const outcome = run_axisc({"machine", ".", "--format", "json"}, there);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.find("a machine file can only name files") != std::string::npos);
}

TEST_CASE("a project and the folder of the same lists give one image and the same figures") {
  TemporaryFolder const folder;
  TemporaryFolder const lists;
  auto const of_project = copy_of_sample(folder);
  auto const of_lists = copy_of_sample(lists, "controller");
  REQUIRE(run_axisc({"compile", ".", "-o", "m.axim", "--quiet"}, of_project).status == 0);
  REQUIRE(run_axisc({"compile", ".", "-o", "m.axim", "--quiet"}, of_lists).status == 0);
  CHECK(folder.read("m.axim") == lists.read("m.axim"));
  auto const contour = run_axisc({"contour", ".", "--feed", "4000"}, of_project);
  CHECK(contour.status == 0);
  CHECK(contour.out == run_axisc({"contour", ".", "--feed", "4000"}, of_lists).out);
  std::vector<std::string> const simulate{"simulate", ".", "--group", "Fraesen", "--program", "part.nc"};
  for (auto const* const each : {&folder, &lists}) {
    each->write("part.nc", "G01 X10 F4000\nX10 Y10\nX0 Y0\nM30\n");
  }
  auto const simulated = run_axisc(simulate, of_project);
  CHECK(simulated.status == 0);
  CHECK(simulated.out == run_axisc(simulate, of_lists).out);
  auto const same = run_axisc({"diff", ".", lists.path()}, of_project);
  CHECK(same.status == 0);
  CHECK(same.out.find("mean the same") != std::string::npos);
}

TEST_CASE("findings stand in the lines of the project, and repairs change its CDATA sections only") {
  TemporaryFolder const folder;
  auto const there = copy_of_sample(folder);
  std::string const healthy = folder.read(project);
  std::string const broken = replaced(healthy, "filter_fir.order ", "filter_fir.ordre ");
  folder.write(project, broken);
  check_golden("tests/cli/data/golden/project.mistakes.txt", run_axisc({"lint", "."}, there).out);
  auto const sarif = run_axisc({"lint", ".", "--format", "sarif"}, there).out;
  CHECK(sarif.find("\"startLine\": 72") != std::string::npos);
  CHECK(run_axisc({"lint", ".", "--fix=all"}, there).status == 0);
  // Four lists of one file, CRLF and windows-1252 all around.
  CHECK(folder.read(project) == healthy);
}

TEST_CASE("the first line of a list has the column of the file") {
  TemporaryFolder const folder;
  folder.write("a.xti",
               "<Axis>\n  <ItemName>A</ItemName><AchsMds><![CDATA[kopf.achs_nr 1\n]]></AchsMds>\n"
               "  <ItemName>B</ItemName><Axis><AchsMds><![CDATA[kopf.achs_nx 2]]></AchsMds></Axis></Axis>\n");
  auto const outcome = run_axisc({"lint", "a.xti", "--cycle-time", "1ms"}, in_folder(folder.path()));
  check_golden("tests/cli/data/golden/project.first_line.txt", outcome.out);
}

TEST_CASE("comments in a project silence findings in their list alone") {
  TemporaryFolder const folder;
  auto const list = [](std::string const& number, std::string const& rest) {
    return "<Axis><AchsMds><![CDATA[kopf.achs_nr " + number + "\n" + rest + "]]></AchsMds></Axis>\n";
  };
  folder.write("a.tsproj", "<P><Task CycleTime='10000'/>" +
                               list("1", "# axisc: allow AX2001\nfilter[0].ordre 2\n") +
                               list("2", "filter[0].ordre 2\n") + "</P>\n");
  auto const outcome = run_axisc({"lint", "a.tsproj"}, in_folder(folder.path()));
  CHECK(outcome.out.find("a.tsproj:3:1") == std::string::npos);
  CHECK(outcome.out.find("a.tsproj:6:1") != std::string::npos);
}

TEST_CASE("fmt aligns the axis lists of a project and leaves everything else") {
  TemporaryFolder const folder;
  folder.write("a.tsproj",
               "<P  a = '1'>\r\n<!-- kopf.achs_nr   1 -->\r\n<AchsMds><![CDATA[\r\nkopf.achs_nr 1\r\n"
               "kopf.log_achs_name   X\r\n]]></AchsMds>\r\n"
               "<SdaMds><![CDATA[\r\ngruppe[0].achs_anzahl      1\r\n]]></SdaMds></P>");
  auto const there = in_folder(folder.path());
  CHECK(run_axisc({"fmt", "--check", "a.tsproj"}, there).status == 1);
  CHECK(run_axisc({"fmt", "."}, there).status == 0);
  CHECK(folder.read("a.tsproj") ==
        "<P  a = '1'>\r\n<!-- kopf.achs_nr   1 -->\r\n<AchsMds><![CDATA[\r\nkopf.achs_nr        1\r\n"
        "kopf.log_achs_name  X\r\n]]></AchsMds>\r\n"
        "<SdaMds><![CDATA[\r\ngruppe[0].achs_anzahl      1\r\n]]></SdaMds></P>");
  CHECK(run_axisc({"fmt", "--check", "a.tsproj"}, there).status == 0);
  folder.write("a.tsproj", "<P>\n<A>\n</P>");
  auto const outcome = run_axisc({"fmt", "a.tsproj"}, there);
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("a.tsproj:3:3: this end tag") != std::string::npos);
}

TEST_CASE("a folder keeps quiet about projects without a CNC, and a broken one is a finding") {
  TemporaryFolder const folder;
  folder.write("Device 1.xti", "<TcSmItem><Device/></TcSmItem>");
  folder.write("x.lis", "kopf.achs_nr 1\nEnde\n");
  auto const there = in_folder(folder.path());
  CHECK(run_axisc({"lint", ".", "--cycle-time", "1ms"}, there).out.find("1 file") != std::string::npos);
  folder.write("m.tsproj", "<P><AchsMds><![CDATA[kopf.achs_nr 1\n");
  auto const outcome = run_axisc({"lint", "m.tsproj"}, there);
  CHECK(outcome.status == 1);
  CHECK(outcome.out.find("error[AX4020]") != std::string::npos);
  CHECK(outcome.out.find("m.tsproj:1:13") != std::string::npos);
}

TEST_CASE("each axis says to which channel it belongs where no channel list does") {
  TemporaryFolder const folder;
  auto const axis = [](std::string const& number, std::string const& channel, std::string const& name) {
    return "<Axis><ItemName>a" + number + "</ItemName><DefaultChannel>" + channel +
           "</DefaultChannel><DefaultProgName>" + name + "</DefaultProgName><AchsMds><![CDATA[kopf.achs_nr " +
           number + "\n]]></AchsMds></Axis>\n";
  };
  folder.write("a.tsproj",
               "<P><Channel><ItemName>Mill</ItemName><SdaMds><![CDATA[spdl_anzahl 0\n]]></SdaMds></Channel>" +
                   axis("1", "1", "X1") + axis("2", "1", "Y1") + axis("3", "2", "Z2") + "</P>");
  auto const outcome = run_axisc({"machine", "a.tsproj"}, in_folder(folder.path()));
  CHECK(outcome.out.find("  Mill     X1, Y1\n") != std::string::npos);
  CHECK(outcome.out.find("  2        Z2\n") != std::string::npos);
}

TEST_CASE("a list of another kind and another cycle time are told in words of a project") {
  TemporaryFolder const folder;
  folder.write(
      "a.tsproj",
      "<P><Task CycleTime='10000'/>\n<Axis><AchsMds><![CDATA[kopf.achs_nr 1\n]]></AchsMds></Axis>\n"
      "<Axis><ItemName>B</ItemName><AchsMds><![CDATA[gruppe[0].achs_anzahl 0\nspdl_anzahl 0\n]]></AchsMds>"
      "</Axis></P>");
  auto const outcome = run_axisc({"lint", "a.tsproj", "--cycle-time", "2ms"}, in_folder(folder.path()));
  CHECK(outcome.status == 1);
  CHECK(outcome.out.find(
            "error[AX7009]: the project holds a list of another kind here: its parameters are P-CHAN") !=
        std::string::npos);
  CHECK(outcome.out.find("a.tsproj:4:17") != std::string::npos);
  CHECK(outcome.out.find("warning[AX7012]: the task in the project has") != std::string::npos);
  CHECK(outcome.out.find("a.tsproj:1:21") != std::string::npos);
}

TEST_CASE("lists of other kinds in a project are checked line by line, by what their lines say") {
  TemporaryFolder const folder;
  std::string const axis = "<P><Task CycleTime='10000'/><AchsMds><![CDATA[kopf.achs_nr 1\n]]></AchsMds>\n";
  folder.write("a.tsproj",
               axis +
                   "<C><WerkzD><![CDATA[wz[1].gueltig 1\nwz[1].laenge 1,5\n]]></WerkzD>\n"
                   "<NullpD><![CDATA[wz[1].radius 2,5\n]]></NullpD><PzvD>text</PzvD><VeD/></C></P>");
  auto const there = in_folder(folder.path());
  auto const outcome = run_axisc({"lint", "a.tsproj"}, there);
  CHECK(outcome.out.find("error[AX1005]: `1,5` has a decimal comma\n --> a.tsproj:4:14") !=
        std::string::npos);
  CHECK(outcome.out.find("error[AX1005]: `2,5` has a decimal comma\n --> a.tsproj:6:31") !=
        std::string::npos);
  CHECK(outcome.out.find("AX2001") == std::string::npos);
  CHECK(outcome.out.find("AX4020") == std::string::npos);
  folder.write("b.tsproj", "<P><WerkzD><![CDATA[wz[1].laenge 1\n]]></WerkzD></P>");
  CHECK(run_axisc({"lint", "b.tsproj"}, there).out.find("holds no list") != std::string::npos);
}

}  // namespace project_test
