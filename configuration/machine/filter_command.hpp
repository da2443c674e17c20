// A #FILTER or #VIB GUARD command, checked and independent of its spelling.
#pragma once

#include "design/kernels/kernel_design.hpp"
#include "design/units.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::machine {

/// Which filters of an axis a command reaches. The numbers are those of images.
enum class KernelFamily : std::uint8_t { hsc = 1, fir = 2, guard = 3 };

/// The keywords of #FILTER, or of #VIB GUARD, that decide which kernel an axis gets. Absent ones keep the
/// axis list's value.
/// Canonical: ORDER_TIME has become the order it means at the NC cycle time (0 below one cycle), and is
/// dropped where ORDER is given; AX_DEV and ACC_FACT, which do not touch the kernel, are in FilterCommand.
struct FilterParameters {
  std::optional<std::uint32_t> order;      ///< 0..200; 0 switches the filter off. MODE, 1..4
  std::optional<double> share_percent;     ///< 0..100; #FILTER only
  std::optional<design::Hertz> frequency;  ///< FCUT, FREQ
  std::optional<double> quality;           ///< 0 < q <= 1; DAMPING, 0 <= D < 1
  bool guard = false;                      ///< of #VIB GUARD

  /// Nothing but the lists' values.
  [[nodiscard]] bool empty() const { return !order && !share_percent && !frequency && !quality; }
  friend bool operator==(FilterParameters const&, FilterParameters const&) = default;
};

/// #VIB GUARD without parameters.
[[nodiscard]] inline FilterParameters guard_parameters() {
  FilterParameters parameters;
  parameters.guard = true;
  return parameters;
}

/// The filters that a command with these parameters, or [HSC], switches on or changes.
[[nodiscard]] inline KernelFamily family_of(FilterParameters const& parameters, bool hsc) {
  if (parameters.guard) return KernelFamily::guard;
  return hsc ? KernelFamily::hsc : KernelFamily::fir;
}

/// The kernel that a command makes of an axis' filter: the lists' values and what the parameters name.
[[nodiscard]] design::KernelSpecification with_parameters(design::KernelSpecification listed,
                                                          FilterParameters const& parameters);

/// As a command would write it: "ORDER=20 SHARE=80", "MODE=2 FREQ=48"; empty for none. Numbers in their
/// shortest exact form.
[[nodiscard]] std::string to_text(FilterParameters const& parameters);

enum class FilterSwitch : std::uint8_t {
  unchanged,  ///< #FILTER [...]: changes parameters, leaves the switch as it is
  on,
  off,  ///< FIR and HSC, or the guards
};

struct FilterCommand {
  FilterSwitch filter_switch = FilterSwitch::unchanged;
  bool hsc = false;  ///< [HSC]: acts on the HSC filters, without parameters
  FilterParameters parameters;
  std::optional<double> tolerance =
      std::nullopt;  ///< AX_DEV in mm (inch if the machine file sets it); 0: no monitoring
  std::optional<double> acceleration_factor = std::nullopt;  ///< ACC_FACT

  /// #FILTER OFF reaches FIR filters as well as HSC filters.
  [[nodiscard]] bool reaches(KernelFamily family) const {
    bool const is_filter_off = filter_switch == FilterSwitch::off && !parameters.guard;
    return is_filter_off ? family != KernelFamily::guard : family == family_of(parameters, hsc);
  }
};

/// "#FILTER" or "#VIB GUARD", with what it names: "#FILTER ON [ORDER=20]". Without AX_DEV and ACC_FACT.
[[nodiscard]] std::string to_text(FilterCommand const& command);

/// The parameters in force after `command`, where `before` were set by earlier commands of the program: ON
/// forgets them, without ON or OFF the command changes those that it names. OFF and [HSC] change none.
[[nodiscard]] FilterParameters parameters_after(FilterParameters const& before, FilterCommand const& command);

}  // namespace axisc::machine
