#include "axisc/answers/figures/filter_words.hpp"

#include "axisc/asked/filter_symbols.hpp"
#include "schema/descriptions/description.hpp"

#include <string>
#include <string_view>

namespace axisc::says {

constexpr Sentence filter_and_next{"{first}, {next}", "{first}, {next}"};
constexpr Sentence filter_with{"{filter} {value}", "{filter} {value}"};
constexpr Sentence filter_share{"{filter} at {share}", "{filter} zu {share}"};
constexpr Sentence kernel_order{"{filter} of order {order}", "{filter} der Ordnung {order}"};
constexpr Sentence filter_starts_off{"{filter} (once switched on)", "{filter} (sobald eingeschaltet)"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

/// What the catalogue calls the value of a parameter, without the number behind it: "low-pass (1)".
Wording meaning_of(std::string_view parameter, std::string_view value) {
  auto const without_number = [](std::string_view text) {
    return std::string(text.substr(0, text.find(" (")));
  };
  for (auto const& described :
       schema::description_of(schema::parameter(schema::find(parameter).parameter)).values) {
    if (described.value != value) continue;
    return {without_number(described.meaning.english), without_number(described.meaning.german)};
  }
  return std::string(value);
}

Words with(Value filter, Value value) {
  return {says::filter_with, {{"filter", std::move(filter)}, {"value", std::move(value)}}};
}

Words with_share(Words words, double share_percent) {
  constexpr double whole = 100;
  if (share_percent == whole) return words;
  return {says::filter_share, {{"filter", words}, {"share", exact(share_percent, Unit::percent)}}};
}

Words words_of(design::FilterSpecification const& filter) {
  Wording const name = meaning_of("filter[0].type", type_word(filter.type));
  Words words = as_given(name);
  if (design::uses_frequency(filter.type)) {
    words = with(name, exact(filter.frequency.value, Unit::hertz));
  } else if (design::uses_time_constant(filter.type)) {
    constexpr double us_per_ms = 1000;
    words = with(name, exact(filter.time_constant.value / us_per_ms, Unit::millisecond));
  }
  return with_share(std::move(words), filter.share_percent);
}

Words name_of(image::ImageSlot const& slot, design::KernelType type) {
  if (slot.family != machine::KernelFamily::hsc) return kernel_symbol(type).words;
  return as_given(
      meaning_of("filter[0].type", type == design::KernelType::novib ? "HSC_SHAPER" : "HSC_MEAN"));
}

Words words_of(image::ImageSlot const& slot, design::KernelSpecification const& kernel) {
  auto const name = name_of(slot, kernel.type);
  switch (kernel.type) {
    case design::KernelType::vibration_guard:
    case design::KernelType::novib: return with(name, exact(kernel.frequency.value, Unit::hertz));
    case design::KernelType::moving_average:
    case design::KernelType::gaussian:
    case design::KernelType::windowed_sinc:
    case design::KernelType::time_delay: break;
  }
  return {says::kernel_order, {{"filter", name}, {"order", kernel.order}}};
}

}  // namespace

std::optional<Words> filter_words(image::ImageContents const& contents, std::size_t axis) {
  std::optional<Words> all;
  auto const add = [&all](Words const& next) {
    all = all ? Words(says::filter_and_next, {{"first", *all}, {"next", next}}) : next;
  };
  for (auto const& filter : contents.axes[axis].filters) add(words_of(filter.specification));
  auto const& slot = contents.axes[axis].slot;
  if (!slot || !slot->kernel) return all;
  auto const& kernel = contents.kernels[*slot->kernel].specification;
  auto words = words_of(*slot, kernel);
  if (slot->family != machine::KernelFamily::guard) {
    words = with_share(std::move(words), kernel.share_percent);
  }
  add(slot->on_at_start ? words : Words(says::filter_starts_off, {{"filter", words}}));
  return all;
}

}  // namespace axisc
