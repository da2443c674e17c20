#include "docs/tools/image_format_doc.hpp"
#include "support/golden.hpp"

namespace image_format_document_test {

TEST_CASE("docs/image-format.md is what the table of fields gives", "[image][docs]") {
  axisc::test::check_golden("docs/image-format.md", axisc::docs::image_format_document());
}

}  // namespace image_format_document_test
