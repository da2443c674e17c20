// Prints docs/image-format.md.
#include "docs/tools/image_format_doc.hpp"

#include <cstdlib>
#include <iostream>

int main() {
  std::cout << axisc::docs::image_format_document() << std::flush;
  return std::cout ? EXIT_SUCCESS : EXIT_FAILURE;
}
