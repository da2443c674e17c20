#include "image/fmu/model.hpp"

#include "codegen/source_digest.hpp"
#include "image/fmu/names.hpp"
#include "image/machine_sources.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

namespace axisc::image {

namespace {

constexpr std::string_view axis_status = "AxisStatus";
constexpr std::string_view command_status = "CommandStatus";

constexpr std::array units = {
    FmuUnit{"0.1 um", "1", nullptr, nullptr, "1e-07", "mm", "0.0001"},
    FmuUnit{"1e-4 deg", nullptr, "1", nullptr, "1.7453292519943296e-06", "deg", "0.0001"},
    FmuUnit{"um/s", "1", nullptr, "-1", "1e-06", "mm/s", "0.001"},
    FmuUnit{"1e-3 deg/s", nullptr, "1", "-1", "1.7453292519943296e-05", "deg/s", "0.001"},
};

enum class Quantity : std::uint8_t { none, position, velocity };
enum class Needs : std::uint8_t { nothing, interface, control };

/// In the order of the value references.
struct Kind {
  std::string_view name;
  FmuCausality causality;
  FmuType type;
  Quantity quantity;
  Needs needs;
  std::string_view description;
};
constexpr auto in = FmuCausality::input;
constexpr auto out = FmuCausality::output;
constexpr std::array kinds = {
    Kind{"setpoint", in, FmuType::real, Quantity::position, Needs::nothing,
         "position setpoint of the interpolator"},
    Kind{"filtered", out, FmuType::real, Quantity::position, Needs::nothing, "filtered position setpoint"},
    Kind{"settled", out, FmuType::boolean, Quantity::none, Needs::nothing,
         "filtered setpoint within the window of P-AXIS-00351"},
    Kind{"status", out, FmuType::enumeration, Quantity::none, Needs::nothing,
         "what happened in the latest cycle"},
    Kind{"reset", in, FmuType::boolean, Quantity::none, Needs::nothing,
         "rising edge: steady state at the inputs of the axis"},
    Kind{"interface", in, FmuType::real, Quantity::position, Needs::interface,
         "value of the additional interface"},
    Kind{"interface_filtered", out, FmuType::real, Quantity::position, Needs::interface,
         "filtered value of the additional interface"},
    Kind{"v_set", in, FmuType::real, Quantity::velocity, Needs::control, "velocity setpoint"},
    Kind{"v_motor", in, FmuType::real, Quantity::velocity, Needs::control, "velocity of the motor's encoder"},
    Kind{"v_direct", in, FmuType::real, Quantity::velocity, Needs::control,
         "velocity of the direct encoder; that of the motor where there is none"},
    Kind{"v_add", out, FmuType::real, Quantity::velocity, Needs::control,
         "additive velocity of Improved Position Control"},
    Kind{"increments", out, FmuType::real, Quantity::none, Needs::control,
         "v_add in increments of the drive"},
};

bool has(ImageAxis const& axis, Needs needs) {
  if (needs == Needs::interface) return !axis.interface_filters.empty();
  return needs == Needs::nothing || axis.control.has_value();
}

std::string_view unit_of(ImageAxis const& axis, Quantity quantity) {
  bool const is_length = axis.type == 1;
  if (quantity == Quantity::position) return units[is_length ? 0 : 1].name;
  if (quantity == Quantity::velocity) return units[is_length ? 2 : 3].name;
  return {};
}

void add_axis(FmuModel& model, ImageContents const& contents, std::size_t i) {
  auto const name = axis_text(contents, i);
  model.is_structured = model.is_structured && is_ascii(name);
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    Kind const& kind = kinds[k];
    if (!has(contents.axes[i], kind.needs)) continue;
    model.variables.push_back(
        {.name = quoted_name(name) + "." + std::string(kind.name),
         .reference = static_cast<std::uint32_t>(16 * (i + 1) + k),
         .causality = kind.causality,
         .type = kind.type,
         .unit = unit_of(contents.axes[i], kind.quantity),
         .enumeration = std::string(kind.type == FmuType::enumeration ? axis_status : std::string_view()),
         .description = std::string(kind.description)});
  }
}

void add_channel(FmuModel& model, ImageContents const& contents, std::size_t i) {
  auto const& group = contents.groups[i];
  auto const number = std::to_string(i + 1);
  auto const name = group.name.empty() ? "CH" + number : group.name;
  model.is_structured = model.is_structured && is_ascii(name);
  auto const first = static_cast<std::uint32_t>(16 * (contents.axes.size() + 1) + 2 * i);
  model.enumerations.push_back(filter_settings("Filter" + number, group));
  model.variables.push_back({.name = quoted_name(name) + ".filter",
                             .reference = first,
                             .causality = in,
                             .type = FmuType::enumeration,
                             .enumeration = "Filter" + number,
                             .description = "a change is a #FILTER or #VIB GUARD command"});
  model.variables.push_back(
      {.name = quoted_name(name) + ".filter_status",
       .reference = first + 1,
       .causality = out,
       .type = FmuType::enumeration,
       .enumeration = std::string(command_status),
       .description = "what became of the latest command; one that waits is tried again"});
}

std::string token_of(std::span<std::byte const> image) {
  auto const digest = codegen::sha256({reinterpret_cast<char const*>(image.data()), image.size()});
  return codegen::hexadecimal(std::span(digest).first(16));
}

std::string seconds(design::CycleTime period) {
  std::array<char, 32> text{};
  auto const end = std::to_chars(text.data(), text.data() + text.size(),
                                 static_cast<double>(period.nanoseconds) / 1e9, std::chars_format::fixed);
  return {text.data(), end.ptr};
}

}  // namespace

FmuEnumeration filter_settings(std::string name, ImageGroup const& group) {
  FmuEnumeration settings{.name = std::move(name), .items = {}};
  auto const add = [&settings](std::string text) {
    settings.items.emplace_back(std::move(text), static_cast<std::uint32_t>(settings.items.size()));
  };
  add("as at start");
  add("OFF");
  if (std::any_of(group.banks.begin(), group.banks.end(),
                  [](ImageBank const& bank) { return bank.parameters.guard; })) {
    add("VIB GUARD OFF");
  }
  constexpr std::string_view command = "#FILTER ";
  for (auto const& bank : group.banks) {
    auto const text = bank_text(bank);
    add(text.substr(text.starts_with(command) ? command.size() : 1));
  }
  return settings;
}

std::variant<FmuModel, EqualNames> fmu_model(std::span<std::byte const> image, ImageContents const& contents,
                                             FmuOptions const& options) {
  FmuModel model{.identifier = identifier(options.name),
                 .token = token_of(image),
                 .period = seconds(contents.cycle_time),
                 .description = "filters of a machine's axis lists, one step per NC cycle; made by " +
                                std::string(options.tool),
                 .variables = {},
                 .units = {},
                 .enumerations = {}};
  model.enumerations.push_back(
      {.name = std::string(axis_status),
       .items = {{"OK", 0}, {"BAD_INPUT", 40}, {"NOT_RESET", 41}, {"IMPLAUSIBLE", 43}}});
  if (!contents.groups.empty()) {
    model.enumerations.push_back(
        {.name = std::string(command_status), .items = {{"OK", 0}, {"BUSY", 50}, {"NEEDS_STANDSTILL", 52}}});
  }
  for (std::size_t i = 0; i < contents.axes.size(); ++i) add_axis(model, contents, i);
  for (std::size_t i = 0; i < contents.groups.size(); ++i) add_channel(model, contents, i);
  std::set<std::string_view> names, used_units;
  for (auto const& variable : model.variables) {
    if (!names.insert(variable.name).second) {
      return EqualNames{variable.name.substr(0, variable.name.rfind('.'))};
    }
    used_units.insert(variable.unit);
  }
  std::copy_if(units.begin(), units.end(), std::back_inserter(model.units),
               [&used_units](FmuUnit const& unit) { return used_units.contains(unit.name); });
  return model;
}

}  // namespace axisc::image
