// Lists in XML: checked as lists of their kind, and a start-up list in XML is a machine.
#include "cli/program.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>

using namespace axisc::test;
namespace fs = std::filesystem;

namespace {

Surroundings copy_of_sample(TemporaryFolder const& folder, std::string const& name) {
  fs::copy(std::string(AXISC_SOURCE_DIR "/samples/") + name, folder.path(), fs::copy_options::recursive);
  return in_folder(folder.path());
}

std::string replaced(std::string text, std::string const& from, std::string const& to) {
  auto const at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("a controller's folder with lists in XML is the machine of the same lists as text") {
  TemporaryFolder const folder;
  TemporaryFolder const lists;
  auto const of_xml = copy_of_sample(folder, "controller-xml");
  auto const of_lists = copy_of_sample(lists, "controller");
  auto const linted = run_axisc({"lint", ".", "--pedantic"}, of_xml);
  CHECK(linted.status == 0);
  CHECK(linted.out == "18 files: no findings\n");
  std::string machine = run_axisc({"machine", "."}, of_xml).out;
  check_golden("tests/cli/data/golden/xml/machine.txt", machine);
  for (auto const& words : std::vector<std::vector<std::string>>{
           {"contour", ".", "--feed", "4000"},
           {"simulate", ".", "--group", "Fraesen", "--program", "part.nc"}}) {
    for (auto const* const each : {&folder, &lists}) {
      each->write("part.nc", "G01 X10 F4000\nX10 Y10\nX0 Y0\nM30\n");
    }
    auto const outcome = run_axisc(words, of_xml);
    CHECK(outcome.status == 0);
    CHECK(outcome.out == run_axisc(words, of_lists).out);
  }
}

TEST_CASE("images of lists in XML differ from those of lists as text in what names the files alone") {
  TemporaryFolder const folder;
  TemporaryFolder const lists;
  auto const of_xml = copy_of_sample(folder, "controller-xml");
  auto const of_lists = copy_of_sample(lists, "controller");
  REQUIRE(run_axisc({"compile", ".", "-o", "m.axim", "--quiet", "--strip"}, of_xml).status == 0);
  REQUIRE(run_axisc({"compile", ".", "-o", "m.axim", "--quiet", "--strip"}, of_lists).status == 0);
  std::string const one = folder.read("m.axim");
  std::string const other = lists.read("m.axim");
  REQUIRE(one.size() == other.size());
  // The digest of the sources and the image's own.
  std::size_t differing = 0;
  for (std::size_t i = 0; i < one.size(); ++i) differing += one[i] == other[i] ? 0U : 1U;
  CHECK(differing <= 36);
  auto const same = run_axisc({"diff", ".", lists.path()}, of_xml);
  CHECK(same.status == 0);
}

TEST_CASE("an update file is checked by what it holds, at its elements and attributes, and never changed") {
  TemporaryFolder const folder;
  std::string const update =
      "<?xml version=\"1.0\" encoding=\"windows-1252\"?>\r\n"
      "<AX_MDS>\r\n"
      "  <Achse><P-AXIS-00016 Value=\"1\"/> <P-AXIS-00008.9 Value=\"1\"/></Achse>\r\n"
      "  <P-AXIS-99999 Value=\"1\"/>\r\n"
      "  <!-- kein gültiger Wert -->\r\n"
      "  <P-AXIS-00587 Value='1000&#48;'/>\r\n"
      "  <P-AXIS-00586 Value=\"GAUS\"/>\r\n"
      "  <P-AXIS-00016 Value=\"\"/>\r\n"
      "</AX_MDS>\r\n";
  folder.write("update.xml", update);
  auto const there = in_folder(folder.path());
  auto const outcome = run_axisc({"lint", "update.xml", "--fix=all"}, there);
  CHECK(outcome.status == 1);
  check_golden("tests/cli/data/golden/xml/mistakes.txt", outcome.out);
  CHECK(folder.read("update.xml") == update);
  // Found in a folder as well; other XML files are not lists.
  folder.write("other.xml", "<project/>");
  CHECK(run_axisc({"lint", ".", "--fix=all"}, there).out == outcome.out);
  CHECK(run_axisc({"fmt", "update.xml"}, there).status == 0);
  CHECK(folder.read("update.xml") == update);
  auto const compiled = run_axisc({"compile", "update.xml", "-o", "m.axim"}, there);
  CHECK(compiled.status != 0);
  CHECK_FALSE(fs::exists(folder.path() + "/m.axim"));
}

TEST_CASE("an update that is right says nothing, whatever it leaves out") {
  TemporaryFolder const folder;
  folder.write("update.xml", "<AX_MDS><P-AXIS-00587 Value=\"10\"/></AX_MDS>");
  auto const outcome = run_axisc({"lint", "update.xml", "--pedantic"}, in_folder(folder.path()));
  CHECK(outcome.status == 0);
  CHECK(outcome.out == "1 file: no findings\n");
}

TEST_CASE("an update has no image: its machine has") {
  TemporaryFolder const folder;
  folder.write("update.xml", "<AX_MDS><P-AXIS-00016 Value=\"1\"/></AX_MDS>");
  folder.write("channel.xml", "<SDA_MDS><P-CHAN-00006.1 Value=\"Y\"/></SDA_MDS>");
  auto const refusal = [&folder](std::vector<std::string> const& words) {
    auto const outcome = run_axisc(words, in_folder(folder.path()));
    CHECK(outcome.status == 2);
    return outcome.err;
  };
  CHECK_THAT(
      refusal({"compile", "update.xml", "-o", "m.axim", "--cycle-time", "1ms"}),
      Catch::Matchers::Contains("update.xml is an axis list in XML, which by itself holds only changes; "
                                "name the machine that it belongs to: its start-up list"));
  CHECK_THAT(refusal({"compile", "channel.xml", "-o", "m.axim", "--cycle-time", "1ms"}),
             Catch::Matchers::Contains("channel.xml is not an axis list"));
}

TEST_CASE("XML that is malformed or no list is told with its place") {
  TemporaryFolder const folder;
  folder.write("cut.xml", "<AX_MDS>\n  <P-AXIS-00016 Value=\"1\"/>\n");
  folder.write("other.xml", "<?xml version='1.0'?>\n<project/>\n");
  auto const there = in_folder(folder.path());
  for (std::string const file : {"cut.xml", "other.xml"}) {
    auto const outcome = run_axisc({"lint", file}, there);
    CHECK(outcome.status == 1);
    check_golden("tests/cli/data/golden/xml/" + file + ".txt", outcome.out);
  }
}

TEST_CASE(
    "a start-up list in XML may name lists of both forms, and a mistake stands in the line that names it") {
  TemporaryFolder const folder;
  auto const there = copy_of_sample(folder, "controller-xml");
  std::string const start_up = folder.read("listen/hochlauf.xml");
  folder.write("listen/hochlauf.xml", replaced(start_up, "achsmds5.xml", "fehlt.xml"));
  folder.write("listen/achsmds3.xml", replaced(folder.read("listen/achsmds3.xml"), "P-AXIS-00016 Value=\"3\"",
                                               "P-AXIS-00016 Value=\"2\""));
  auto const outcome = run_axisc({"lint", "."}, there);
  CHECK(outcome.status == 1);
  check_golden("tests/cli/data/golden/xml/machine_mistakes.txt", outcome.out);
}
