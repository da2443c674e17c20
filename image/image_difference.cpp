#include "image/image_difference.hpp"

#include "schema/catalogue.hpp"
#include "schema/value.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

namespace axisc::image {
namespace {

/// The value that counts for each name: the last one that the lists set.
std::map<std::string, ImageValue const*> effective(ImageAxis const& axis) {
  std::map<std::string, ImageValue const*> values;
  for (ImageValue const& value : axis.values) values[value.name] = &value;
  return values;
}

std::optional<double> number_of(schema::Parameter const& parameter, std::string const& text) {
  if (auto const* const symbol = schema::read_symbol(parameter, text).symbol) {
    return symbol->number ? std::optional<double>(*symbol->number) : std::nullopt;
  }
  auto const reading = schema::read_real(text);
  if (reading.status != schema::NumberStatus::good) return std::nullopt;
  return reading.number;
}

bool equal_in_meaning(std::string const& name, std::string const& a, std::string const& b) {
  if (a == b) return true;
  auto const found = schema::find(name);
  if (found.status != schema::NameLookup::Status::found) return false;
  auto const& parameter = schema::parameter(found.parameter);
  // Not every symbol has a number, and letter case does not matter.
  auto const* const symbol = schema::read_symbol(parameter, a).symbol;
  if (symbol != nullptr && symbol == schema::read_symbol(parameter, b).symbol) return true;
  auto const number_a = number_of(parameter, a);
  auto const number_b = number_of(parameter, b);
  return number_a && number_b && *number_a == *number_b;
}

std::optional<std::string> default_text(std::string const& name) {
  auto const found = schema::find(name);
  if (found.status != schema::NameLookup::Status::found) return std::nullopt;
  auto const& parameter = schema::parameter(found.parameter);
  return parameter.has_default ? std::optional(std::string(parameter.default_text)) : std::nullopt;
}

std::string place(ImageValue const& value) {
  return value.list + ":" + std::to_string(value.line);
}

std::vector<ParameterChange> compare_values(ImageAxis const& before, ImageAxis const& after) {
  auto const old_values = effective(before);
  auto const new_values = effective(after);
  std::vector<ParameterChange> changes;
  auto const add = [&](std::string const& name, ImageValue const* was, ImageValue const* is) {
    auto const otherwise = default_text(name);
    std::optional<std::string> const was_text = was != nullptr ? std::optional(was->value) : otherwise;
    std::optional<std::string> const is_text = is != nullptr ? std::optional(is->value) : otherwise;
    if (was_text && is_text && equal_in_meaning(name, *was_text, *is_text)) return;
    changes.push_back({.name = name,
                       .before = was != nullptr ? std::optional(was->value) : std::nullopt,
                       .after = is != nullptr ? std::optional(is->value) : std::nullopt,
                       .default_text = otherwise,
                       .place_before = was != nullptr ? place(*was) : std::string(),
                       .place_after = is != nullptr ? place(*is) : std::string()});
  };
  for (auto const& [name, value] : new_values) {
    auto const was = old_values.find(name);
    add(name, was == old_values.end() ? nullptr : was->second, value);
  }
  for (auto const& [name, value] : old_values) {
    if (new_values.find(name) == new_values.end()) add(name, value, nullptr);
  }
  std::sort(changes.begin(), changes.end(),
            [](ParameterChange const& a, ParameterChange const& b) { return a.name < b.name; });
  return changes;
}

ImageKernel const* listed_kernel(ImageContents const& contents, ImageAxis const& axis) {
  return axis.slot && axis.slot->kernel ? &contents.kernels[*axis.slot->kernel] : nullptr;
}

bool same_kernel(ImageContents const& before, ImageAxis const& a, ImageContents const& after,
                 ImageAxis const& b) {
  if (a.slot.has_value() != b.slot.has_value()) return false;
  if (a.slot && (a.slot->on_at_start != b.slot->on_at_start || a.slot->family != b.slot->family)) {
    return false;
  }
  ImageKernel const* const was = listed_kernel(before, a);
  ImageKernel const* const is = listed_kernel(after, b);
  if (was == nullptr || is == nullptr) return was == is;
  return was->design.tail_sums == is->design.tail_sums;
}

bool same_filtering(ImageContents const& before, ImageAxis const& a, ImageContents const& after,
                    ImageAxis const& b) {
  bool const same_filters = std::equal(
      a.filters.begin(), a.filters.end(), b.filters.begin(), b.filters.end(),
      [](ImageFilter const& was, ImageFilter const& is) { return was.specification == is.specification; });
  return same_filters && before.cycle_time == after.cycle_time && same_kernel(before, a, after, b);
}

std::vector<GainChange> compare_gains(ImageContents const& before, std::size_t old_axis,
                                      ImageContents const& after, std::size_t new_axis) {
  auto frequencies = characteristic_frequencies(before, old_axis);
  auto const more = characteristic_frequencies(after, new_axis);
  frequencies.insert(frequencies.end(), more.begin(), more.end());
  sort_frequencies(frequencies);
  double const highest = std::min(before.cycle_time.nyquist().value, after.cycle_time.nyquist().value);
  std::vector<GainChange> gains;
  for (design::Hertz const frequency : frequencies) {
    if (frequency.value > highest) continue;
    gains.push_back({.frequency = frequency,
                     .before = chain_magnitude(before, old_axis, frequency),
                     .after = chain_magnitude(after, new_axis, frequency)});
  }
  return gains;
}

std::string label(ImageContents const& contents, std::size_t axis) {
  auto const& name = contents.axes[axis].name;
  return name.empty() ? "axis" + std::to_string(axis) : name;
}

/// The axes of an image by name; the first one of equal names.
class AxesByName {
 public:
  explicit AxesByName(ImageContents const& contents) : count_(contents.axes.size()) {
    for (std::size_t axis = 0; axis < count_; ++axis) axes_.try_emplace(label(contents, axis), axis);
  }

  /// A list alone may name its axis by its file: where both sides have one axis, they are compared.
  [[nodiscard]] std::optional<std::size_t> find(ImageContents const& other, std::string const& name) const {
    if (count_ == 1 && other.axes.size() == 1) return 0;
    auto const found = axes_.find(name);
    return found == axes_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::size_t count_;
  std::unordered_map<std::string, std::size_t> axes_;
};

}  // namespace

ImageDifference compare_images(ImageSide const& before, ImageSide const& after) {
  ImageDifference difference{.cycle_time_before = before.contents.cycle_time,
                             .cycle_time_after = after.contents.cycle_time,
                             .axes_removed = {},
                             .axes_added = {},
                             .axes = {}};
  AxesByName const old_axes(before.contents);
  AxesByName const new_axes(after.contents);
  for (std::size_t axis = 0; axis < before.contents.axes.size(); ++axis) {
    auto const name = label(before.contents, axis);
    if (!new_axes.find(before.contents, name)) difference.axes_removed.push_back(name);
  }
  for (std::size_t axis = 0; axis < after.contents.axes.size(); ++axis) {
    auto const name = label(after.contents, axis);
    auto const old_axis = old_axes.find(after.contents, name);
    if (!old_axis) {
      difference.axes_added.push_back(name);
      continue;
    }
    auto const& was = before.contents.axes[*old_axis];
    auto const& is = after.contents.axes[axis];
    AxisChange change{.name = name,
                      .parameters = compare_values(was, is),
                      .filtering_changed = !same_filtering(before.contents, was, after.contents, is),
                      .before = {},
                      .after = {},
                      .gains = {}};
    if (change.filtering_changed) {
      change.before = chain_figures(before.image, before.contents, *old_axis);
      change.after = chain_figures(after.image, after.contents, axis);
      change.gains = compare_gains(before.contents, *old_axis, after.contents, axis);
    }
    if (change.filtering_changed || !change.parameters.empty()) difference.axes.push_back(std::move(change));
  }
  return difference;
}

}  // namespace axisc::image
