#include "analysis/recordings/svdx/container.hpp"

#include "analysis/recordings/svdx/byte_reader.hpp"
#include "diagnostics/utf8.hpp"

#include <algorithm>

namespace axisc::recordings {

namespace {

constexpr std::size_t file_head_size = 20;
constexpr std::size_t entry_size = 20;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

BadRecording bad(RecordingProblem problem, std::size_t byte) {
  return {.problem = problem, .byte = byte};
}

bool has_index(std::vector<SvdxBlock> const& blocks, std::uint32_t index) {
  return std::any_of(blocks.begin(), blocks.end(),
                     [index](SvdxBlock const& block) { return block.index == index; });
}

}  // namespace

bool is_binary(std::string_view first_bytes) {
  bool const is_utf16 = first_bytes.starts_with("\xFF\xFE") || first_bytes.starts_with("\xFE\xFF");
  return !is_utf16 && first_bytes.substr(0, file_head_size).find('\0') != std::string_view::npos;
}

std::variant<SvdxContainer, BadRecording> read_container(std::string_view file) {
  if (file.size() < file_head_size) return bad(RecordingProblem::too_short, file.size());
  auto const xml_offset = number_at<std::uint64_t>(file, 0);
  auto const xml_size = number_at<std::uint64_t>(file, 8);
  auto const count = number_at<std::uint32_t>(file, 16);
  if (xml_offset > file.size() || xml_size != file.size() - xml_offset) {
    return bad(RecordingProblem::too_short, 0);
  }
  if (xml_offset < file_head_size || count > (xml_offset - file_head_size) / entry_size) {
    return bad(RecordingProblem::bad_container, 16);
  }
  SvdxContainer found;
  std::size_t end = file_head_size + entry_size * count;
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t const entry = file_head_size + entry_size * i;
    auto const offset = number_at<std::uint64_t>(file, entry);
    auto const size = number_at<std::uint64_t>(file, entry + 8);
    auto const index = number_at<std::uint32_t>(file, entry + 16);
    bool const is_sound = offset == end && size <= xml_offset - end && !has_index(found.blocks, index);
    if (!is_sound) return bad(RecordingProblem::bad_container, entry);
    found.blocks.push_back({.offset = end, .index = index, .bytes = file.substr(end, size)});
    end += size;
  }
  if (end != xml_offset) return bad(RecordingProblem::bad_container, end);
  found.xml = file.substr(end);
  found.xml_offset = end;
  if (found.xml.starts_with(byte_order_mark)) {
    found.xml.remove_prefix(byte_order_mark.size());
    found.xml_offset += byte_order_mark.size();
  }
  auto const valid = valid_utf8_prefix(found.xml);
  auto const nul = found.xml.find('\0');
  if (valid != found.xml.size() || nul != std::string_view::npos) {
    return bad(RecordingProblem::bad_xml, found.xml_offset + std::min(valid, nul));
  }
  return found;
}

}  // namespace axisc::recordings
