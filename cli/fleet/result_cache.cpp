#include "cli/fleet/result_cache.hpp"

#include "cli/failure.hpp"
#include "cli/fleet/byte_stream.hpp"
#include "cli/options/quantities.hpp"

#include <utility>

namespace axisc::cli::says {

constexpr Sentence bad_size{"{option} needs a size, as in 500M or 2G, not \"{value}\"",
                            "{option} braucht eine Größe, etwa 500M oder 2G, nicht \"{value}\""};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

/// Codes start at 1.
std::uint64_t as_number(std::optional<configuration::FileError> error) {
  return error ? static_cast<std::uint64_t>(*error) + 1 : 0;
}

}  // namespace

Digest CachedInput::key(Digest const& content) const {
  Hasher hasher;
  hasher.digest(run_);
  hasher.text(path_);
  hasher.digest(content);
  return hasher.finish();
}

std::optional<std::string> CachedInput::find() {
  auto const own = files_.state_of(path_);
  if (own.error) return std::nullopt;
  auto const entry = cache_.store_.find(key(own.digest));
  if (!entry) return std::nullopt;
  ByteReader bytes(*entry);
  for (auto left = bytes.count(); left > 0; --left) {
    std::string const path(bytes.text());
    auto const error = bytes.number();
    auto const digest = bytes.digest();
    if (!bytes.ok()) return std::nullopt;
    auto const now = files_.state_of(path);
    if (as_number(now.error) != error || now.digest != digest) return std::nullopt;
  }
  auto const result = bytes.text();
  return bytes.ok() && bytes.at_end() ? std::optional(std::string(result)) : std::nullopt;
}

void CachedInput::keep(std::string_view result) {
  auto const& dependencies = files_.dependencies();
  auto const own = dependencies.find(path_);
  if (!files_.is_complete() || own == dependencies.end() || own->second.error) return;
  ByteWriter bytes;
  bytes.number(dependencies.size() - 1);
  for (auto const& [path, state] : dependencies) {
    if (path == path_) continue;
    bytes.text(path);
    bytes.number(as_number(state.error));
    bytes.digest(state.digest);
  }
  bytes.text(result);
  cache_.store_.add(key(own->second.digest), std::move(bytes).take());
}

std::uint64_t parse_size(std::string_view option, std::string const& text) {
  std::string_view digits = text;
  unsigned shift = 0;
  for (auto const& [letter, bits] : {std::pair('K', 10U), {'M', 20U}, {'G', 30U}, {'T', 40U}}) {
    if (!digits.ends_with(letter)) continue;
    shift = bits;
    digits.remove_suffix(1);
    break;
  }
  auto const count = parse_count(digits);
  if (!count || *count == 0 || *count > (std::uint64_t{1} << (62U - shift))) {
    throw Failure(
        {.sentence = says::bad_size, .arguments = {{"option", std::string(option)}, {"value", text}}});
  }
  return *count << shift;
}

}  // namespace axisc::cli
