#include "analysis/recordings/svdx/block.hpp"

#include "analysis/recordings/svdx/byte_reader.hpp"
#include "analysis/recordings/text_encoding.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

namespace axisc::recordings {

namespace {

constexpr std::string_view version = "01.00.00.40";
constexpr std::size_t block_head_size = version.size() + std::size_t{7} * 8;
constexpr std::size_t level_size = 56;
constexpr std::size_t most_levels = 64;
constexpr std::uint64_t per_entry = 16;
constexpr std::size_t time_size = 8;

template <class Number>
struct Extremes {
  std::uint64_t time = 0;
  Number first{}, second{};  ///< in the order of time
};

/// `extremes` are the smallest and the largest of `values`, in an order in which they occur.
template <class Number>
bool agrees(Extremes<Number> const& extremes, std::vector<Number> const& values) {
  auto const [low, high] = std::minmax_element(values.begin(), values.end());
  bool const are_they = (extremes.first == *low && extremes.second == *high) ||
                        (extremes.first == *high && extremes.second == *low);
  if (!are_they) return false;
  auto const begin = std::find(values.begin(), values.end(), extremes.first);
  auto const end = std::find(values.rbegin(), values.rend(), extremes.second);
  return begin <= std::prev(end.base());
}

template <class Number>
class Samples {
 public:
  Samples(SvdxBlock const& block, BlockHead const& head) : block_(block), head_(head) {}

  std::optional<BadRecording> read(ReceiveSample const& receive) {
    auto refused = check_samples();
    for (std::size_t level = 2; !refused && level < head_.levels.size(); ++level) refused = check(level);
    if (!refused) for_each_sample(receive);
    return refused;
  }

 private:
  [[nodiscard]] BadRecording bad(RecordingProblem problem, std::size_t at) const {
    return {.problem = problem, .byte = block_.offset + at};
  }
  [[nodiscard]] Extremes<Number> entry(std::size_t level, std::size_t index) const {
    auto const at = head_.levels[level].offset + index * (time_size + 2 * sizeof(Number));
    return {.time = number_at<std::uint64_t>(block_.bytes, at),
            .first = number_at<Number>(block_.bytes, at + time_size),
            .second = number_at<Number>(block_.bytes, at + time_size + sizeof(Number))};
  }
  [[nodiscard]] std::size_t count(std::size_t level) const {
    return level < head_.levels.size() ? head_.levels[level].count : 0;
  }

  /// Level 0, and level 1 which has an entry for each of its entries; one that is not full may lack it.
  std::optional<BadRecording> check_samples() {
    std::size_t at = head_.levels[0].offset;
    std::uint64_t last = 0;
    std::vector<Number> values;
    std::size_t full = 0;
    for (std::size_t i = 0; i < count(0); ++i) {
      constexpr std::size_t entry_head = time_size + 4;
      std::size_t const rest = block_.bytes.size() - at;
      if (rest < entry_head) return bad(RecordingProblem::bad_block, at);
      auto const base = number_at<std::uint64_t>(block_.bytes, at);
      auto const samples = number_at<std::uint32_t>(block_.bytes, at + time_size);
      constexpr std::size_t sample_size = 4 + sizeof(Number);
      bool const is_sound =
          samples >= 1 && samples <= per_entry && rest - entry_head >= samples * sample_size;
      if (!is_sound) return bad(RecordingProblem::bad_block, at);
      std::size_t const begin = at;
      at += entry_head;
      values.clear();
      for (std::uint32_t n = 0; n < samples; ++n, at += sample_size) {
        auto const ticks = number_at<std::uint32_t>(block_.bytes, at);
        bool const is_in_range = base <= std::numeric_limits<std::uint64_t>::max() - ticks;
        if (!is_in_range || base + ticks <= last) return bad(RecordingProblem::bad_time, at);
        last = base + ticks;
        values.push_back(number_at<Number>(block_.bytes, at + 4));
      }
      if (samples == per_entry) ++full;
      if (i >= count(1)) continue;
      auto const extremes = entry(1, i);
      bool const agree = extremes.time == base && agrees(extremes, values);
      if (!agree) return bad(RecordingProblem::bad_extremes, begin);
    }
    if (at != block_.bytes.size()) return bad(RecordingProblem::bad_block, at);
    bool const has_all = head_.levels.size() == 1 || (count(1) <= count(0) && count(1) >= full);
    if (!has_all) return bad(RecordingProblem::bad_extremes, head_.levels[1].offset);
    return std::nullopt;
  }

  std::optional<BadRecording> check(std::size_t level) const {
    auto const below = count(level - 1);
    auto const here = count(level);
    bool const has_all = here >= below / per_entry && here <= (below + per_entry - 1) / per_entry;
    if (!has_all) return bad(RecordingProblem::bad_extremes, head_.levels[level].offset);
    std::vector<Number> values;
    for (std::size_t i = 0; i < here; ++i) {
      values.clear();
      auto const end = std::min<std::size_t>(below, (i + 1) * per_entry);
      for (std::size_t n = i * per_entry; n < end; ++n) {
        auto const each = entry(level - 1, n);
        values.insert(values.end(), {each.first, each.second});
      }
      auto const extremes = entry(level, i);
      bool const agree = extremes.time == entry(level - 1, i * per_entry).time && agrees(extremes, values);
      if (!agree) return bad(RecordingProblem::bad_extremes, head_.levels[level].offset);
    }
    return std::nullopt;
  }

  void for_each_sample(ReceiveSample const& receive) const {
    std::size_t at = head_.levels[0].offset;
    for (std::size_t i = 0; i < count(0); ++i) {
      auto const base = number_at<std::uint64_t>(block_.bytes, at);
      auto const samples = number_at<std::uint32_t>(block_.bytes, at + time_size);
      at += time_size + 4;
      for (std::uint32_t n = 0; n < samples; ++n, at += 4 + sizeof(Number)) {
        auto const value = number_at<Number>(block_.bytes, at + 4);
        std::uint64_t bits = 0;
        if constexpr (std::is_integral_v<Number>) {
          bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
        }
        receive(base + number_at<std::uint32_t>(block_.bytes, at), static_cast<double>(value), bits);
      }
    }
  }

  SvdxBlock const& block_;
  BlockHead const& head_;
};

}  // namespace

std::variant<BlockHead, BadRecording> read_block_head(SvdxBlock const& block, SampleType type) {
  auto const& bytes = block.bytes;
  auto const bad = [&block](RecordingProblem problem, std::size_t at) {
    return BadRecording{.problem = problem, .byte = block.offset + at};
  };
  if (bytes.size() < block_head_size) return bad(RecordingProblem::bad_block, 0);
  if (!bytes.starts_with(version)) {
    auto refused = bad(RecordingProblem::unknown_version, 0);
    refused.text = shown_text(bytes.substr(0, version.size()));
    return refused;
  }
  auto const word = [&bytes](std::size_t i) {
    return number_at<std::uint64_t>(bytes, version.size() + 8 * i);
  };
  BlockHead head{.start = word(0), .first = word(2), .last = word(3), .sample_time = word(6), .levels = {}};
  auto const levels = word(4);
  bool const is_sound = head.start <= head.first && head.first <= head.last && word(5) == per_entry &&
                        head.sample_time > 0 && levels >= 1 && levels <= most_levels;
  if (!is_sound) return bad(RecordingProblem::bad_block, version.size());
  if ((bytes.size() - block_head_size) / level_size < levels) {
    return bad(RecordingProblem::bad_block, block_head_size);
  }
  head.levels.resize(levels);
  std::size_t end = block_head_size + level_size * levels;
  auto const entry_size = time_size + 2 * size_of(type);
  for (std::size_t i = 0; i < levels; ++i) {
    std::size_t const at = block_head_size + level_size * i;
    std::size_t const level = levels - 1 - i;
    auto const count = number_at<std::uint64_t>(bytes, at);
    bool const is_sound_level = number_at<std::uint64_t>(bytes, at + 8) == count &&
                                number_at<std::uint32_t>(bytes, at + 16) == level &&
                                number_at<std::uint32_t>(bytes, at + 20) == end;
    auto const room = bytes.size() - end;
    bool const has_room = count <= room / (level == 0 ? 1 : entry_size);
    if (!is_sound_level || !has_room) return bad(RecordingProblem::bad_block, at);
    auto const entries = static_cast<std::size_t>(count);
    head.levels[level] = {.count = entries, .offset = end};
    if (level > 0) end += entries * entry_size;
  }
  return head;
}

std::optional<BadRecording> read_samples(SvdxBlock const& block, BlockHead const& head, SampleType type,
                                         ReceiveSample const& receive) {
  switch (type) {
    case SampleType::bit:
    case SampleType::uint8: return Samples<std::uint8_t>(block, head).read(receive);
    case SampleType::int8: return Samples<std::int8_t>(block, head).read(receive);
    case SampleType::int16: return Samples<std::int16_t>(block, head).read(receive);
    case SampleType::int32: return Samples<std::int32_t>(block, head).read(receive);
    case SampleType::int64: return Samples<std::int64_t>(block, head).read(receive);
    case SampleType::uint16: return Samples<std::uint16_t>(block, head).read(receive);
    case SampleType::uint32: return Samples<std::uint32_t>(block, head).read(receive);
    case SampleType::uint64: return Samples<std::uint64_t>(block, head).read(receive);
    case SampleType::real32: return Samples<float>(block, head).read(receive);
    case SampleType::real64: return Samples<double>(block, head).read(receive);
  }
  return BadRecording{.problem = RecordingProblem::unknown_type, .byte = block.offset};
}

}  // namespace axisc::recordings
