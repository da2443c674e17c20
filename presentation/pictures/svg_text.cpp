#include "presentation/pictures/svg_text.hpp"

#include "diagnostics/markup.hpp"

#include <cmath>
#include <cstdlib>

namespace axisc::pictures {

std::string pixels(double value) {
  long const hundredths = std::lround(value * 100);
  std::string text = hundredths < 0 ? "-" : "";
  text += std::to_string(std::labs(hundredths) / 100);
  long const rest = std::labs(hundredths) % 100;
  if (rest == 0) return text;
  text += rest < 10 ? ".0" : ".";
  return text + std::to_string(rest % 10 == 0 ? rest / 10 : rest);
}

std::string attribute(std::string_view name, std::string_view value) {
  std::string text = " ";
  return text.append(name).append("=\"").append(escaped(value)).append("\"");
}

std::string attribute(std::string_view name, double value) {
  return attribute(name, pixels(value));
}

}  // namespace axisc::pictures
