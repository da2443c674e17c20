// An update or template file: the parameters of one list as XML elements, `<P-AXIS-00016 Value="1"/>`.
#pragma once

#include "configuration/list_kind.hpp"
#include "configuration/xml_document.hpp"
#include "diagnostics/source_text.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace axisc::configuration {

/// The kind of list that an XML file holds, by the name of its first element: AX_MDS, SDA_MDS, StartUp or
/// RTConfiguration; none for every other text. Cost: a search up to that element.
[[nodiscard]] std::optional<ListKind> xml_list_kind(std::string_view bytes);

/// The elements with an attribute Value, at any depth, as lines `name value`. Numbers behind a parameter's number are its
/// indices (`P-STUP-00015.1` is achs_mds[1]); where there are fewer than the name has, the first ones are 0. An element
/// that is no parameter's number becomes a name that no list knows.
[[nodiscard]] std::variant<Translation, XmlMistake> read_xml_list(std::string bytes, ListKind kind);

/// The source of a file's text: of a list in XML what it says as lines, of every other file the text itself. `mistake` says
/// why XML is not read; then its list is empty.
[[nodiscard]] SourceText list_text(std::string path, std::string bytes, std::optional<XmlMistake>& mistake);

/// True for a name that ends in .xml.
[[nodiscard]] bool is_xml_name(std::string_view path);

}  // namespace axisc::configuration
