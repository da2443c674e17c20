// An update or template file: the parameters of one list as XML elements, `<P-AXIS-00016 Value="1"/>`.
#pragma once

#include "configuration/list_kind.hpp"
#include "configuration/xml/xml_document.hpp"
#include "diagnostics/source_text.hpp"

#include <string>
#include <vector>

namespace axisc::configuration {

struct XmlList {
  Translation translation;
  std::vector<XmlMistake> mistakes;  ///< in the order of the file; what they concern is left out
};

/// The elements with an attribute Value, at any depth, as lines `name value`. Numbers after a parameter's
/// number are its indices (`P-STUP-00015.1` is achs_mds[1]); where there are fewer than the name has, the
/// first ones are 0. An element that is not a parameter's number becomes a name that no list knows. Anything
/// that may have been meant as a value is reported as a mistake: parameters without Value, names in another
/// spelling, text, control characters in values, and a list that sets nothing.
[[nodiscard]] XmlList read_xml_list(std::string bytes, ListKind kind);

/// The source of a file's text: for a list in XML its values as lines, for every other file the text itself.
/// `mistakes` are those of the XML; where it is not well-formed, its list is empty.
[[nodiscard]] SourceText list_text(std::string path, std::string bytes, std::vector<XmlMistake>& mistakes);

}  // namespace axisc::configuration
