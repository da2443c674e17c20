// The build of the control, `V3.1.3075.04`. Some parameters need a minimum build.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::validator {

// NOLINT below: clang-tidy 14 takes the zero that comparisons are rewritten with for a pointer.
struct BuildVersion {
  std::uint32_t major = 0;
  std::uint32_t minor = 0;
  std::uint32_t build = 0;
  std::uint32_t patch = 0;
  friend constexpr auto operator<=>(BuildVersion const&,
                                    BuildVersion const&) = default;  // NOLINT(modernize-use-nullptr)
};

/// `V3.1.NNNN.NN`, `V2.11.NNNN`, `V3.00.NNNN`, with or without the V; none for anything else.
[[nodiscard]] std::optional<BuildVersion> parse_build_version(std::string_view text);

/// "V3.1.3075.04"; without the last part where that is 0 and the branch has none.
[[nodiscard]] std::string to_text(BuildVersion const& version);

namespace builds {

inline constexpr BuildVersion fir{.major = 3, .minor = 1, .build = 3075, .patch = 0};
inline constexpr BuildVersion fir_command{.major = 3, .minor = 1, .build = 3075, .patch = 2};
inline constexpr BuildVersion fir_quality{.major = 3, .minor = 1, .build = 3075, .patch = 4};
inline constexpr BuildVersion position_control{.major = 3, .minor = 1, .build = 3077, .patch = 8};
inline constexpr BuildVersion quotes{.major = 3, .minor = 1, .build = 3081, .patch = 0};
/// The look-ahead buffer holds 120 blocks unless lists say otherwise; before, 70.
inline constexpr BuildVersion longer_look_ahead{.major = 2, .minor = 11, .build = 2800, .patch = 0};
inline constexpr BuildVersion spindle_filters{.major = 3, .minor = 0, .build = 0, .patch = 0};

/// TIME_DELAY exists from V2.11.2013, V2.11.2803 and V3.00.3013, depending on the branch.
[[nodiscard]] bool has_time_delay(BuildVersion const& version);

}  // namespace builds
}  // namespace axisc::validator
