#include "analysis/recordings/svdx/project.hpp"

#include "analysis/recordings/decimal_number.hpp"
#include "analysis/recordings/text_encoding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <pugixml.hpp>
#include <utility>

namespace axisc::recordings {

namespace {

struct TypeRow {
  std::string_view name;
  std::size_t size;
};

/// By SampleType.
constexpr std::array<TypeRow, 11> types{{{"BIT", 1},
                                         {"INT8", 1},
                                         {"INT16", 2},
                                         {"INT32", 4},
                                         {"INT64", 8},
                                         {"UINT8", 1},
                                         {"UINT16", 2},
                                         {"UINT32", 4},
                                         {"UINT64", 8},
                                         {"REAL32", 4},
                                         {"REAL64", 8}}};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view white = " \t\r\n";
  auto const first = text.find_first_not_of(white);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(white) + 1 - first);
}

std::string_view text_of(pugi::xml_node const& node, char const* path) {
  return trimmed(node.first_element_by_path(path).text().get());
}

/// Elements in the order of the file, whatever is around them.
class Elements : public pugi::xml_tree_walker {
 public:
  bool for_each(pugi::xml_node& node) override {
    std::string_view const name = node.name();
    if (name == "AdsAcquisition") acquisitions.push_back(node);
    if (name == "Channel") channels.push_back(node);
    return true;
  }
  std::vector<pugi::xml_node> acquisitions, channels;
};

class ProjectReader {
 public:
  explicit ProjectReader(std::size_t offset) : offset_(offset) {}

  std::variant<ScopeProject, BadRecording> read(pugi::xml_document& document) {
    if (std::string_view(document.document_element().name()) != "ScopeProject") {
      return bad(RecordingProblem::bad_project, document.document_element(), "ScopeProject");
    }
    Elements elements;
    document.traverse(elements);
    for (auto const& node : elements.acquisitions) {
      if (auto refused = add_acquisition(node)) return *std::move(refused);
    }
    for (auto const& node : elements.channels) {
      if (auto refused = add_channel(node)) return *std::move(refused);
    }
    if (project_.channels.empty()) {
      return bad(RecordingProblem::bad_project, document.document_element(), "Channel");
    }
    return std::move(project_);
  }

 private:
  [[nodiscard]] BadRecording bad(RecordingProblem problem, pugi::xml_node const& node,
                                 std::string_view text) const {
    auto const at = std::max<std::ptrdiff_t>(node.offset_debug(), 0);
    return {.problem = problem, .byte = offset_ + static_cast<std::size_t>(at), .text = shown_text(text)};
  }

  std::optional<BadRecording> add_acquisition(pugi::xml_node const& node) {
    Acquisition made{.guid = std::string(text_of(node, "Guid")), .name = std::string(text_of(node, "Name"))};
    if (made.guid.empty()) return bad(RecordingProblem::bad_project, node, "Guid");
    auto const compression = text_of(node, "CompressionMode");
    if (compression != "Uncompressed") return bad(RecordingProblem::compressed, node, compression);
    auto const word = text_of(node, "DataType");
    auto const* const type =
        std::find_if(types.begin(), types.end(), [word](TypeRow const& row) { return row.name == word; });
    if (type == types.end()) return bad(RecordingProblem::unknown_type, node, word);
    made.type = static_cast<SampleType>(type - types.begin());
    if (parse_whole(text_of(node, "VariableSize")) != type->size) {
      return bad(RecordingProblem::bad_project, node, "VariableSize");
    }
    auto const handle = parse_whole(text_of(node, "FileHandle"));
    bool const is_other = std::any_of(
        project_.acquisitions.begin(), project_.acquisitions.end(), [&](Acquisition const& other) {
          return other.guid == made.guid || (handle && *handle != 0 && other.block == *handle);
        });
    if (!handle || *handle > UINT32_MAX || is_other) {
      return bad(RecordingProblem::bad_project, node, "FileHandle");
    }
    made.block = static_cast<std::uint32_t>(*handle);
    project_.acquisitions.push_back(std::move(made));
    nodes_.push_back(node);
    return std::nullopt;
  }

  std::optional<BadRecording> add_channel(pugi::xml_node const& node) {
    auto const interpreter = node.first_element_by_path("SubMember/AcquisitionInterpreter");
    auto const guid = text_of(interpreter, "AcquisitionGUID");
    auto const& acquisitions = project_.acquisitions;
    auto const found = std::find_if(acquisitions.begin(), acquisitions.end(),
                                    [guid](Acquisition const& each) { return each.guid == guid; });
    if (found == acquisitions.end()) return bad(RecordingProblem::bad_project, node, "AcquisitionGUID");
    ScopeChannel made{.acquisition = static_cast<std::size_t>(found - acquisitions.begin()), .channel = {}};
    auto const source = nodes_[made.acquisition];
    auto& channel = made.channel;
    channel.name = std::string(text_of(node, "Name"));
    channel.column = project_.channels.size() + 1;
    channel.symbol = std::string(text_of(source, "SymbolName"));
    channel.data_type = std::string(types.at(static_cast<std::size_t>(found->type)).name);
    channel.unit = std::string(text_of(interpreter, "ResultingUnit/Unit/ReturnText"));
    channel.port = parse_whole(text_of(source, "TargetPort"));
    channel.index_group = parse_whole(text_of(source, "IndexGroup"));
    channel.index_offset = parse_whole(text_of(source, "IndexOffset"));
    channel.is_raw = true;
    std::array<std::pair<char const*, double*>, 4> const numbers{
        {{"ScaleFactor", &channel.scale.factor},
         {"Offset", &channel.scale.offset},
         {"ResultingUnit/UnitScaleResult", &channel.scale.unit_factor},
         {"ResultingUnit/UnitOffsetResult", &channel.scale.unit_offset}}};
    for (auto const& [path, number] : numbers) {
      auto const parsed = parse_number(text_of(interpreter, path));
      if (!parsed || !std::isfinite(parsed->value)) return bad(RecordingProblem::bad_project, node, path);
      *number = parsed->value;
    }
    auto const mask = text_of(interpreter, "BitMask");
    if (!mask.empty()) {
      auto const parsed = parse_whole(mask);
      if (!parsed) return bad(RecordingProblem::bad_project, node, "BitMask");
      made.mask = *parsed;
    }
    project_.channels.push_back(std::move(made));
    return std::nullopt;
  }

  std::size_t offset_;
  ScopeProject project_;
  std::vector<pugi::xml_node> nodes_;  ///< of the acquisitions
};

}  // namespace

std::size_t size_of(SampleType type) {
  return types.at(static_cast<std::size_t>(type)).size;
}

std::variant<ScopeProject, BadRecording> read_project(std::string_view xml, std::size_t offset) {
  pugi::xml_document document;
  auto const result = document.load_buffer(xml.data(), xml.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    return BadRecording{
        .problem = RecordingProblem::bad_xml,
        .byte = offset + static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0))};
  }
  return ProjectReader(offset).read(document);
}

}  // namespace axisc::recordings
