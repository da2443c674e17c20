#include "configuration/xml/xml_names.hpp"

#include "configuration/xml/xml_document.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/utf8.hpp"
#include "schema/catalogue.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <system_error>
#include <vector>

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

constexpr std::string_view comment_begin = "<!--";
constexpr std::string_view comment_end = "-->";

std::string_view after(std::string_view text, std::string_view end) {
  std::size_t const at = text.find(end);
  return at == std::string_view::npos ? std::string_view() : text.substr(at + end.size());
}

/// The text after a document type definition; brackets enclose its subset.
std::string_view after_doctype(std::string_view bytes) {
  std::size_t depth = 0;
  while (!bytes.empty()) {
    char const first = bytes.front();
    if (bytes.starts_with(comment_begin)) {
      bytes = after(bytes, comment_end);
    } else if (first == '"' || first == '\'') {
      bytes = after(bytes.substr(1), std::string_view(&first, 1));
    } else {
      bytes.remove_prefix(1);
      if (first == '[') ++depth;
      if (first == ']' && depth > 0) --depth;
      if (first == '>' && depth == 0) break;
    }
  }
  return bytes;
}

struct FirstElement {
  std::string_view name;  ///< empty where the text does not begin as XML does, or ends before the name
  bool is_whole = false;  ///< the text continues after it
};

FirstElement first_element(std::string_view bytes) {
  bytes = without_byte_order_mark(bytes);
  for (;;) {
    std::size_t const begin = bytes.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos || bytes[begin] != '<') return {};
    bytes.remove_prefix(begin);
    if (bytes.starts_with(comment_begin)) {
      bytes = after(bytes, comment_end);
    } else if (bytes.starts_with("<?")) {
      bytes = after(bytes, "?>");
    } else if (bytes.starts_with("<!")) {
      bytes = after_doctype(bytes);
    } else {
      bytes.remove_prefix(1);
      if (bytes.starts_with('<')) return {};
      std::size_t const end = std::min(bytes.find_first_of(" \t\r\n/>"), bytes.size());
      return {.name = bytes.substr(0, end), .is_whole = end < bytes.size()};
    }
  }
}

bool contains_ignoring_case(std::string_view text, std::string_view word) {
  return std::search(text.begin(), text.end(), word.begin(), word.end(), [](char left, char right) {
           return ascii::lower_case(left) == ascii::lower_case(right);
         }) != text.end();
}

constexpr std::size_t digits_of_number = 5;

/// `P-AXIS-00016.1` as number and indices; none for a number of another kind of list, and for every other
/// name.
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

}  // namespace

std::optional<ListKind> xml_list_kind(std::string_view bytes) {
  std::string_view const name = first_element(bytes).name;
  auto const* const root = std::find_if(roots.begin(), roots.end(), [name](Root const& each) {
    return ascii::equal_ignoring_case(each.name, local_name(name));
  });
  if (root == roots.end()) return std::nullopt;
  // `startup` is a word of other files, too.
  bool const is_list = root->name == name || contains_ignoring_case(bytes, number_prefix(root->kind) + "-");
  return is_list ? std::optional(root->kind) : std::nullopt;
}

std::string_view xml_root_of(ListKind kind) {
  auto const* const root =
      std::find_if(roots.begin(), roots.end(), [kind](Root const& each) { return each.kind == kind; });
  return root == roots.end() ? std::string_view() : root->name;
}

bool may_be_xml_list(std::string_view bytes) {
  FirstElement const first = first_element(bytes);
  return first.name.empty() || !first.is_whole || xml_list_kind(bytes);
}

bool is_xml_name(std::string_view path) {
  return ascii::has_extension(path, ".xml");
}

bool is_numbered(std::string_view element) {
  constexpr std::string_view form = "P-AAAA-0";
  if (element.size() < form.size()) return false;
  return std::equal(form.begin(), form.end(), element.begin(), [](char expected, char letter) {
    if (expected == 'A') return ascii::is_letter(letter);
    if (expected == '0') return ascii::is_digit(letter);
    return ascii::upper_case(letter) == expected;
  });
}

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

}  // namespace axisc::configuration
