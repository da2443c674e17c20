#include "axisc/interface/provided_files.hpp"

#include <string_view>

namespace axisc::interface {

namespace {

using configuration::FileError;

/// What a function gave, freed with this object.
struct GivenBytes {
  axisc_bytes bytes{.data = nullptr, .size = 0};
  GivenBytes() = default;
  GivenBytes(GivenBytes const&) = delete;
  GivenBytes& operator=(GivenBytes const&) = delete;
  ~GivenBytes() { axisc_free(&bytes); }
  [[nodiscard]] std::string_view text() const {
    return bytes.data == nullptr ? std::string_view() : std::string_view(bytes.data, bytes.size);
  }
};

}  // namespace

ProvidedFiles::Given const& ProvidedFiles::given(std::string const& path) {
  stop_if_cancelled();
  auto const [known, is_new] = given_.try_emplace(path, FileError::not_readable);
  if (!is_new) return known->second;
  GivenBytes file;
  auto const result = from_.read(from_.context, path.c_str(), &file.bytes);
  if (result == AXISC_OK && file.bytes.size > configuration::largest_file) {
    known->second = FileError::too_large;
  } else if (result == AXISC_OK) {
    known->second = std::string(file.text());
  } else if (result == AXISC_NOT_FOUND) {
    known->second = FileError::not_found;
  }
  stop_if_cancelled();
  return known->second;
}

std::variant<std::string, FileError> ProvidedFiles::read(std::string const& path) {
  if (from_.read != nullptr) return given(path);
  stop_if_cancelled();
  return disk_.read(path);
}

std::optional<FileError> ProvidedFiles::read_pieces(std::string const& path,
                                                    configuration::PieceReceiver const& receive) {
  if (from_.read != nullptr) return Files::read_pieces(path, receive);
  return disk_.read_pieces(path, [&](std::string_view piece) {
    stop_if_cancelled();
    return receive(piece);
  });
}

bool ProvidedFiles::is_file(std::string const& path) {
  if (from_.read != nullptr) return std::holds_alternative<std::string>(given(path));
  stop_if_cancelled();
  return disk_.is_file(path);
}

std::vector<std::string> ProvidedFiles::names_in(std::string const& folder) {
  stop_if_cancelled();
  if (from_.read == nullptr) return disk_.names_in(folder);
  std::vector<std::string> names;
  if (from_.list == nullptr) return names;
  GivenBytes all;
  if (from_.list(from_.context, folder.c_str(), &all.bytes) != AXISC_OK) return names;
  for (auto rest = all.text(); !rest.empty();) {
    auto const end = std::min(rest.find('\0'), rest.size());
    if (end > 0) names.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return names;
}

bool ProvidedFiles::is_same(std::string const& one, std::string const& other) {
  return from_.read == nullptr ? disk_.is_same(one, other) : Files::is_same(one, other);
}

}  // namespace axisc::interface
