#include "cli/options/filter_symbols.hpp"
#include "cli/plots/plots.hpp"
#include "diagnostics/format_number.hpp"

namespace axisc::cli {

std::string PlotSubject::names() const {
  std::string text;
  for (auto const axis : axes) text += (text.empty() ? "" : ", ") + name(axis);
  return text;
}

std::optional<std::size_t> PlotSubject::axis_before(std::size_t axis) const {
  if (!before) return std::nullopt;
  auto const& old = before->contents();
  for (std::size_t i = 0; i < old.axes.size(); ++i) {
    if (axis_label(old, i) == name(axis)) return i;
  }
  return std::nullopt;
}

std::string filter_label(image::ImageFilter const& filter) {
  auto const& wanted = filter.specification;
  std::string text = "filter[" + std::to_string(filter.index) + "] " + std::string(type_word(wanted.type));
  if (design::uses_frequency(wanted.type)) text += " " + format_exact(wanted.frequency.value) + " Hz";
  return text;
}

}  // namespace axisc::cli
