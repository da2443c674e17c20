#include "configuration/xml/xml_list_kind.hpp"

#include "configuration/xml/xml_document.hpp"
#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

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

/// What follows a document type definition; brackets enclose its subset.
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
  bool is_whole = false;  ///< the text goes on after it
};

FirstElement first_element(std::string_view bytes) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (bytes.starts_with(mark)) bytes.remove_prefix(mark.size());
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
  constexpr std::string_view extension = ".xml";
  return path.size() > extension.size() &&
         ascii::equal_ignoring_case(path.substr(path.size() - extension.size()), extension);
}

}  // namespace axisc::configuration
