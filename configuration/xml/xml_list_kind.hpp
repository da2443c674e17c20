// Which XML files hold a list: what their first element says.
#pragma once

#include "configuration/list_kind.hpp"

#include <optional>
#include <string_view>

namespace axisc::configuration {

/// The kind of list that an XML file holds, by the name of its first element: AX_MDS, SDA_MDS, StartUp or
/// RTConfiguration. In another letter case or with a prefix it is one, too, where parameters of that kind follow. None for
/// every other text. Cost: a search up to that element.
[[nodiscard]] std::optional<ListKind> xml_list_kind(std::string_view bytes);

/// The first element of such a list.
[[nodiscard]] std::string_view xml_root_of(ListKind kind);

/// False for XML whose first element says that it is something else. Empty text, and what ends before that element or
/// does not begin as XML does, may have been a list.
[[nodiscard]] bool may_be_xml_list(std::string_view bytes);

/// True for a name that ends in .xml.
[[nodiscard]] bool is_xml_name(std::string_view path);

}  // namespace axisc::configuration
