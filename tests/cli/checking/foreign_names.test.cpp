// Names that come from a file are printed so that no terminal and no CI system obeys them.
#include "axisrt.h"
#include "cli/program.hpp"
#include "codegen/image_writer.hpp"
#include "configuration/machine/machine.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace foreign_names_test {

using namespace axisc::test;
using Catch::Matchers::Contains;

namespace {

std::string const hostile =
    "X\x1b]0;pwn\x07\n::error::injected\n\xC2\x9B\xE2\x80\xAE\xE2\x80\xAC\xE2\x80\x8B";

/// An image that only a program other than axisc, or a list, can give such a name.
void write_image(TemporaryFolder const& folder, std::string const& name, std::string const& axis) {
  axisc::machine::Machine machine;
  machine.cycle_time = axisc::design::CycleTime{1'000'000};
  machine.axes.resize(1);
  machine.axes[0].name = axis;
  auto const bytes = axisc::codegen::write_image(machine, {});
  folder.write(name, {reinterpret_cast<char const*>(bytes.data()), bytes.size()});
}

bool is_harmless(std::string const& text) {
  for (std::string const character :
       {"\x1b", "\x07", "\xC2\x9B", "\xE2\x80\xAE\xE2\x80\xAC", "\xE2\x80\x8B", "\n::"}) {
    if (text.find(character) != std::string::npos) return false;
  }
  return !text.empty();
}

}  // namespace

TEST_CASE("a machine file cannot give an invisible name") {
  TemporaryFolder const folder;
  folder.write("x.lis", "Ende\n");
  for (std::string const character :
       {"\\u001b", "\\n", "\\u007f", "\\u009b", "\\u202e", "\\u200b", "\\ufeff"}) {
    for (std::string const& machine :
         {R"({"axes": [{"name": "X)" + character + R"(", "list": "x.lis"}]})",
          R"({"machine": ")" + character + R"(m", "axes": [{"name": "X", "list": "x.lis"}]})",
          R"({"axes": [{"name": "X", "list": "x.lis"}], "groups": [{"name": ")" + character +
              R"(", "axes": ["X"]}]})"}) {
      folder.write("m.json", machine);
      auto const outcome = run_axisc({"lint", "m.json"}, in_folder(folder.path()));
      INFO(machine << outcome.out);
      CHECK(outcome.status == 1);
      CHECK_THAT(outcome.out, Contains("AX4020") && Contains("invisible"));
    }
  }
  folder.write("m.json", R"({"machine": "Fräse 3", "axes": [{"name": "X ²", "list": "x.lis"}]})");
  CHECK(run_axisc({"lint", "m.json"}, in_folder(folder.path())).status == 0);
}

TEST_CASE("names of an image are printable in every command and format") {
  TemporaryFolder const folder;
  write_image(folder, "a.axim", hostile);
  write_image(folder, "b.axim", "other");
  auto const there = in_folder(folder.path());
  for (std::vector<std::string> const& arguments : std::vector<std::vector<std::string>>{
           {"inspect", "a.axim"},
           {"inspect", "a.axim", "--format", "json"},
           {"inspect", "a.axim", "--axis", "?"},
           {"inspect", "a.axim", "--as-list"},
           {"diff", "a.axim", "b.axim"},
           {"diff", "a.axim", "b.axim", "--format", "json"},
           {"diff", "a.axim", "b.axim", "--format", "markdown"},
           {"run", "a.axim", "--cycles", "2", "--record", "r.axrd"},
           {"response", "a.axim", "--frequencies", "1"},
           {"response", "a.axim", "--frequencies", "1", "--format", "json"},
           {"replay", "a.axim", "r.axrd"},
           {"replay", "a.axim", "r.axrd", "--format", "json"},
           {"inspect", hostile},
           {"lint", "@" + hostile},
       }) {
    auto const outcome = run_axisc(arguments, there);
    INFO(arguments[0] << " " << arguments.back() << "\n" << outcome.out << outcome.err);
    CHECK(is_harmless(outcome.out + outcome.err));
  }
}

TEST_CASE("names are no markup in Markdown") {
  TemporaryFolder const folder;
  write_image(folder, "a.axim", "[x](http://e.x) @mill <b> www.e.x");
  write_image(folder, "b.axim", "other");
  auto const outcome =
      run_axisc({"diff", "a.axim", "b.axim", "--format", "markdown"}, in_folder(folder.path()));
  CHECK(outcome.status == 0);
  for (std::string const markup : {"](", "://", "@mill", " <b>", "www.e"}) {
    CHECK_THAT(outcome.out, !Contains(markup));
  }
}

TEST_CASE("run reads the header that it wrote") {
  TemporaryFolder const folder;
  auto const there = in_folder(folder.path());
  for (std::string const& name : {hostile, std::string("a\"b,c"), std::string("=1+1"), std::string("-X")}) {
    write_image(folder, "a.axim", name);
    REQUIRE(run_axisc({"run", "a.axim", "--cycles", "3", "-o", "out.csv"}, there).status == 0);
    auto const again = run_axisc({"run", "a.axim", "--input", "out.csv"}, there);
    INFO(again.err);
    CHECK(again.status == 0);
    CHECK(again.out == folder.read("out.csv"));
    CHECK(again.out.find_first_of("=-") != 0);
  }
}

TEST_CASE("workflow commands hold no control characters", "[posix]") {
  TemporaryFolder const folder;
  folder.write("a\x1b\x07.lis", "kenngr.achs_typ 1\nfilter[0].order \x1b[31m\x07\nEnde\n");
  auto const outcome = run_axisc({"lint", ".", "--format", "github"}, in_folder(folder.path()));
  CHECK(outcome.status == 1);
  CHECK(is_harmless(outcome.out));
}

}  // namespace foreign_names_test
