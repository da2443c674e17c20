#include "validator/loading/build_version.hpp"

#include <array>
#include <charconv>

#include <fmt/format.h>

namespace axisc::validator {

std::optional<BuildVersion> parse_build_version(std::string_view text) {
  if (!text.empty() && (text.front() == 'V' || text.front() == 'v')) text.remove_prefix(1);
  std::array<std::uint32_t, 4> parts{};
  std::size_t count = 0;
  char const* at = text.data();
  char const* const end = text.data() + text.size();
  while (count < parts.size()) {
    auto const [behind, error] = std::from_chars(at, end, parts[count]);
    if (error != std::errc{}) return std::nullopt;
    ++count;
    at = behind;
    if (at == end) break;
    if (*at != '.') return std::nullopt;
    ++at;
  }
  if (at != end || count < 3) return std::nullopt;
  return BuildVersion{.major = parts[0], .minor = parts[1], .build = parts[2], .patch = parts[3]};
}

std::string to_text(BuildVersion const& version) {
  if (version.major == 3 && version.minor == 1) {
    return fmt::format("V3.1.{}.{:02}", version.build, version.patch);
  }
  std::string text = fmt::format("V{}.{:02}", version.major, version.minor);
  if (version.build != 0) text += fmt::format(".{}", version.build);
  return text;
}

bool builds::has_time_delay(BuildVersion const& version) {
  constexpr std::uint32_t newer_branch = 2800;
  if (version.major == 2 && version.minor == 11) {
    return version.build >= (version.build < newer_branch ? 2013 : 2803);
  }
  return version >= BuildVersion{.major = 3, .minor = 0, .build = 3013, .patch = 0};
}

}  // namespace axisc::validator
