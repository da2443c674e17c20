#include "axisc/files/byte_source.hpp"

#include "axisc/files/disk_files.hpp"
#include "system/file.hpp"

#include <memory>
#include <utility>
#include <variant>

namespace axisc {

ByteSource open_source(std::string const& path) {
  auto opened = path == "-" ? system::File::standard_input() : system::File::open(path, system::Access::read);
  if (auto const* const error = std::get_if<system::Error>(&opened)) throw unreadable(path, *error);
  auto file = std::make_shared<system::File>(std::get<system::File>(std::move(opened)));
  return [file = std::move(file), path](std::span<char> buffer) -> std::size_t {
    auto const got = file->read(buffer);
    if (auto const* const error = std::get_if<system::Error>(&got)) throw unreadable(path, *error);
    return std::get<std::size_t>(got);
  };
}

}  // namespace axisc
