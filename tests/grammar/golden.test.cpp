// Lists beside their trees: lists/x.lis and lists/x.tree.
#include "support/golden.hpp"

#include "diagnostics/source_text.hpp"
#include "grammar/axis_list.hpp"
#include "grammar/print_tree.hpp"

#include <string>

namespace golden_test {

namespace {

void check_list(std::string const& name) {
  std::string const path = "tests/grammar/lists/" + name;
  axisc::SourceText const source(name, axisc::test::read_source_file(path + ".lis"));
  auto const list = axisc::grammar::parse_axis_list(source.bytes(), source.text_begin(),
                                                    source.encoding() == axisc::Encoding::windows_1252);
  axisc::test::check_golden(path + ".tree", axisc::test::print_tree(list, source.bytes()));
}

TEST_CASE("a list in the style of a machine maker") {
  check_list("machine");
}

TEST_CASE("a list with one mistake on each line") {
  check_list("mistakes");
}

TEST_CASE("a list in windows-1252 with CR LF") {
  check_list("windows");
}

}  // namespace

}  // namespace golden_test
