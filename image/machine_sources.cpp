#include "image/machine_sources.hpp"

#include "configuration/machine/filter_command.hpp"
#include "image/stripped_image.hpp"

#include <algorithm>
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

/// The numbers that calls take, in words.
std::string numbers(ImageContents const& contents) {
  std::string text = " * Axes:\n";
  for (std::size_t i = 0; i < contents.axes.size(); ++i) {
    auto const& axis = contents.axes[i];
    text += " *   " + std::to_string(i) + "  " + in_comment(axis_text(contents, i)) + ", " +
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

}  // namespace

std::string bank_text(ImageBank const& bank) {
  machine::FilterCommand command;
  command.filter_switch = machine::FilterSwitch::on;
  command.hsc = bank.hsc;
  command.parameters = bank.parameters;
  return machine::to_text(command);
}

std::string axis_text(ImageContents const& contents, std::size_t axis) {
  auto const& name = contents.axes[axis].name;
  return name.empty() ? "axis" + std::to_string(axis) : name;
}

std::vector<std::byte> exported_image(std::span<std::byte const> image, ImageContents const& contents,
                                      bool complete) {
  auto const whole = image.first(static_cast<std::size_t>(contents.size));
  return complete ? std::vector<std::byte>(whole.begin(), whole.end()) : stripped_image(whole);
}

std::string machine_header(ImageContents const& contents, MachineHeader const& more) {
  return "/* The filters of a machine, made by axisc from its axis lists: the numbers that the calls of "
         "axisrt_c.h take.\n" +
         numbers(contents) + R"( */
#ifndef MACHINE_H
#define MACHINE_H

#include <stddef.h>
)" + more.definitions +
         R"(
#ifdef __cplusplus
extern "C" {
#endif

enum { machine_axis_count = )" +
         std::to_string(contents.axes.size()) +
         ", machine_cycle_time_ns = " + std::to_string(contents.cycle_time.nanoseconds) + more.numbers +
         R"( };

extern const unsigned char machine_image[];
extern const size_t machine_image_size;

#ifdef __cplusplus
}
#endif
#endif
)";
}

std::string machine_source(std::span<std::byte const> bytes) {
  constexpr std::size_t in_a_line = 16;  // records begin at whole lines, and the text packs well
  std::string text =
      "#include \"machine.h\"\n\nconst size_t machine_image_size = " + std::to_string(bytes.size()) +
      ";\n\nconst unsigned char machine_image[] = {";
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i % in_a_line == 0) text += '\n';
    text += std::to_string(std::to_integer<unsigned>(bytes[i])) + ',';
  }
  return text + "\n};\n";
}

}  // namespace axisc::image
