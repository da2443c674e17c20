#include "lists/generator.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <string_view>

namespace axisc::bench {
namespace {

/// JSON has neither hexadecimal numbers nor words.
std::string json_value(Entry const& entry) {
  if (entry.kind == EntryKind::text) return '"' + entry.value + '"';
  if (entry.value == "TRUE" || entry.value == "1" || entry.value == "FALSE" || entry.value == "0") {
    if (entry.kind == EntryKind::boolean) {
      return entry.value == "TRUE" || entry.value == "1" ? "true" : "false";
    }
  }
  if (entry.value.substr(0, 2) == "0x")
    return std::to_string(std::strtoull(entry.value.c_str(), nullptr, 16));
  return entry.value;
}

struct Node {
  std::vector<Entry> properties;
  std::map<std::string, std::unique_ptr<Node>> children;
};

void write_node(Node const& node, std::string const& indent, std::string& text) {
  for (Entry const& property : node.properties) {
    bool const is_cell = property.kind == EntryKind::integer && property.value.front() != '-';
    std::string const value = property.kind == EntryKind::boolean
                                  ? "<" + std::string(json_value(property) == "true" ? "1" : "0") + ">"
                              : is_cell ? "<" + property.value + ">"
                                        : '"' + property.value + '"';
    text += indent + property.name + " = " + value + ";\n";
  }
  for (auto const& [name, child] : node.children) {
    text += indent + name + " {\n";
    write_node(*child, indent + "\t", text);
    text += indent + "};\n";
  }
}

/// `filter[0]` may not name a node.
std::string node_name(std::string_view part) {
  std::string name;
  for (char const byte : part) {
    if (byte == '[') name += '-';
    if (byte != '[' && byte != ']') name += byte;
  }
  return name;
}

}  // namespace

std::string as_json(GeneratedList const& list) {
  std::string text = "{\n";
  for (Entry const& entry : list.entries) {
    if (text.size() > 2) text += ",\n";
    text += "  \"" + entry.name + "\": " + json_value(entry);
  }
  return text + "\n}\n";
}

std::string as_ini(GeneratedList const& list) {
  std::string text = "[axis]\n";
  for (Entry const& entry : list.entries) text += entry.name + " = " + entry.value + "\n";
  return text;
}

std::string as_device_tree(GeneratedList const& list) {
  Node root;
  for (Entry const& entry : list.entries) {
    Node* node = &root;
    std::string_view rest = entry.name;
    for (std::size_t dot = rest.find('.'); dot != std::string_view::npos; dot = rest.find('.')) {
      std::unique_ptr<Node>& child = node->children[node_name(rest.substr(0, dot))];
      if (!child) child = std::make_unique<Node>();
      node = child.get();
      rest.remove_prefix(dot + 1);
    }
    node->properties.push_back({.name = node_name(rest), .value = entry.value, .kind = entry.kind});
  }
  std::string text = "/dts-v1/;\n\n/ {\n";
  write_node(root, "\t", text);
  return text + "};\n";
}

}  // namespace axisc::bench
