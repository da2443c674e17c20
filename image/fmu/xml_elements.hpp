// XML documents as pugixml writes them.
#pragma once

#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>

namespace axisc::image {

/// Attributes in this order; those with a null text are left out.
using XmlAttributes = std::initializer_list<std::pair<char const*, char const*>>;

pugi::xml_node add_element(pugi::xml_node parent, char const* name, XmlAttributes attributes = {});

/// With declaration and line ends.
[[nodiscard]] std::string text_of(pugi::xml_document& document);

}  // namespace axisc::image
