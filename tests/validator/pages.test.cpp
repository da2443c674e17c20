// The pages of the rules, as the program embeds them.
#include "diagnostics/utf8.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "validator/engine/rule.hpp"
#include "validator/engine/rule_title.hpp"

#include <algorithm>
#include <set>
#include <string>

using namespace axisc;

namespace {

std::string without_heading(std::string text) {
  if (text.rfind("# ", 0) == 0)
    text.erase(0, std::min(text.find_first_not_of('\n', text.find('\n')), text.size()));
  return text;
}

}  // namespace

TEST_CASE("a code without a rule has no page") {
  CHECK(Page{}.in(Language::english).empty());
  CHECK(validator::find_rule(Code{0}) == nullptr);
}

TEST_CASE("a page is said in the wanted language") {
  Page const page{.english = "one", .german = "eins"};
  CHECK(page.in(Language::english) == "one");
  CHECK(page.in(Language::german) == "eins");
}

TEST_CASE("every page file is embedded as it is, without its heading") {
  for (validator::Rule const& rule : validator::rules()) {
    std::string const folder = "validator/rules/" + code_text(rule.code) + "-" + std::string(rule.name) + "/";
    INFO(folder);
    Page const& page = validator::page(rule);
    CHECK(page.english == without_heading(test::read_source_file(folder + "en.md")));
    CHECK(page.german == without_heading(test::read_source_file(folder + "de.md")));
    CHECK(valid_utf8_prefix(page.english) == page.english.size());
    CHECK(valid_utf8_prefix(page.german) == page.german.size());
  }
}

TEST_CASE("every rule has a title of its own in both languages: the heading of its pages") {
  std::set<std::string_view> english;
  std::set<std::string_view> german;
  for (validator::Rule const& rule : validator::rules()) {
    std::string const folder = "validator/rules/" + code_text(rule.code) + "-" + std::string(rule.name) + "/";
    INFO(folder);
    Page const& title = validator::title(rule);
    auto const begins = [&](std::string const& file, std::string_view heading) {
      return test::read_source_file(folder + file).starts_with("# " + std::string(heading) + "\n\n");
    };
    CHECK(begins("en.md", title.english));
    CHECK(begins("de.md", title.german));
    CHECK(english.insert(title.english).second);
    CHECK(german.insert(title.german).second);
  }
}
