#include "axisc/checking/depfile.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"

namespace axisc::says {

constexpr Sentence line_break_in_name{
    "the name {file} has a line break, which a dependency file cannot express; rename the file",
    "der Name {file} enthält einen Zeilenumbruch, den keine Abhängigkeitsdatei ausdrücken kann; die Datei "
    "umbenennen"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::string escaped(std::string_view name) {
  if (name.find_first_of("\r\n") != std::string_view::npos) {
    throw Failure({says::line_break_in_name, {{"file", std::string(name)}}}, cannot_write);
  }
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

}  // namespace axisc
