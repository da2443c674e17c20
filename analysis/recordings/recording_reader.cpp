#include "analysis/recordings/recording_reader.hpp"

#include "analysis/recordings/svdx/container.hpp"
#include "analysis/recordings/svdx_recording.hpp"
#include "analysis/recordings/text_encoding.hpp"
#include "analysis/recordings/text_recording.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace axisc::recordings {

namespace {

std::string all_bytes(ByteSource const& source) {
  constexpr std::size_t least = std::size_t{1} << 16U;
  std::string bytes;
  for (;;) {
    auto const filled = bytes.size();
    bytes.resize(filled + std::max(filled, least));
    auto const got = source(std::span(bytes).subspan(filled));
    bytes.resize(filled + got);
    if (got == 0) return bytes;
  }
}

}  // namespace

std::variant<Recording, BadRecording> read_recording(ByteSource source) {
  constexpr std::size_t deciding = 20;
  if (is_binary(first_bytes(source, deciding))) return read_svdx_recording(all_bytes(source));
  return read_text_recording(std::move(source));
}

}  // namespace axisc::recordings
