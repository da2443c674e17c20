#include "system/file.hpp"
#include "system/folder.hpp"

#include <algorithm>

namespace axisc::system {

std::optional<std::string> bytes_of(std::string const& path) {
  auto const opened = File::open(path, Access::read);
  auto const* const file = std::get_if<File>(&opened);
  if (file == nullptr) return std::nullopt;
  constexpr std::size_t piece = std::size_t{1} << 16U;
  std::string bytes;
  while (true) {
    std::size_t const filled = bytes.size();
    bytes.resize(filled + std::max(filled, piece));
    auto const got = file->read(std::span(bytes).subspan(filled));
    if (std::holds_alternative<Error>(got)) return std::nullopt;
    bytes.resize(filled + std::get<std::size_t>(got));
    if (std::get<std::size_t>(got) == 0) return bytes;
  }
}

std::string name_in(std::string const& folder, std::string const& name) {
  if (folder.empty()) return name;
  return folder.ends_with('/') ? folder + name : folder + "/" + name;
}

std::optional<FileKind> kind_of(std::string const& path, Link link) {
  auto const status = status_of(path, link);
  auto const* const facts = std::get_if<FileStatus>(&status);
  return facts != nullptr ? std::optional(facts->kind) : std::nullopt;
}

}  // namespace axisc::system
