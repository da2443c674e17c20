#include "configuration/xml_list.hpp"

#include "configuration/project_file.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/utf8.hpp"
#include "diagnostics/windows_1252.hpp"
#include "schema/catalogue.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>
#include <utility>
#include <vector>

namespace axisc::configuration::says {

constexpr Sentence xml_no_list{
    "this XML file holds no list: a list's first element is AX_MDS, SDA_MDS, StartUp or RTConfiguration",
    "diese XML-Datei enthält keine Liste: deren erstes Element ist AX_MDS, SDA_MDS, StartUp oder "
    "RTConfiguration"};

}  // namespace axisc::configuration::says

namespace axisc::configuration {
namespace {

struct Root {
  std::string_view name;
  ListKind kind;
};
constexpr std::array roots = {Root{.name = "AX_MDS", .kind = ListKind::axis},
                              Root{.name = "SDA_MDS", .kind = ListKind::channel},
                              Root{.name = "StartUp", .kind = ListKind::startup},
                              Root{.name = "RTConfiguration", .kind = ListKind::real_time}};

constexpr std::size_t digits_of_number = 5;

/// The name of the first element; empty where the text does not begin as XML does.
std::string_view first_element(std::string_view bytes) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (bytes.starts_with(mark)) bytes.remove_prefix(mark.size());
  for (;;) {
    std::size_t const begin = bytes.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos || bytes[begin] != '<') return {};
    bytes.remove_prefix(begin + 1);
    bool const is_comment = bytes.starts_with("!--");
    if (!is_comment && !bytes.starts_with("?")) {
      return bytes.substr(0, std::min(bytes.find_first_of(" \t\r\n/>"), bytes.size()));
    }
    std::string_view const end = is_comment ? "-->" : "?>";
    std::size_t const at = bytes.find(end);
    if (at == std::string_view::npos) return {};
    bytes.remove_prefix(at + end.size());
  }
}

/// `P-AXIS-00016.1` as number and indices; none for a number of another kind of list, and for every other name.
struct NumberedName {
  std::uint16_t number = 0;
  std::vector<std::uint32_t> indices;
};

std::optional<std::uint32_t> decimal(std::string_view text) {
  std::uint32_t number = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::optional<NumberedName> numbered_name(std::string_view name, ListKind kind) {
  std::string const prefix = number_prefix(kind) + "-";
  if (!name.starts_with(prefix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  auto const number = decimal(name.substr(0, digits_of_number));
  if (!number || name.size() < digits_of_number) return std::nullopt;
  NumberedName numbered{.number = static_cast<std::uint16_t>(*number), .indices = {}};
  name.remove_prefix(digits_of_number);
  while (!name.empty()) {
    if (name.front() != '.') return std::nullopt;
    std::size_t const end = std::min(name.find('.', 1), name.size());
    auto const index = decimal(name.substr(1, end - 1));
    if (!index) return std::nullopt;
    numbered.indices.push_back(*index);
    name.remove_prefix(end);
  }
  return numbered;
}

/// `gruppe[0].achse[1].bezeichnung` for `gruppe[].achse[].bezeichnung` and the index 1.
std::string with_indices(std::string_view pattern, std::size_t count,
                         std::vector<std::uint32_t> const& indices) {
  std::string name;
  std::size_t position = 0;
  for (char const letter : pattern) {
    name += letter;
    if (letter != '[') continue;
    std::size_t const given = position++ + indices.size();
    name += std::to_string(given < count ? 0 : indices[given - count]);
  }
  return name;
}

/// What a list calls the parameter.
std::optional<std::string> parameter_name(std::string_view element, ListKind kind) {
  auto const numbered = numbered_name(element, kind);
  if (!numbered) return std::nullopt;
  auto const catalogue = schema::Catalogue::of(kind);
  schema::Parameter const* fitting = nullptr;
  for (schema::ParameterId const id : catalogue.find_number(numbered->number)) {
    schema::Parameter const& row = catalogue.parameter(id);
    if (row.index_count() < numbered->indices.size()) continue;
    if (fitting == nullptr || row.index_count() < fitting->index_count()) fitting = &row;
  }
  if (fitting == nullptr) return std::nullopt;
  return with_indices(fitting->name, fitting->index_count(), numbered->indices);
}

/// A name that a line may begin with, and that no list knows.
std::string foreign_name(std::string_view element) {
  std::string name(element);
  for (char& letter : name) {
    if (!ascii::is_letter(letter) && !ascii::is_digit(letter)) letter = '_';
  }
  return name;
}

/// What an attribute says, in the file's encoding: its references to characters are replaced.
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

}  // namespace

std::optional<ListKind> xml_list_kind(std::string_view bytes) {
  std::string_view const name = first_element(bytes);
  auto const* const root =
      std::find_if(roots.begin(), roots.end(), [name](Root const& each) { return each.name == name; });
  return root == roots.end() ? std::nullopt : std::optional(root->kind);
}

std::variant<Translation, XmlMistake> read_xml_list(std::string bytes, ListKind kind) {
  auto parsed = parse_xml(bytes);
  if (auto const* const mistake = std::get_if<XmlMistake>(&parsed)) return *mistake;
  auto const& document = std::get<XmlDocument>(parsed);
  Translation translation{.file = {}, .list = {}, .pieces = {}, .encoding = xml_encoding(bytes)};
  for (XmlAttribute const& attribute : document.attributes) {
    if (attribute.name != "Value") continue;
    XmlElement const& element = document.elements[attribute.element];
    auto const name = parameter_name(element.name, kind);
    add_piece(translation, name ? *name : foreign_name(element.name), element.name_span);
    translation.list += ' ';
    std::string_view const raw =
        std::string_view(bytes).substr(attribute.value.begin, attribute.value.size());
    add_piece(translation, as_list_value(unescaped(raw, translation.encoding)), attribute.value);
    translation.list += '\n';
  }
  translation.file = std::move(bytes);
  return translation;
}

SourceText list_text(std::string path, std::string bytes, std::optional<XmlMistake>& mistake) {
  auto const kind = is_project_name(path) ? std::nullopt : xml_list_kind(bytes);
  if (!kind && !is_xml_name(path)) return SourceText(std::move(path), std::move(bytes));
  if (!kind) {
    mistake = XmlMistake{.span = {}, .sentence = says::xml_no_list};
  } else {
    auto read = read_xml_list(bytes, *kind);
    if (auto* const translation = std::get_if<Translation>(&read)) {
      return SourceText(std::move(path), std::move(*translation));
    }
    mistake = std::get<XmlMistake>(read);
  }
  Translation translation{.file = {}, .list = {}, .pieces = {}, .encoding = xml_encoding(bytes)};
  translation.file = std::move(bytes);
  return SourceText(std::move(path), std::move(translation));
}

bool is_xml_name(std::string_view path) {
  constexpr std::string_view extension = ".xml";
  return path.size() > extension.size() &&
         ascii::equal_ignoring_case(path.substr(path.size() - extension.size()), extension);
}

}  // namespace axisc::configuration
