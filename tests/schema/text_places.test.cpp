#include "schema/text_places.hpp"

#include "support/catch.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace axisc::schema;

TEST_CASE("every text of a list is found at its place, and no other one") {
  for (std::size_t const count : {0U, 1U, 2U, 3U, 100U, 1000U}) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < count; ++i) texts.push_back("text " + std::to_string(i * i));
    std::vector<std::string_view> const views(texts.begin(), texts.end());
    auto const places = make_text_places(views);
    for (std::size_t i = 0; i < count; ++i) REQUIRE(find_text(texts[i], views, places) == i);
    for (std::size_t i = 0; i < 1000; ++i)
      REQUIRE_FALSE(find_text("other " + std::to_string(i), views, places));
    CHECK_FALSE(find_text("", views, places));
  }
}

}  // namespace
