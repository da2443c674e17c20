#include "image/chain_difference.hpp"

#include "image/image_readings.hpp"

#include <algorithm>

namespace axisc::image {
namespace {

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

}  // namespace

bool filter_alike(ImageContents const& before, std::size_t a, ImageContents const& after, std::size_t b) {
  auto const& was = before.axes[a];
  auto const& is = after.axes[b];
  bool const same_filters =
      std::equal(was.filters.begin(), was.filters.end(), is.filters.begin(), is.filters.end(),
                 [](ImageFilter const& one, ImageFilter const& other) {
                   return one.specification == other.specification;
                 });
  return same_filters && before.cycle_time == after.cycle_time && same_kernel(before, was, after, is);
}

std::vector<std::optional<ChainDifference>> compare_chains(ImageSide const& before, ImageSide const& after,
                                                           std::span<AxesToCompare const> pairs) {
  std::vector<std::optional<ChainDifference>> differences(pairs.size());
  std::vector<std::size_t> differing;
  std::vector<std::size_t> old_axes;
  std::vector<std::size_t> new_axes;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (filter_alike(before.contents, pairs[i].before, after.contents, pairs[i].after)) continue;
    differing.push_back(i);
    old_axes.push_back(pairs[i].before);
    new_axes.push_back(pairs[i].after);
  }
  if (differing.empty()) return differences;
  auto const old_figures = chain_figures(before.image, before.contents, old_axes);
  auto const new_figures = chain_figures(after.image, after.contents, new_axes);
  for (std::size_t i = 0; i < differing.size(); ++i) {
    differences[differing[i]] =
        ChainDifference{.before = old_figures[i],
                        .after = new_figures[i],
                        .gains = compare_gains(before.contents, old_axes[i], after.contents, new_axes[i]),
                        .reading_before = readings_of(before.contents, old_axes[i]),
                        .reading_after = readings_of(after.contents, new_axes[i]),
                        .bounds_before = proved_bounds(before.image, static_cast<std::uint32_t>(old_axes[i])),
                        .bounds_after = proved_bounds(after.image, static_cast<std::uint32_t>(new_axes[i]))};
  }
  return differences;
}

}  // namespace axisc::image
