#include "analysis/tuning/suggestion/list_lines.hpp"

#include "design/filter_kinds.hpp"
#include "design/kernels/kernel_kinds.hpp"
#include "diagnostics/format_number.hpp"

#include <array>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace axisc::tuning::says {

constexpr Sentence moving_average{"moving average", "gleitender Mittelwert"};
constexpr Sentence gaussian{"Gaussian", "Gauß"};
constexpr Sentence windowed_sinc{"windowed sinc", "gefensterter Sinc"};
constexpr Sentence time_delay{"time delay", "Zeitverzögerung"};
constexpr Sentence novib{"NoVib", "NoVib"};
constexpr Sentence guard{"Vibration Guard", "Vibration Guard"};
constexpr Sentence mode{"{guard} mode {mode}, {frequency} Hz, damping {damping}",
                        "{guard} Modus {mode}, {frequency} Hz, Dämpfung {damping}"};
constexpr Sentence order{"{filter} order {order}", "{filter} Ordnung {order}"};
constexpr Sentence quality{"quality {quality}", "Qualität {quality}"};

}  // namespace axisc::tuning::says

namespace axisc::tuning {
namespace {

using design::KernelType;

/// By number of P-AXIS-00153.
constexpr std::array<std::string_view, 4> prototype_words = {"", "CRIT_DAMPING", "BUTTERWORTH", "BESSEL"};
void add_fir(std::vector<ListLine>& lines, design::KernelSpecification const& kernel) {
  auto const& kind = design::kind_of(kernel.type);
  auto const add = [&](std::string_view name, std::string value) {
    lines.push_back({.name = "filter_fir." + std::string(name), .value = std::move(value)});
  };
  add("enable", "1");
  add("type", std::to_string(static_cast<int>(kernel.type) + 1));
  add("order", std::to_string(kernel.order));
  if (kind.uses_frequency) add("fcut", format_exact(kernel.frequency.value));
  if (kind.uses_quality) add("quality", format_exact(kernel.quality));
  add("share", format_exact(kernel.share_percent));
}

void add_guard(std::vector<ListLine>& lines, design::KernelSpecification const& guard) {
  auto const add = [&](std::string_view name, std::string value) {
    lines.push_back({.name = "vib_guard." + std::string(name), .value = std::move(value)});
  };
  add("active", "1");
  add("mode", std::to_string(guard.order));
  add("freq", format_exact(guard.frequency.value));
  add("damping", format_exact(guard.quality));
}

void add_hsc(std::vector<ListLine>& lines, design::KernelSpecification const& kernel) {
  bool const is_novib = kernel.type == KernelType::novib;
  auto const add = [&](std::string_view name, std::string value) {
    lines.push_back({.name = "filter[0]." + std::string(name), .value = std::move(value)});
  };
  add("prototype", "HSC");
  add("type", is_novib ? "HSC_SHAPER" : "HSC_MEAN");
  add("order", std::to_string(kernel.order));
  if (is_novib) add("fg_f0", format_exact(kernel.frequency.value));
  add("share_percent", format_exact(kernel.share_percent));
}

}  // namespace

std::vector<ListLine> list_lines(Chain const& chain, machine::KernelFamily family) {
  family = family_of(chain, family);
  bool const is_hsc = chain.kernel && family == machine::KernelFamily::hsc;
  std::vector<ListLine> lines;
  if (is_hsc) add_hsc(lines, *chain.kernel);
  std::size_t index = is_hsc ? 1 : 0;
  for (auto const& filter : chain.filters) {
    auto const prefix = "filter[" + std::to_string(index) + "].";
    auto const add = [&](std::string_view name, std::string value) {
      lines.push_back({.name = prefix + std::string(name), .value = std::move(value)});
    };
    add("enable", "1");
    add("type", std::string(design::kind_of(filter.type).word));
    add("prototype", std::string(prototype_words[static_cast<std::size_t>(filter.prototype)]));
    add("order", std::to_string(filter.order));
    add("fg_f0", format_exact(filter.frequency.value));
    if (design::uses_quality(filter.type)) add("guete", format_exact(filter.quality));
    add("share_percent", format_exact(filter.share_percent));
    ++index;
  }
  if (has_guard(chain)) {
    add_guard(lines, *chain.kernel);
  } else if (chain.kernel && !is_hsc) {
    add_fir(lines, *chain.kernel);
  }
  return lines;
}

std::optional<std::string> filter_command(Chain const& chain, machine::KernelFamily family,
                                          double tolerance) {
  if (!chain.kernel) return std::nullopt;
  if (family_of(chain, family) == machine::KernelFamily::hsc) return "#FILTER ON [HSC]";
  return (has_guard(chain) ? "#VIB GUARD" : "#FILTER") + (" ON [AX_DEV=" + format_exact(tolerance) + "]");
}

std::string short_name(Chain const& chain, Language language) {
  static constexpr std::array<SentenceRef, design::kernel_kinds.size()> kernel_names = {
      says::moving_average, says::gaussian, says::windowed_sinc, says::time_delay, says::novib, says::guard};
  auto const say = [language](SentenceRef sentence, std::vector<Argument> arguments = {}) {
    return render({sentence, std::move(arguments)}, language);
  };
  std::string text;
  auto const append = [&](std::string part, std::optional<std::uint32_t> order,
                          std::initializer_list<std::pair<bool, Wording>> details) {
    if (order) part = say(says::order, {{"filter", part}, {"order", std::to_string(*order)}});
    for (auto const& [applies, detail] : details) {
      if (applies) part += ", " + detail.in(language);
    }
    text += (text.empty() ? "" : " + ") + part;
  };
  auto const order_unless = [](bool computed, std::uint32_t order) {
    return computed ? std::nullopt : std::optional(order);
  };
  auto const quality = [&](double value) { return say(says::quality, {{"quality", exact_number(value)}}); };
  for (auto const& filter : chain.filters) {
    append(std::string(design::kind_of(filter.type).word),
           order_unless(design::computes_order(filter.type), filter.order),
           {{design::uses_frequency(filter.type), exact_number(filter.frequency.value) + " Hz"},
            {design::uses_time_constant(filter.type), exact_number(filter.time_constant.value) + " µs"},
            {design::uses_quality(filter.type), quality(filter.quality)}});
  }
  if (chain.kernel && chain.kernel->type == KernelType::vibration_guard) {
    auto const& guard = *chain.kernel;
    append(say(says::mode, {{"guard", say(says::guard)},
                            {"mode", std::to_string(guard.order)},
                            {"frequency", exact_number(guard.frequency.value)},
                            {"damping", exact_number(guard.quality)}}),
           std::nullopt, {});
  } else if (chain.kernel) {
    auto const& kernel = *chain.kernel;
    auto const& kind = design::kind_of(kernel.type);
    append(say(kernel_names[static_cast<std::size_t>(kernel.type)]),
           order_unless(kind.computes_order, kernel.order),
           {{kind.uses_frequency, exact_number(kernel.frequency.value) + " Hz"},
            {kind.uses_quality && kernel.quality != 1, quality(kernel.quality)}});
  }
  return text.empty() ? "-" : text;
}

}  // namespace axisc::tuning
