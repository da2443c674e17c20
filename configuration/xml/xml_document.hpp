// XML files: which element a text belongs to, and where its bytes are.
#pragma once

#include "configuration/located_text.hpp"
#include "diagnostics/message.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace axisc::configuration {

/// The direct content of an element: spans count bytes of the file; entities are not expanded.
struct XmlElement {
  std::string_view name;
  Span name_span;
  std::size_t parent = 0;            ///< index into XmlDocument::elements; the root's parent is the root
  std::optional<Span> text;          ///< of its first text that is not blank, without blanks around it
  std::vector<Span> cdata_sections;  ///< what is between `<![CDATA[` and `]]>`
};

struct XmlAttribute {
  std::size_t element = 0;
  std::string_view name;
  Span value;  ///< without quotes
};

/// In the order of the file; views look into its bytes.
struct XmlDocument {
  std::vector<XmlElement> elements;
  std::vector<XmlAttribute> attributes;
};

struct XmlMistake {
  Span span;
  Message message;
};

/// Reads UTF-8 and single-byte encodings: one element with all others in it. A document type definition is
/// refused, entities are never expanded. Cost: one pass.
[[nodiscard]] std::variant<XmlDocument, XmlMistake> parse_xml(std::string_view bytes);

/// The text of an attribute's value (UTF-8): references to characters replaced, line ends and tabs as blanks.
[[nodiscard]] std::string attribute_text(std::string_view value);

/// The name without a namespace's prefix: `AchsMds` of `t:AchsMds`.
[[nodiscard]] std::string_view local_name(std::string_view name);

/// The encoding that the XML declaration names, or that the bytes show.
[[nodiscard]] Encoding xml_encoding(std::string_view bytes);

}  // namespace axisc::configuration
