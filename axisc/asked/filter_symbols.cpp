#include "axisc/asked/filter_symbols.hpp"

#include "configuration/machine/interface_filter.hpp"
#include "schema/catalogue.hpp"

namespace axisc::says {

constexpr Sentence moving_average{"moving average", "gleitender Mittelwert"};
constexpr Sentence gaussian{"Gaussian", "Gauß"};
constexpr Sentence windowed_sinc{"windowed sinc", "gefensterter Sinc"};
constexpr Sentence time_delay{"time delay", "Totzeit"};
constexpr Sentence novib{"NoVib", "NoVib"};
constexpr Sentence guard{"Vibration Guard", "Vibration Guard"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::string_view word_of(std::string_view parameter, int number) {
  for (auto const& symbol : schema::parameter(schema::find(parameter).parameter).symbols) {
    if (symbol.number == number) return symbol.word;
  }
  return "?";
}

}  // namespace

std::string_view type_word(design::FilterType type) {
  auto const* const kind = design::find_filter_kind(static_cast<int>(type));
  return kind == nullptr ? "?" : kind->word;
}

std::string_view prototype_word(design::Prototype prototype) {
  return word_of("filter[0].prototype", static_cast<int>(prototype));
}

presentation::Symbol kernel_symbol(design::KernelType type) {
  switch (type) {
    case design::KernelType::moving_average: return {"moving average", says::moving_average};
    case design::KernelType::gaussian: return {"Gaussian", says::gaussian};
    case design::KernelType::windowed_sinc: return {"windowed sinc", says::windowed_sinc};
    case design::KernelType::time_delay: return {"time delay", says::time_delay};
    case design::KernelType::vibration_guard: return {"Vibration Guard", says::guard};
    case design::KernelType::novib: break;
  }
  return {"NoVib", says::novib};
}

std::string_view mode_word(machine::StageMode mode) {
  return word_of("lr_param.improved_position_control.stage[0].mode", static_cast<int>(mode));
}

std::string filter_path(image::ImageFilter const& filter, bool interface) {
  if (interface && filter.index == machine::interface_filter_time) {
    return "kenngr.in_add_interface_filter_time";
  }
  return (interface ? "lr_param.add_interface.filter[" : "filter[") + std::to_string(filter.index) + "]";
}

std::vector<image::ImageValue> settings_of(image::ImageAxis const& axis, image::ImageFilter const& filter,
                                           bool interface) {
  auto const path = filter_path(filter, interface);
  std::vector<image::ImageValue> settings;
  for (auto const& value : axis.values) {
    if (value.name == path || value.name.starts_with(path + ".")) settings.push_back(value);
  }
  return settings;
}

}  // namespace axisc
