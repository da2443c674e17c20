#include "axisc/files/image_file.hpp"

#include "support/catch.hpp"

#include <string>

namespace image_file_test {

using namespace axisc;
using Catch::Matchers::Contains;

TEST_CASE("an image that a newer program wrote is not called damaged") {
  for (auto const language : {Language::english, Language::german}) {
    auto const text = unusable_image("x.axim", AXISRT_UNKNOWN_KIND).sentence(language);
    CHECK_THAT(text, Contains("x.axim") && Contains("UNKNOWN_KIND"));
    CHECK_THAT(text, !Contains("damaged") && !Contains("beschädigt"));
  }
  CHECK_THAT(unusable_image("x.axim", AXISRT_UNSTABLE).sentence(Language::english), Contains("damaged"));
}

}  // namespace image_file_test
