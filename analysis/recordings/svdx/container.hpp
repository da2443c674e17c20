// The parts of a .svdx file: blocks of samples, and the scope's project as XML.
#pragma once

#include "analysis/recordings/bad_recording.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

namespace axisc::recordings {

struct SvdxBlock {
  std::size_t offset = 0;  ///< in the file
  std::uint32_t index = 0;
  std::string_view bytes;
};

struct SvdxContainer {
  std::vector<SvdxBlock> blocks;  ///< without gaps, no two with one index
  std::string_view xml;           ///< without its byte order mark
  std::size_t xml_offset = 0;
};

/// True for the first 20 bytes of a file that are not those of a text.
[[nodiscard]] bool is_binary(std::string_view first_bytes);

/// Views look into `file`.
[[nodiscard]] std::variant<SvdxContainer, BadRecording> read_container(std::string_view file);

}  // namespace axisc::recordings
