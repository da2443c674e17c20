// The meaning of element names in XML: the first one is the kind of list, the others are the numbers of
// parameters with their indices, `P-AXIS-00008.0`.
#pragma once

#include "configuration/list_kind.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace axisc::configuration {

/// The kind of list that an XML file holds, by the name of its first element: AX_MDS, SDA_MDS, StartUp or
/// RTConfiguration. In another letter case or with a prefix it is one, too, where parameters of that kind
/// follow. None for every other text. Cost: a search up to that element.
[[nodiscard]] std::optional<ListKind> xml_list_kind(std::string_view bytes);

/// The first element of such a list.
[[nodiscard]] std::string_view xml_root_of(ListKind kind);

/// False for XML whose first element is known to be something else. Empty text, and text that ends before
/// that element or does not begin as XML does, may have been a list.
[[nodiscard]] bool may_be_xml_list(std::string_view bytes);

/// Whether an element is meant as a parameter of any kind of list: `P-AXIS-00016`, in any letter case.
[[nodiscard]] bool is_numbered(std::string_view element);

/// The parameter's name in a list of this kind: `getriebe[0].dynamik.a_max`. Where there are fewer indices
/// than the name has, the first ones are 0. None for numbers of other kinds, unknown ones, and every other
/// name.
[[nodiscard]] std::optional<std::string> parameter_name(std::string_view element, ListKind kind);

/// True for a name that ends in .xml.
[[nodiscard]] bool is_xml_name(std::string_view path);

}  // namespace axisc::configuration
