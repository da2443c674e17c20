// What a scope's project says of its channels.
#pragma once

#include "analysis/recordings/bad_recording.hpp"
#include "analysis/recordings/recording.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace axisc::recordings {

enum class SampleType : std::uint8_t {
  bit,
  int8,
  int16,
  int32,
  int64,
  uint8,
  uint16,
  uint32,
  uint64,
  real32,
  real64,
};

[[nodiscard]] std::size_t size_of(SampleType type);

struct Acquisition {
  std::string guid, name;
  std::uint32_t block = 0;  ///< its FileHandle: the index of the block
  SampleType type = SampleType::real64;
};

/// A channel of a chart.
struct ScopeChannel {
  std::size_t acquisition = 0;             ///< index into ScopeProject::acquisitions
  std::uint64_t mask = ~std::uint64_t{0};  ///< of whole numbers
  Channel channel;                         ///< without samples
};

struct ScopeProject {
  std::vector<Acquisition> acquisitions;  ///< no two with one block
  std::vector<ScopeChannel> channels;     ///< in the order of the project
};

/// `offset` is that of the XML in the file, for messages.
[[nodiscard]] std::variant<ScopeProject, BadRecording> read_project(std::string_view xml, std::size_t offset);

}  // namespace axisc::recordings
