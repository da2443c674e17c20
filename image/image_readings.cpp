#include "image/image_readings.hpp"

namespace axisc::image {
namespace {

template <class Reading>
void take(Reading& known, Reading reading) {
  if (reading != Reading::documented) known = reading;
}

template <class Reading>
void add(std::string& text, std::string_view key, Reading reading) {
  if (reading == Reading::documented) return;
  if (!text.empty()) text += ", ";
  text.append(key).append(": ").append(word_of(reading));
}

}  // namespace

design::Readings readings_of(ImageContents const& contents, std::size_t axis) {
  design::Readings readings;
  for (ImageFilter const& filter : contents.axes[axis].filters) {
    take(readings.filters, filter.specification.reading);
    take(readings.cycle_time, filter.specification.cycle_time);
  }
  auto const& slot = contents.axes[axis].slot;
  if (slot && slot->kernel) {
    auto const& kernel = contents.kernels[*slot->kernel].specification;
    if (kernel.type == design::KernelType::vibration_guard) {
      take(readings.guard, design::guard_reading(kernel.reading));
    } else {
      take(readings.kernels, kernel.reading);
    }
    take(readings.cycle_time, kernel.cycle_time);
  }
  return readings;
}

std::string readings_text(design::Readings const& readings) {
  std::string text;
  add(text, "filters", readings.filters);
  add(text, "kernels", readings.kernels);
  add(text, "vibration_guard", readings.guard);
  add(text, "cycle_time", readings.cycle_time);
  return text.empty() ? "documented" : text;
}

}  // namespace axisc::image
