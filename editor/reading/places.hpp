// Places as the protocol writes them.
#pragma once

#include "axisc/workspace/buffers.hpp"
#include "diagnostics/source_text.hpp"
#include "editor/reading/requests.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::editor {

class Places {
 public:
  /// All outlive this object.
  Places(SourceSet const& sources, Buffers const& buffers, PositionEncoding encoding)
      : sources_(sources), buffers_(buffers), encoding_(encoding) {}

  [[nodiscard]] std::string uri(Place const& place) const;
  [[nodiscard]] Json range(Place const& place) const;
  /// URI and range.
  [[nodiscard]] Json location(Place const& place) const;

 private:
  [[nodiscard]] Json position(SourceId source, Position at) const;

  SourceSet const& sources_;
  Buffers const& buffers_;
  PositionEncoding encoding_;
  /// The line of each CR without LF: it ends a line in the protocol, but not in a list.
  mutable std::map<SourceId, std::vector<std::uint32_t>> lone_returns_;
};

[[nodiscard]] Json position_json(TextPosition position);
[[nodiscard]] Json range_json(TextPosition begin, TextPosition end);
/// The range between two bytes of a text.
[[nodiscard]] Json range_between(std::string_view text, std::size_t begin, std::size_t end,
                                 PositionEncoding encoding);

/// True inside the span and at both ends, as for a cursor.
[[nodiscard]] constexpr bool touches(Span span, std::size_t offset) {
  return span.begin <= offset && offset <= span.end;
}

/// A single edit that turns `before` into `after`; empty for equal texts.
[[nodiscard]] Json edits_between(std::string_view before, std::string_view after, PositionEncoding encoding);

}  // namespace axisc::editor
