#include "axisc/answers/figures/plots.hpp"
#include "axisc/asked/filter_symbols.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/format_number.hpp"

namespace axisc::says {

constexpr Sentence too_many_drawn{
    "a picture shows at most {most} axes, not {axes}; choose one with --axis",
    "ein Bild zeigt höchstens {most} Achsen, nicht {axes}; mit --axis eine auswählen"};

}  // namespace axisc::says

namespace axisc {

void PlotSubject::require_drawable() const {
  if (axes.size() <= most_drawn_axes) return;
  throw Failure({says::too_many_drawn,
                 {{"most", std::to_string(most_drawn_axes)}, {"axes", std::to_string(axes.size())}}});
}

std::string PlotSubject::names() const {
  std::string text;
  for (auto const axis : axes) text += (text.empty() ? "" : ", ") + name(axis);
  return text;
}

std::optional<std::size_t> PlotSubject::axis_before(std::size_t axis) const {
  if (!before) return std::nullopt;
  auto const& old = before->contents();
  auto const wanted = axis_label(contents(), axis);
  for (std::size_t i = 0; i < old.axes.size(); ++i) {
    if (axis_label(old, i) == wanted) return i;
  }
  return std::nullopt;
}

std::vector<image::ChainFigures> figures_of(PlottedImage const& image, std::vector<std::size_t> const& axes) {
  if (image.steps == nullptr) return image::chain_figures(image.file.bytes.bytes(), image.contents(), axes);
  std::vector<image::ChainFigures> figures;
  figures.reserve(axes.size());
  for (auto const axis : axes) figures.push_back(image.steps->figures(axis));
  return figures;
}

std::string filter_label(image::ImageFilter const& filter, Language language) {
  auto const& wanted = filter.specification;
  std::string text = "filter[" + std::to_string(filter.index) + "] " + std::string(type_word(wanted.type));
  if (design::uses_frequency(wanted.type)) {
    text += " " + exact_number(wanted.frequency.value).in(language) + " Hz";
  }
  return text;
}

}  // namespace axisc
