// A folder passes over nothing that may have been a list, a project or a machine file: what is cut off,
// encoded otherwise or misspelt is told, in each file that the check of a folder reads.
#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>
#include <set>

namespace damaged_folder_test {

using namespace axisc::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

std::string const project =
    "<?xml version=\"1.0\"?>\n<TcSmItem><Axis><AchsMds><![CDATA[filter[0].order "
    "1,5\n]]></AchsMds></Axis></TcSmItem>\n";
std::string const machine =
    R"({"machine": "m", "cycle_time_us": 1000, "axes": [{"name": "X", "list": "x.lis"}]})";
std::string const xml_list =
    "<?xml version=\"1.0\"?>\n<AX_MDS>\n  <P-AXIS-00140.0 Value=\"1\"/>\n</AX_MDS>\n";

/// Every character of ASCII as two bytes, the low one first, after a byte order mark.
std::string utf16(std::string const& text) {
  std::string bytes = "\xFF\xFE";
  for (char const character : text) bytes.append(1, character).append(1, '\0');
  return bytes;
}

/// What lint says of a folder that holds a sound list and this file.
Outcome lint_beside_sound_list(std::string const& name, std::string const& bytes) {
  TemporaryFolder const folder;
  folder.write("ok.lis", "filter[0].enable 0\n");
  folder.write(name, bytes);
  return run_axisc({"lint", ".", "--cycle-time", "1ms"}, in_folder(folder.path()));
}

void is_told(std::string const& name, std::string const& bytes, std::string const& code) {
  INFO(name << ": " << bytes);
  auto const outcome = lint_beside_sound_list(name, bytes);
  CHECK(outcome.status == (code == "AX9001" ? 2 : 1));
  CHECK_THAT(outcome.out + outcome.err, Contains(name) && Contains(code));
}

void is_passed_over(std::string const& name, std::string const& bytes) {
  INFO(name << ": " << bytes);
  auto const outcome = lint_beside_sound_list(name, bytes);
  CHECK(outcome.status == 0);
  CHECK(outcome.out == "1 file: no findings\n");
  CHECK(outcome.err.empty());
}

/// Lengths from nothing to just before the end.
std::set<std::size_t> cuts_of(std::string const& bytes) {
  constexpr std::size_t most = 40;
  std::size_t const end = bytes.find_last_not_of(" \t\r\n");
  std::set<std::size_t> cuts{0, 1, end};
  for (std::size_t i = 0; i < most; ++i) cuts.insert(i * end / most);
  return cuts;
}

}  // namespace

TEST_CASE("a folder tells files that cannot be decoded", "[damage]") {
  for (auto const& [name, bytes] : {std::pair<std::string, std::string>("p.tsproj", project),
                                    {"p.xti", project},
                                    {"machine.json", machine},
                                    {"mill.json", machine},
                                    {"x.xml", xml_list},
                                    {"hochlauf.xml", "<StartUp><P-STUP-00014 Value=\"0\"/></StartUp>"}}) {
    is_told(name, utf16(bytes), "AX9001");
  }
  is_told("MACHINE.JSON", std::string(200, '\x01'), "AX9001");
}

TEST_CASE("a folder tells projects, machine files and XML lists that are cut off anywhere", "[damage]") {
  for (auto const& [name, bytes] : {std::pair<std::string, std::string>("p.tsproj", project),
                                    {"p.xti", project},
                                    {"machine.json", machine},
                                    {"x.xml", xml_list}}) {
    for (std::size_t const size : cuts_of(bytes)) is_told(name, bytes.substr(0, size), "AX4020");
  }
}

TEST_CASE("files of the samples that are cut off are told", "[damage]") {
  for (std::string const sample : {"controller-xml", "controller-project", "mill"}) {
    TemporaryFolder const folder;
    fs::copy(std::string(AXISC_SOURCE_DIR "/samples/") + sample, folder.path(), fs::copy_options::recursive);
    std::vector<std::string> names;
    for (auto const& entry : fs::recursive_directory_iterator(folder.path())) {
      auto const name = entry.path().lexically_relative(folder.path()).string();
      if (name.ends_with(".xml") || name.ends_with(".tsproj") || name.ends_with("machine.json"))
        names.push_back(name);
    }
    CHECK_FALSE(names.empty());
    for (auto const& name : names) {
      auto const whole = folder.read(name);
      for (std::size_t const size : {std::size_t{0}, whole.size() / 3, whole.size() / 2}) {
        INFO(name << ", cut to " << size);
        folder.write(name, whole.substr(0, size));
        auto const outcome = run_axisc({"lint", ".", "--cycle-time", "1ms"}, in_folder(folder.path()));
        CHECK(outcome.status == 1);
        CHECK_THAT(outcome.out, Contains(name) && Contains("error[AX4020]"));
      }
      folder.write(name, whole);
    }
  }
}

TEST_CASE("machine.json is a machine file, whatever is in it", "[damage]") {
  for (std::string const& bytes :
       {std::string("{}"), std::string("[]"), std::string("null"), std::string("\n"),
        std::string("version https://git-lfs.github.com/spec/v1\n"), std::string("<<<<<<< HEAD\n") + machine,
        std::string(R"({"machine": "m", "axis": [{"name": "X", "list": "gone.lis"}]})")}) {
    is_told("machine.json", bytes, "AX4020");
    TemporaryFolder const folder;
    folder.write("machine.json", bytes);
    CHECK(run_axisc({"lint", "machine.json"}, in_folder(folder.path())).status == 1);
  }
  TemporaryFolder const folder;
  folder.write("mill.json", "");
  auto const named = run_axisc({"lint", "mill.json"}, in_folder(folder.path()));
  CHECK(named.status == 1);
  CHECK_THAT(named.out, Contains("mill.json:1:1") && Contains("AX4020"));
}

TEST_CASE("XML that may have been a list, and projects that are not XML any more, are told", "[damage]") {
  is_told("x.xml", "<!DOCTYPE AX_MDS>\n" + xml_list, "AX4020");
  is_told("x.xml", "<!DOCTYPE a [<!-- don't -->\n<!ENTITY b ']>'>]><AX_MDS/>", "AX4020");
  is_told("x.xml", "<ax_mds><P-AXIS-00140.0 Value=\"1\"/></ax_mds>", "AX4020");
  is_told("x.xml", "<t:AX_MDS xmlns:t='x'><P-AXIS-00140.0 Value=\"1\"/></t:AX_MDS>", "AX4020");
  is_told("x.xml", "version https://git-lfs.github.com/spec/v1\n", "AX4020");
  is_told("x.xml", "<<<<<<< HEAD\n" + xml_list, "AX4020");
  is_told("p.tsproj", "<TcSmItem><Axis></TcSmItem>", "AX4020");
  is_told("p.tsproj", "version https://git-lfs.github.com/spec/v1\n", "AX4020");
  is_told("p.tsproj", "<P><t:AchsMds><![CDATA[kopf.achs_nr 1]]></t:AchsMds></P>", "AX4020");
  is_told("p.tsproj", "<P><achsmds><![CDATA[kopf.achs_nr 1]]></achsmds></P>", "AX4020");
}

TEST_CASE("what says itself that it is something else is passed over without a word", "[damage]") {
  is_passed_over("p.tsproj", "<TcSmProject><Project><Plc/></Project></TcSmProject>");
  is_passed_over("p.tsproj", "<TcSmProject><!-- <AchsMds> --></TcSmProject>");
  is_passed_over("pom.xml", "<?xml version=\"1.0\"?>\n<project><name>x</name></project>\n");
  is_passed_over("page.xml",
                 "<!DOCTYPE html PUBLIC \"-//W3C//DTD XHTML 1.0//EN\" \"x.dtd\">\n<html>&nbsp;</html>");
  is_passed_over("task.xml",
                 utf16("<?xml version=\"1.0\" encoding=\"UTF-16\"?>\n<Task version=\"1.2\"></Task>\n"));
  is_passed_over("app.xml", "<startup useLegacyV2RuntimeActivationPolicy=\"true\"/>");
  is_passed_over("broken.xml", "<project><name></project>");
  is_passed_over("package.json", R"({"name": "x", "scripts": {}})");
  is_passed_over("settings.json", "{\n  // editor\n  \"editor.tabSize\": 2,\n}\n");
  is_passed_over("utf16.json", utf16(R"({"name": "x", "version": 1})"));
  is_passed_over("list.json", "[1, 2]");
}

TEST_CASE("JSON that is cut off or not text is named, as nobody can tell what it was", "[damage]") {
  for (std::string const& bytes :
       {std::string(), std::string("{\"mach"), std::string("{\"a\": 1,\n"), std::string(200, '\x01')}) {
    auto const outcome = lint_beside_sound_list("mill.json", bytes);
    CHECK(outcome.status == 0);
    CHECK_THAT(outcome.err, Contains("axisc: note: ./mill.json") || Contains("axisc: note: mill.json"));
  }
  TemporaryFolder const folder;
  folder.write("a/mill.json", "");
  folder.write("a/ok.lis", "filter[0].enable 0\n");
  auto const there = in_folder(folder.path());
  CHECK(run_axisc({"lint", "a", "--quiet"}, there).err.empty());
  folder.write("axisc.json", R"({"exclude": ["a/*.json"]})");
  CHECK(run_axisc({"lint", "a"}, there).err.empty());
}

TEST_CASE("a list of unknown kind warns, unless its comments or somebody says what it is", "[damage]") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  folder.write("d/ok.lis", "filter[0].enable 0\n");
  std::vector<std::string> const lint{"lint", "d", "--cycle-time", "1ms"};
  for (std::string const& bytes :
       {std::string("filter[0],enable=1\nfilter[0],order=99x\n<<<<<<< HEAD\n"),
        std::string("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n"),
        std::string("\xC2\xA0"
                    "filter[0].order 99\n")}) {
    INFO(bytes);
    folder.write("d/x.lis", bytes);
    auto const outcome = run_axisc(lint, there);
    CHECK(outcome.status == 0);
    CHECK_THAT(outcome.out, Contains("warning[AX7001]") && Contains("d/x.lis"));
    CHECK(run_axisc({"lint", "d", "--werror", "--cycle-time", "1ms"}, there).status == 1);
  }
  folder.write("d/x.lis", "# filter ( P-AXIS-00140\nfilter[0],order=99x\n");
  auto const judged = run_axisc(lint, there);
  CHECK(judged.status == 1);
  CHECK_THAT(judged.out, Contains("d/x.lis:2") && !Contains("AX7001"));
  folder.write("d/x.lis", "filter[0],order=99x\n");
  CHECK(run_axisc({"lint", "d", "--kind", "axis", "--cycle-time", "1ms"}, there).status == 1);
  folder.write("axisc.json", R"({"exclude": ["d/x.lis"]})");
  CHECK(run_axisc(lint, there).out == "1 file: no findings\n");
  folder.write("axisc.json", R"({"paths": [{"pattern": "d/x.lis", "kind": "axis"}]})");
  CHECK(run_axisc(lint, there).status == 1);
}

TEST_CASE("a folder of which no image is made is not a success", "[damage]") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  std::vector<std::string> const compile{"compile", "d", "--output-folder", "o", "--cycle-time", "1ms"};
  folder.write("d/x.lis", "filter[0],enable=1\n");
  auto const outcome = run_axisc(compile, there);
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains("no image was written") && Contains("images: 0 written"));
  folder.write("d/x.lis", "wz[1].laenge 1 ( P-TOOL-00003\n");
  CHECK(run_axisc(compile, there).status == 2);
  fs::remove(folder / "d/x.lis");
  folder.write("d/part.nc", "M30\n");
  CHECK(run_axisc(compile, there).status == 2);
  folder.write("d/ok.lis", "filter[0].enable 0\n");
  CHECK(run_axisc(compile, there).status == 0);
}

}  // namespace damaged_folder_test
