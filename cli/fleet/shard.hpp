// `--shard I/N`: a part of the inputs, so that many machines share the work.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::cli {

struct Shard {
  std::uint32_t index = 1;  ///< from 1 to `count`
  std::uint32_t count = 1;
};

/// Failure for anything but I/N with 1 <= I <= N <= 1000000.
[[nodiscard]] Shard parse_shard(std::string_view text);

/// True when `path` belongs to the shard. Depends on nothing but the path: relative to the working folder (absolute
/// ones too, if they are below it), without "." and "x/..".
[[nodiscard]] bool is_in_shard(Shard const& shard, std::string const& path,
                               std::string const& working_folder);

/// A file name relative to `folder`; the whole name if it is elsewhere.
[[nodiscard]] std::string path_below(std::string const& folder, std::string const& path);

}  // namespace axisc::cli
