#include "configuration/xml/xml_list.hpp"

#include "configuration/project_file.hpp"
#include "configuration/sentences.hpp"
#include "configuration/xml/xml_names.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/utf8.hpp"
#include "diagnostics/windows_1252.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

namespace axisc::configuration::says {

constexpr Sentence xml_no_list{
    "this XML file holds no list: a list's first element is AX_MDS, SDA_MDS, StartUp or RTConfiguration",
    "diese XML-Datei enthält keine Liste: deren erstes Element ist AX_MDS, SDA_MDS, StartUp oder "
    "RTConfiguration"};
constexpr Sentence xml_empty{"the list sets no parameter; export the file again, or remove it",
                             "die Liste setzt keinen Parameter; die Datei neu exportieren oder entfernen"};
constexpr Sentence xml_no_value{
    "the element has no attribute Value, so it sets nothing; write <{element} Value=\"…\"/>",
    "das Element hat kein Attribut Value und setzt nichts; <{element} Value=\"…\"/> schreiben"};
constexpr Sentence xml_text{
    "text in an XML list is not read; write a value as the attribute Value of its element, or remove the "
    "text",
    "Text in einer XML-Liste wird nicht gelesen; einen Wert als Attribut Value seines Elements schreiben "
    "oder den Text entfernen"};
constexpr Sentence xml_control{
    "the value has a line break or another control character in it; remove it",
    "im Wert steht ein Zeilenumbruch oder ein anderes Steuerzeichen; es entfernen"};

}  // namespace axisc::configuration::says

namespace axisc::configuration {
namespace {

constexpr std::string_view value_name = "Value";

/// A name that a line may begin with, but that no list knows.
std::string foreign_name(std::string_view element) {
  std::string name(element);
  for (char& letter : name) {
    if (!ascii::is_letter(letter) && !ascii::is_digit(letter)) letter = '_';
  }
  return name;
}

/// The value of an attribute, in the file's encoding: its references to characters are replaced.
std::string unescaped(std::string_view raw, Encoding encoding) {
  if (raw.find_first_of("&\t\r\n") == std::string_view::npos) return std::string(raw);
  if (encoding != Encoding::windows_1252) return attribute_text(raw);
  std::string utf8;
  for (char const byte : raw) append_utf8(utf8, decode_windows_1252(byte));
  std::string const text = attribute_text(utf8);
  std::string bytes;
  for (std::string_view rest = text; !rest.empty();) {
    DecodedCharacter const character = decode_utf8(rest);
    bytes += encode_windows_1252(character.value).value_or('?');
    rest.remove_prefix(character.size);
  }
  return bytes;
}

/// As a list writes it: empty texts, and texts in which a comment would begin, in quotes.
std::string as_list_value(std::string_view text) {
  text = ascii::trimmed(text);
  bool const begins_comment =
      text.find_first_of("(#") != std::string_view::npos || text.find("/*") != std::string_view::npos;
  bool const needs_quotes = text.empty() || (begins_comment && text.find('"') == std::string_view::npos);
  return needs_quotes ? '"' + std::string(text) + '"' : std::string(text);
}

void add_piece(Translation& translation, std::string_view text, Span file) {
  auto const begin = static_cast<std::uint32_t>(translation.list.size());
  translation.list += text;
  auto const end = static_cast<std::uint32_t>(translation.list.size());
  translation.pieces.push_back({.list = {.begin = begin, .end = end}, .file = file});
}

/// For a value as the file writes it: line ends and tabs are blanks there, unless a reference names them.
bool has_control_character(std::string_view raw) {
  constexpr std::uint32_t first_printable = 0x20;
  constexpr std::uint32_t deletion = 0x7F;
  auto const is_control = [](std::uint32_t number) { return number < first_printable || number == deletion; };
  constexpr std::string_view white = "\t\r\n";
  bool const is_raw = std::any_of(raw.begin(), raw.end(), [&](char byte) {
    return is_control(static_cast<unsigned char>(byte)) && white.find(byte) == std::string_view::npos;
  });
  if (is_raw) return true;
  constexpr std::string_view reference = "&#";
  constexpr int decimal_base = 10;
  constexpr int hexadecimal_base = 16;
  for (std::size_t at = raw.find(reference); at != std::string_view::npos; at = raw.find(reference, at + 1)) {
    std::string_view digits = raw.substr(at + reference.size());
    bool const is_hexadecimal = digits.starts_with('x');
    if (is_hexadecimal) digits.remove_prefix(1);
    std::uint32_t number = 0;
    auto const error = std::from_chars(digits.data(), digits.data() + digits.size(), number,
                                       is_hexadecimal ? hexadecimal_base : decimal_base)
                           .ec;
    if (error == std::errc::result_out_of_range || (error == std::errc{} && is_control(number))) return true;
  }
  return false;
}

/// Turns elements into lines, and anything that would be lost into mistakes.
class ListReader {
 public:
  ListReader(std::string_view bytes, XmlDocument const& document, ListKind kind, XmlList& list)
      : bytes_(bytes), document_(document), kind_(kind), list_(list) {}

  void read() {
    XmlElement const& root = document_.elements.front();
    require_spelling(root.name, xml_root_of(kind_));
    for (std::size_t element = 0; element < document_.elements.size(); ++element) read_element(element);
    if (list_.translation.list.empty() && list_.mistakes.empty()) {
      refuse(root.name_span, {says::xml_empty});
    }
  }

 private:
  void read_element(std::size_t index) {
    XmlElement const& element = document_.elements[index];
    std::string const right_name = ascii::upper_case(local_name(element.name));
    bool const is_parameter = is_numbered(right_name);
    bool const is_right = !is_parameter || require_spelling(element.name, right_name);
    bool has_value = false;
    for (; attribute_ < document_.attributes.size(); ++attribute_) {
      XmlAttribute const& attribute = document_.attributes[attribute_];
      if (attribute.element != index) break;
      if (attribute.name == value_name) {
        has_value = true;
        if (is_right) add_line(element, attribute);
      } else if (is_parameter && ascii::equal_ignoring_case(local_name(attribute.name), value_name)) {
        has_value = true;
        require_spelling(attribute.name, value_name);
      }
    }
    if (is_parameter && !has_value) {
      refuse(element.name_span, {says::xml_no_value, {{"element", right_name}}});
    } else if (index == 0 || is_parameter || has_child(index)) {
      refuse_text(element);
    }
  }

  void refuse_text(XmlElement const& element) {
    std::optional<Span> text = element.text;
    if (!text && !element.cdata_sections.empty()) text = element.cdata_sections.front();
    if (text) refuse(*text, {says::xml_text});
  }

  void add_line(XmlElement const& element, XmlAttribute const& attribute) {
    Translation& translation = list_.translation;
    std::string_view const raw = bytes_.substr(attribute.value.begin, attribute.value.size());
    if (has_control_character(raw)) {
      refuse(attribute.value, {says::xml_control});
      return;
    }
    auto const name = parameter_name(element.name, kind_);
    add_piece(translation, name ? *name : foreign_name(element.name), element.name_span);
    translation.list += ' ';
    add_piece(translation, as_list_value(unescaped(raw, translation.encoding)), attribute.value);
    translation.list += '\n';
  }

  /// False for another letter case, or a prefix. `written` looks into the bytes.
  bool require_spelling(std::string_view written, std::string_view meant) {
    if (written == meant) return true;
    auto const begin = static_cast<std::uint32_t>(written.data() - bytes_.data());
    refuse({.begin = begin, .end = begin + static_cast<std::uint32_t>(written.size())},
           {says::xml_spelling, {{"written", std::string(written)}, {"meant", std::string(meant)}}});
    return false;
  }

  [[nodiscard]] bool has_child(std::size_t index) const {
    return index + 1 < document_.elements.size() && document_.elements[index + 1].parent == index;
  }

  void refuse(Span span, Message message) {
    list_.mistakes.push_back({.span = span, .message = std::move(message)});
  }

  std::string_view bytes_;
  XmlDocument const& document_;
  ListKind kind_;
  XmlList& list_;
  std::size_t attribute_ = 0;  ///< the next one
};

}  // namespace

XmlList read_xml_list(std::string bytes, ListKind kind) {
  XmlList read{.translation = {.file = {}, .list = {}, .pieces = {}, .encoding = xml_encoding(bytes)},
               .mistakes = {}};
  auto const parsed = parse_xml(bytes);
  if (auto const* const mistake = std::get_if<XmlMistake>(&parsed)) {
    read.mistakes.push_back(*mistake);
  } else {
    ListReader(bytes, std::get<XmlDocument>(parsed), kind, read).read();
  }
  read.translation.file = std::move(bytes);
  return read;
}

SourceText list_text(std::string path, std::string bytes, std::vector<XmlMistake>& mistakes) {
  auto const kind = is_project_name(path) ? std::nullopt : xml_list_kind(bytes);
  if (!kind && !is_xml_name(path)) return SourceText(std::move(path), std::move(bytes));
  if (kind) {
    auto read = read_xml_list(std::move(bytes), *kind);
    mistakes = std::move(read.mistakes);
    return SourceText(std::move(path), std::move(read.translation));
  }
  auto const parsed = parse_xml(bytes);
  auto const* const mistake = std::get_if<XmlMistake>(&parsed);
  mistakes.push_back(mistake != nullptr ? *mistake : XmlMistake{.span = {}, .message = {says::xml_no_list}});
  Translation translation{.file = {}, .list = {}, .pieces = {}, .encoding = xml_encoding(bytes)};
  translation.file = std::move(bytes);
  return SourceText(std::move(path), std::move(translation));
}

}  // namespace axisc::configuration
