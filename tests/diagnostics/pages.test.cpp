#include "diagnostics/pages.hpp"

#include "diagnostics/page_table.hpp"
#include "diagnostics/utf8.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

using namespace axisc;

namespace {

std::set<std::string> files_of(std::string const& language) {
  std::set<std::string> names;
  std::filesystem::path const folder =
      std::filesystem::path(AXISC_SOURCE_DIR) / "diagnostics/text/pages" / language;
  if (!std::filesystem::exists(folder)) return names;
  for (auto const& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

std::string without_heading(std::string text) {
  if (text.rfind("# ", 0) == 0)
    text.erase(0, std::min(text.find_first_not_of('\n', text.find('\n')), text.size()));
  return text;
}

}  // namespace

TEST_CASE("a code without page has an empty one") {
  CHECK(page(Code{0}, Language::english).empty());
  CHECK(page(Code{65535}, Language::german).empty());
}

TEST_CASE("every page stands in both languages") {
  CHECK(files_of("en") == files_of("de"));
}

TEST_CASE("every page file is embedded as it stands, without its heading") {
  std::set<std::string> embedded;
  for (PageTexts const& row : page_table()) {
    std::string const name = code_text(row.code) + ".md";
    INFO(name);
    embedded.insert(name);
    CHECK(page(row.code, Language::english) ==
          without_heading(test::read_source_file("diagnostics/text/pages/en/" + name)));
    CHECK(page(row.code, Language::german) ==
          without_heading(test::read_source_file("diagnostics/text/pages/de/" + name)));
    CHECK_FALSE(row.english.empty());
    CHECK_FALSE(row.german.empty());
    CHECK(valid_utf8_prefix(row.english) == row.english.size());
    CHECK(valid_utf8_prefix(row.german) == row.german.size());
  }
  CHECK(embedded == files_of("en"));
  auto const table = page_table();
  CHECK(std::is_sorted(table.begin(), table.end(),
                       [](PageTexts const& left, PageTexts const& right) { return left.code < right.code; }));
}
