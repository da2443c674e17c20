// The samples of a block of a .svdx file.
#pragma once

#include "analysis/recordings/bad_recording.hpp"
#include "analysis/recordings/svdx/container.hpp"
#include "analysis/recordings/svdx/project.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

namespace axisc::recordings {

/// Entries of a level: those above 0 have the extremes of sixteen entries below.
struct BlockLevel {
  std::size_t count = 0, offset = 0;
};

/// Times are FILETIMEs: 100 ns since 1601.
struct BlockHead {
  std::uint64_t start = 0, first = 0, last = 0;
  std::uint64_t sample_time = 0;   ///< 100 ns
  std::vector<BlockLevel> levels;  ///< by level, at least one
};

[[nodiscard]] std::variant<BlockHead, BadRecording> read_block_head(SvdxBlock const& block, SampleType type);

/// A value; whole numbers also as bits, for masks.
using ReceiveSample = std::function<void(std::uint64_t time, double value, std::uint64_t bits)>;

/// Every sample in its order, once the extremes of all levels agree with them. Why the block is refused.
[[nodiscard]] std::optional<BadRecording> read_samples(SvdxBlock const& block, BlockHead const& head,
                                                       SampleType type, ReceiveSample const& receive);

}  // namespace axisc::recordings
