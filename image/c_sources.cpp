#include "image/c_sources.hpp"

#include "embedded.hpp"
#include "image/machine_sources.hpp"

#include <string_view>

namespace axisc::image {

namespace {

constexpr std::string_view example =
    R"(/* A step of 1 mm (or 1 degree) on all axes: cc -std=c99 example.c machine.c axisrt_c.c && ./a.out */
#include "axisrt_c.h"
#include "machine.h"

#include <stdio.h>
#include <stdlib.h>

int main(void) {
  double position[machine_axis_count];
  size_t size = 0;
  axisrt_c* filters = NULL;
  if (axisrt_c_memory_size(machine_image, machine_image_size, &size) != AXISRT_C_OK) return 1;
  if (axisrt_c_create(machine_image, machine_image_size, malloc(size), size, &filters) != AXISRT_C_OK) return 1;
  for (uint32_t axis = 0; axis < machine_axis_count; ++axis) axisrt_c_reset(filters, axis, 0);
  for (int cycle = 0; cycle < 100; ++cycle) {
    for (int axis = 0; axis < machine_axis_count; ++axis) position[axis] = 10000;
    axisrt_c_step(filters, position, position, NULL);
    for (int axis = 0; axis < machine_axis_count; ++axis) printf("%.17g ", position[axis]);
    printf("\n");
  }
  return 0;
}
)";

}  // namespace

std::vector<ExportedFile> c_sources(std::span<std::byte const> image, ImageContents const& contents,
                                    CSourcesOptions const& options) {
  auto const bytes = exported_image(image, contents, options.complete);
  return {{.name = "axisrt_c.c", .content = std::string(embedded::axisrt_c_source())},
          {.name = "axisrt_c.h", .content = std::string(embedded::axisrt_c_header())},
          {.name = "example.c", .content = std::string(example)},
          {.name = "machine.c", .content = machine_source(bytes)},
          {.name = "machine.h", .content = machine_header(contents)}};
}

}  // namespace axisc::image
