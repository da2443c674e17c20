#include "analysis/recordings/svdx_recording.hpp"

#include "analysis/recordings/svdx/block.hpp"
#include "analysis/recordings/svdx/container.hpp"
#include "analysis/recordings/svdx/project.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace axisc::recordings {

namespace {

constexpr double ticks_per_ms = 1e4;

/// A block with the acquisition that it belongs to.
struct Source {
  SvdxBlock const* block = nullptr;
  BlockHead head;
  std::size_t clock = 0;  ///< index into Recording::clocks
};

double milliseconds(std::uint64_t time, std::uint64_t zero) {
  auto const ticks = static_cast<std::int64_t>(time - zero);
  return static_cast<double>(ticks) / ticks_per_ms;
}

class SvdxReader {
 public:
  SvdxReader(SvdxContainer const& container, ScopeProject const& project)
      : container_(container), project_(project) {}

  std::variant<Recording, BadRecording> read() {
    for (auto const& block : container_.blocks) {
      if (auto bad = add_block(block)) return *std::move(bad);
    }
    for (auto& [acquisition, source] : sources_) {
      if (auto bad = read_source(acquisition, source)) return *std::move(bad);
    }
    for (auto const& each : project_.channels) {
      if (!sources_.contains(each.acquisition)) recording_.not_recorded.push_back(each.channel.name);
    }
    // Channels of one acquisition were read together.
    std::sort(recording_.channels.begin(), recording_.channels.end(),
              [](Channel const& a, Channel const& b) { return a.column < b.column; });
    return std::move(recording_);
  }

 private:
  std::optional<BadRecording> add_block(SvdxBlock const& block) {
    auto const& acquisitions = project_.acquisitions;
    auto const found = std::find_if(acquisitions.begin(), acquisitions.end(),
                                    [&block](Acquisition const& each) { return each.block == block.index; });
    if (found == acquisitions.end()) {
      return BadRecording{
          .problem = RecordingProblem::bad_project, .byte = block.offset, .text = "FileHandle"};
    }
    auto read = read_block_head(block, found->type);
    if (auto* const bad = std::get_if<BadRecording>(&read)) return std::move(*bad);
    auto& head = std::get<BlockHead>(read);
    zero_ = std::min(zero_, head.first);
    sources_.emplace(static_cast<std::size_t>(found - acquisitions.begin()),
                     Source{.block = &block, .head = std::move(head), .clock = recording_.clocks.size()});
    recording_.clocks.emplace_back();
    return std::nullopt;
  }

  std::optional<BadRecording> read_source(std::size_t acquisition, Source const& source) {
    auto& clock = recording_.clocks[source.clock];
    clock.sample_time = static_cast<double>(source.head.sample_time) / ticks_per_ms;
    std::vector<Channel> channels;
    std::vector<std::uint64_t> masks;
    for (auto const& each : project_.channels) {
      if (each.acquisition != acquisition) continue;
      channels.push_back(each.channel);
      channels.back().clock = source.clock;
      masks.push_back(each.mask);
    }
    bool const is_masked = std::any_of(masks.begin(), masks.end(), [](auto mask) { return ~mask != 0; });
    struct Sample {
      std::uint64_t time = 0, bits = 0;
      double value = 0;
    };
    std::optional<Sample> before;  ///< the last one at or before the window
    auto const keep = [&](Sample const& sample) {
      clock.times.push(milliseconds(sample.time, zero_));
      ++clock.samples;
      for (std::size_t i = 0; i < channels.size(); ++i) {
        auto& channel = channels[i];
        bool const is_whole = !channel.data_type.starts_with("REAL");
        double const value = is_masked && is_whole && ~masks[i] != 0
                                 ? static_cast<double>(sample.bits & masks[i])
                                 : sample.value;
        channel.values.push(value);
        if (!std::isfinite(value) && !channel.bad) channel.bad = BadField{};
      }
    };
    auto bad = read_samples(*source.block, source.head, type_of(acquisition),
                            [&](std::uint64_t time, double value, std::uint64_t bits) {
                              Sample const sample{.time = time, .bits = bits, .value = value};
                              if (time <= zero_) {
                                before = sample;
                                return;
                              }
                              if (time > source.head.last) return;
                              if (before) keep(*std::exchange(before, std::nullopt));
                              keep(sample);
                            });
    if (bad) return bad;
    if (before) keep(*before);
    std::move(channels.begin(), channels.end(), std::back_inserter(recording_.channels));
    return std::nullopt;
  }

  [[nodiscard]] SampleType type_of(std::size_t acquisition) const {
    return project_.acquisitions[acquisition].type;
  }

  SvdxContainer const& container_;
  ScopeProject const& project_;
  std::map<std::size_t, Source> sources_;  ///< by acquisition
  std::uint64_t zero_ = std::numeric_limits<std::uint64_t>::max();
  Recording recording_{.form = Form::scope_binary, .clocks = {}, .channels = {}};
};

}  // namespace

std::variant<Recording, BadRecording> read_svdx_recording(std::string_view file) {
  auto container = read_container(file);
  if (auto* const bad = std::get_if<BadRecording>(&container)) return std::move(*bad);
  auto const& parts = std::get<SvdxContainer>(container);
  auto project = read_project(parts.xml, parts.xml_offset);
  if (auto* const bad = std::get_if<BadRecording>(&project)) return std::move(*bad);
  return SvdxReader(parts, std::get<ScopeProject>(project)).read();
}

}  // namespace axisc::recordings
