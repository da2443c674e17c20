#include "cli/located_file.hpp"

#include "cli/disk_files.hpp"
#include "cli/failure.hpp"

#include <utility>
#include <variant>

namespace axisc::cli {

LocatedFile::LocatedFile(std::string path, Text malformed)
    : path_(std::move(path)), source_(path_, read_whole(path_, Dash::is_a_name)) {
  auto parsed = validator::parse_json(source_.bytes().substr(source_.text_begin()), source_.text_begin());
  if (auto const* const error = std::get_if<validator::JsonError>(&parsed)) refuse(error->span, malformed);
  document_ = std::get<validator::JsonDocument>(std::move(parsed));
}

std::string const& LocatedFile::text(validator::JsonValue const& value) const {
  if (value.kind != validator::JsonKind::string) refuse(value.span, Text::settings_text);
  return value.string;
}

void LocatedFile::refuse(Span span, Text what, std::vector<Argument> arguments) const {
  auto const place = source_.position(span.begin);
  arguments.push_back(
      {"place", path_ + ":" + std::to_string(place.line) + ":" + std::to_string(place.column)});
  throw Failure({.text = what, .arguments = std::move(arguments)});
}

}  // namespace axisc::cli
