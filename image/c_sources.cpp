#include "image/c_sources.hpp"

#include "configuration/machine/filter_command.hpp"
#include "embedded.hpp"
#include "image/stripped_image.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace axisc::image {

namespace {

/// Names of people's choice, within a comment.
std::string in_comment(std::string_view text) {
  std::string safe(text);
  std::replace_if(
      safe.begin(), safe.end(),
      [](unsigned char letter) { return letter < ' ' || letter == '*' || letter == '\\'; }, ' ');
  return safe;
}

std::string bank_text(ImageBank const& bank) {
  machine::FilterCommand command;
  command.filter_switch = machine::FilterSwitch::on;
  command.hsc = bank.hsc;
  command.parameters = bank.parameters;
  return machine::to_text(command);
}

/// The numbers that calls take, in words.
std::string numbers(ImageContents const& contents) {
  std::string text = " * Axes:\n";
  for (std::size_t i = 0; i < contents.axes.size(); ++i) {
    auto const& axis = contents.axes[i];
    text += " *   " + std::to_string(i) + "  " +
            (axis.name.empty() ? "axis" + std::to_string(i) : in_comment(axis.name)) + ", " +
            (axis.type == 1 ? "0.1 um" : "1e-4 degree");
    if (!axis.interface_filters.empty()) text += ", additional interface";
    if (axis.control) text += ", Improved Position Control";
    text += "\n";
  }
  for (std::size_t i = 0; i < contents.groups.size(); ++i) {
    auto const& group = contents.groups[i];
    text += " * Banks of group " + std::to_string(i) +
            (group.name.empty() ? "" : ", " + in_comment(group.name)) + ":\n";
    for (std::size_t bank = 0; bank < group.banks.size(); ++bank) {
      text += " *   " + std::to_string(bank) + "  " + in_comment(bank_text(group.banks[bank])) + "\n";
    }
  }
  return text;
}

std::string header(ImageContents const& contents) {
  return "/* The filters of a machine, made by axisc from its axis lists: the numbers that the calls of "
         "axisrt_c.h take.\n" +
         numbers(contents) + R"( */
#ifndef MACHINE_H
#define MACHINE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { machine_axis_count = )" +
         std::to_string(contents.axes.size()) +
         ", machine_cycle_time_ns = " + std::to_string(contents.cycle_time.nanoseconds) +
         R"( };

extern const unsigned char machine_image[];
extern const size_t machine_image_size;

#ifdef __cplusplus
}
#endif
#endif
)";
}

std::string array(std::span<std::byte const> bytes) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  constexpr std::size_t in_a_line = 18;
  std::string text =
      "#include \"machine.h\"\n\nconst size_t machine_image_size = " + std::to_string(bytes.size()) +
      ";\n\nconst unsigned char machine_image[] = {";
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    auto const value = std::to_integer<unsigned>(bytes[i]);
    text += i % in_a_line == 0 ? "\n  0x" : " 0x";
    text += digits[value >> 4U];
    text += digits[value & 0xFU];
    text += ',';
  }
  return text + "\n};\n";
}

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
  auto const whole = image.first(static_cast<std::size_t>(contents.size));
  auto const bytes =
      options.complete ? std::vector<std::byte>(whole.begin(), whole.end()) : stripped_image(whole);
  return {{.name = "axisrt_c.c", .content = std::string(embedded::axisrt_c_source())},
          {.name = "axisrt_c.h", .content = std::string(embedded::axisrt_c_header())},
          {.name = "example.c", .content = std::string(example)},
          {.name = "machine.c", .content = array(bytes)},
          {.name = "machine.h", .content = header(contents)}};
}

}  // namespace axisc::image
