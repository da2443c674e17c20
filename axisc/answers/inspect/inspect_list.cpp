#include "axisc/answers/inspect/inspect_answer.hpp"
#include "axisc/files/image_file.hpp"
#include "diagnostics/message.hpp"
#include "diagnostics/terminal.hpp"
#include "presentation/text_table.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence heading{"axis {axis} as compiled into {file}; after each value: where it came from",
                           "Achse {axis}, wie in {file} kompiliert; nach jedem Wert: seine Herkunft"};
constexpr Sentence without_lists{
    "{file} was compiled with --strip: it does not contain its lists",
    "{file} wurde mit --strip kompiliert: das Abbild enthält seine Listen nicht"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr std::size_t widest_column = 60;

void pad(std::string& line, std::size_t column) {
  auto const now = presentation::display_width(line);
  line.append(now < column ? column - now : 1, ' ');
}

}  // namespace

std::string inspect_as_list(InspectQuestion const& question, image::ImageContents const& image,
                            Language language) {
  if (image.lists.empty()) {
    throw Failure({says::without_lists, {{"file", question.image}}});
  }
  std::string text;
  for (auto const index : chosen_axes(image, question.axis)) {
    auto const& axis = image.axes[index];
    std::size_t names = 0;
    std::size_t values = 0;
    for (auto const& value : axis.values) {
      names = std::max(names, std::min(presentation::display_width(printable(value.name)), widest_column));
      values = std::max(values, std::min(presentation::display_width(printable(value.value)), widest_column));
    }
    if (!text.empty()) text += "\n";
    text +=
        "# " +
        render({says::heading, {{"axis", axis_label(image, index)}, {"file", question.image}}}, language) +
        "\n";
    for (auto const& value : axis.values) {
      std::string line = printable(value.name);
      pad(line, names + 2);
      line += printable(value.value);
      pad(line, names + 2 + values + 2);
      text += line + "(" + printable(value.list) + ":" + std::to_string(value.line) + ")\n";
    }
    text += "Ende\n";
  }
  return text;
}

}  // namespace axisc
