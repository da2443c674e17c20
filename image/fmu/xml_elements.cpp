#include "image/fmu/xml_elements.hpp"

namespace axisc::image {

namespace {

struct StringWriter : pugi::xml_writer {
  std::string text;
  void write(void const* data, std::size_t size) override {
    text.append(static_cast<char const*>(data), size);
  }
};

}  // namespace

pugi::xml_node add_element(pugi::xml_node parent, char const* name, XmlAttributes attributes) {
  auto element = parent.append_child(name);
  for (auto const& [key, text] : attributes) {
    if (text != nullptr) element.append_attribute(key).set_value(text);
  }
  return element;
}

std::string text_of(pugi::xml_document& document) {
  auto declaration = document.prepend_child(pugi::node_declaration);
  declaration.append_attribute("version").set_value("1.0");
  declaration.append_attribute("encoding").set_value("UTF-8");
  StringWriter writer;
  document.save(writer, "  ", pugi::format_indent, pugi::encoding_utf8);
  return std::move(writer.text);
}

}  // namespace axisc::image
