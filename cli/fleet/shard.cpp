#include "cli/fleet/shard.hpp"

#include "cli/failure.hpp"
#include "cli/fleet/digest.hpp"
#include "cli/options/quantities.hpp"
#include "system/path.hpp"

#include <algorithm>
#include <filesystem>

namespace axisc::cli::says {

constexpr Sentence bad_shard{"--shard needs I/N with I from 1 to N, as in 2/8, not \"{value}\"",
                             "--shard braucht I/N mit I von 1 bis N, etwa 2/8, nicht \"{value}\""};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

constexpr std::uint64_t most_shards = 1'000'000;

}  // namespace

Shard parse_shard(std::string_view text) {
  auto const slash = std::min(text.find('/'), text.size());
  auto const index = parse_count(text.substr(0, slash));
  auto const count = parse_count(text.substr(std::min(slash + 1, text.size())));
  bool const good = index && count && *index >= 1 && *index <= *count && *count <= most_shards;
  if (!good) throw Failure({.sentence = says::bad_shard, .arguments = {{"value", std::string(text)}}});
  return {.index = static_cast<std::uint32_t>(*index), .count = static_cast<std::uint32_t>(*count)};
}

std::string path_below(std::string const& folder, std::string const& path) {
  auto const whole = system::name_of(system::path_of(path).lexically_normal());
  bool const is_below = whole.size() > folder.size() && whole.starts_with(folder) &&
                        (folder.ends_with('/') || whole[folder.size()] == '/');
  return is_below ? whole.substr(folder.size() + (folder.ends_with('/') ? 0 : 1)) : whole;
}

bool is_in_shard(Shard const& shard, std::string const& path, std::string const& working_folder) {
  return digest_of(path_below(working_folder, path)).low % shard.count + 1 == shard.index;
}

}  // namespace axisc::cli
