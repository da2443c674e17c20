#include "configuration/xml/xml_document.hpp"

#include "diagnostics/ascii.hpp"
#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <pugixml.hpp>

namespace axisc::configuration::says {

constexpr Sentence xml_malformed{
    "this is not well-formed XML; export the file again or correct it by hand",
    "das ist kein wohlgeformtes XML; die Datei neu exportieren oder berichtigen"};
constexpr Sentence xml_end_mismatch{
    "this end tag does not belong to the element that is open here; close each element in its turn",
    "dieses Endtag gehört nicht zum hier offenen Element; die Elemente der Reihe nach schließen"};
constexpr Sentence xml_unclosed{
    "the XML ends inside an element; the file is cut off, export it again",
    "das XML endet mitten in einem Element; die Datei ist abgeschnitten, sie neu exportieren"};
constexpr Sentence xml_attribute{"an attribute here is malformed; write name=\"value\"",
                                 "ein Attribut ist hier fehlerhaft; name=\"wert\" schreiben"};
constexpr Sentence xml_cdata{
    "the CDATA section that begins here is not closed; end it with ]]>",
    "der CDATA-Abschnitt, der hier beginnt, ist nicht geschlossen; ihn mit ]]> beenden"};
constexpr Sentence xml_doctype{"a document type definition is not read; remove it",
                               "eine Dokumenttypdefinition wird nicht gelesen; sie entfernen"};
constexpr Sentence xml_no_element{"the file holds no XML element; export it again",
                                  "die Datei enthält kein XML-Element; sie neu exportieren"};
constexpr Sentence xml_outside{
    "text or a second element outside the first one; XML has one element that holds all others: remove the "
    "rest",
    "Text oder ein zweites Element außerhalb des ersten; XML hat ein Element, das alle anderen enthält: den "
    "Rest entfernen"};
constexpr Sentence xml_nul{"a byte 0 is not allowed in XML; export the file again",
                           "ein Byte 0 ist in XML nicht erlaubt; die Datei neu exportieren"};

}  // namespace axisc::configuration::says

namespace axisc::configuration {
namespace {

constexpr std::string_view section_begin = "<![CDATA[";
constexpr std::string_view section_end = "]]>";

Span span_of(std::size_t begin, std::size_t size) {
  return {.begin = static_cast<std::uint32_t>(begin), .end = static_cast<std::uint32_t>(begin + size)};
}

XmlMistake mistake(Span span, SentenceRef sentence) {
  return {.span = span, .message = {sentence}};
}

SentenceRef sentence_of(pugi::xml_parse_result const& result, std::size_t size) {
  switch (result.status) {
    case pugi::status_bad_cdata: return says::xml_cdata;
    case pugi::status_bad_attribute: return says::xml_attribute;
    case pugi::status_bad_doctype: return says::xml_doctype;
    case pugi::status_end_element_mismatch:
      return static_cast<std::size_t>(result.offset) + 1 >= size ? says::xml_unclosed
                                                                 : says::xml_end_mismatch;
    default: return says::xml_malformed;
  }
}

/// Nodes know where their text begins in the bytes that were parsed; it is there unchanged.
class DocumentReader {
 public:
  explicit DocumentReader(std::string_view bytes) : bytes_(bytes) {}

  /// Why the file is refused.
  std::optional<XmlMistake> read(pugi::xml_node node) {
    std::size_t open = 0;
    node = node.first_child();
    while (node) {
      if (node.type() == pugi::node_doctype) {
        return mistake(span_of(std::min(bytes_.find("<!DOCTYPE"), bytes_.size()), 0), says::xml_doctype);
      }
      if (is_outside(node)) {
        return mistake(span_of(static_cast<std::size_t>(node.offset_debug()), 0), says::xml_outside);
      }
      add(node, open);
      if (node.type() == pugi::node_element && node.first_child()) {
        open = document.elements.size() - 1;
        node = node.first_child();
        continue;
      }
      while (node && !node.next_sibling()) {
        node = node.parent();
        if (node.type() == pugi::node_element) open = document.elements[open].parent;
      }
      if (node) node = node.next_sibling();
    }
    if (document.elements.empty()) return mistake(span_of(0, 0), says::xml_no_element);
    return std::nullopt;
  }

  XmlDocument document;

 private:
  [[nodiscard]] bool is_outside(pugi::xml_node const& node) const {
    if (node.parent().type() != pugi::node_document) return false;
    bool const is_second = node.type() == pugi::node_element && !document.elements.empty();
    return is_second || node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
  }

  void add(pugi::xml_node const& node, std::size_t open) {
    auto const offset = static_cast<std::size_t>(node.offset_debug());
    switch (node.type()) {
      case pugi::node_element: return add_element(node, offset, open);
      case pugi::node_pcdata:
        if (!document.elements[open].text) add_text(offset, open);
        return;
      case pugi::node_cdata: return add_section(offset, open);
      default: return;
    }
  }

  void add_element(pugi::xml_node const& node, std::size_t offset, std::size_t open) {
    Span const span = span_of(offset, std::string_view(node.name()).size());
    document.elements.push_back({.name = bytes_.substr(span.begin, span.size()),
                                 .name_span = span,
                                 .parent = open,
                                 .text = {},
                                 .cdata_sections = {}});
    std::size_t at = span.end;
    for (pugi::xml_attribute const& attribute : node.attributes()) {
      std::string_view const name = attribute.name();
      at = bytes_.find(name, at);
      std::size_t const quote = bytes_.find_first_of("\"'", at + name.size());
      std::size_t const end = bytes_.find(bytes_[quote], quote + 1);
      document.attributes.push_back({.element = document.elements.size() - 1,
                                     .name = bytes_.substr(at, name.size()),
                                     .value = span_of(quote + 1, end - quote - 1)});
      at = end + 1;
    }
  }

  void add_text(std::size_t offset, std::size_t open) {
    std::string_view const text = bytes_.substr(offset, bytes_.find('<', offset) - offset);
    constexpr std::string_view white = " \t\r\n";
    std::size_t const first = text.find_first_not_of(white);
    if (first == std::string_view::npos) return;
    document.elements[open].text = span_of(offset + first, text.find_last_not_of(white) + 1 - first);
  }

  void add_section(std::size_t offset, std::size_t open) {
    if (!bytes_.substr(0, offset).ends_with(section_begin)) return;
    document.elements[open].cdata_sections.push_back(
        span_of(offset, bytes_.find(section_end, offset) - offset));
  }

  std::string_view bytes_;
};

}  // namespace

std::variant<XmlDocument, XmlMistake> parse_xml(std::string_view bytes) {
  if (std::size_t const nul = bytes.find('\0'); nul != std::string_view::npos) {
    return mistake(span_of(nul, 1), says::xml_nul);
  }
  pugi::xml_document document;
  // Nothing is converted, so that offsets are those of the file; what is outside the first element is kept to
  // be seen.
  pugi::xml_parse_result const result = document.load_buffer(
      bytes.data(), bytes.size(), pugi::parse_cdata | pugi::parse_doctype | pugi::parse_fragment,
      pugi::encoding_utf8);
  if (!result) {
    SentenceRef const sentence = sentence_of(result, bytes.size());
    std::size_t at = std::min(static_cast<std::size_t>(result.offset), bytes.size());
    if (sentence == says::xml_unclosed) at = bytes.size();
    std::size_t const section = bytes.rfind(section_begin, at);
    bool const is_section = sentence == says::xml_cdata && section != std::string_view::npos;
    return mistake(is_section ? span_of(section, section_begin.size()) : span_of(at, 0), sentence);
  }
  DocumentReader reader(bytes);
  if (auto refused = reader.read(document)) return *std::move(refused);
  return std::move(reader.document);
}

std::string attribute_text(std::string_view value) {
  char const quote = value.find('"') == std::string_view::npos ? '"' : '\'';
  std::string element = "<a b=";
  element.append(1, quote).append(value).append(1, quote).append("/>");
  pugi::xml_document document;
  document.load_buffer(element.data(), element.size(), pugi::parse_default, pugi::encoding_utf8);
  return document.first_child().first_attribute().value();
}

std::string_view local_name(std::string_view name) {
  std::size_t const colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

Encoding xml_encoding(std::string_view bytes) {
  std::size_t const begin = bytes.size() - without_byte_order_mark(bytes).size();
  bool const declares = bytes.substr(begin).starts_with("<?xml");
  std::string_view const declaration =
      bytes.substr(0, declares ? std::min(bytes.find("?>"), bytes.size()) : 0);
  constexpr std::string_view key = "encoding=";
  std::size_t const at = declaration.find(key);
  if (at != std::string_view::npos && at + key.size() + 1 < declaration.size()) {
    std::string_view const named = declaration.substr(at + key.size() + 1);
    for (std::string_view const single : {"windows-1252", "iso-8859-1"}) {
      if (ascii::equal_ignoring_case(named.substr(0, single.size()), single)) return Encoding::windows_1252;
    }
  }
  return valid_utf8_prefix(bytes) == bytes.size() ? Encoding::utf8 : Encoding::windows_1252;
}

}  // namespace axisc::configuration
