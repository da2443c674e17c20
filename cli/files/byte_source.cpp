#include "cli/files/byte_source.hpp"

#include "cli/codes.hpp"
#include "cli/failure.hpp"
#include "cli/sentences.hpp"
#include "system/file.hpp"

#include <memory>
#include <utility>
#include <variant>

namespace axisc::cli {

ByteSource open_source(std::string const& path) {
  auto const fail = [path](system::Error const& error) {
    throw Failure(
        {.sentence = says::cannot_read, .arguments = {{"file", path}, {"reason", system::text_of(error)}}},
        cannot_read);
  };
  auto opened = path == "-" ? system::File::standard_input() : system::File::open(path, system::Access::read);
  if (auto const* const error = std::get_if<system::Error>(&opened)) fail(*error);
  auto file = std::make_shared<system::File>(std::get<system::File>(std::move(opened)));
  return [file = std::move(file), fail](std::span<char> buffer) -> std::size_t {
    auto const got = file->read(buffer);
    if (auto const* const error = std::get_if<system::Error>(&got)) fail(*error);
    return std::get<std::size_t>(got);
  };
}

}  // namespace axisc::cli
