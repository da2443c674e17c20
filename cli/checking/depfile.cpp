#include "cli/checking/depfile.hpp"

namespace axisc::cli {

namespace {

std::string escaped(std::string_view name) {
  std::string result;
  for (char const character : name) {
    if (character == ' ' || character == '#' || character == ':') result += '\\';
    if (character == '$') result += '$';
    result += character;
  }
  return result;
}

}  // namespace

std::string dependency_rule(std::string_view target, std::vector<std::string> const& sources) {
  std::string rule = escaped(target) + ":";
  for (auto const& source : sources) {
    if (source != "-") rule += " \\\n  " + escaped(source);
  }
  return rule + "\n";
}

}  // namespace axisc::cli
