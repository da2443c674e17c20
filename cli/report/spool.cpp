#include "cli/report/spool.hpp"

#include "cli/codes.hpp"
#include "cli/failure.hpp"
#include "cli/sentences.hpp"
#include "system/path.hpp"

#include <cstring>
#include <filesystem>

namespace axisc::cli {

namespace {

constexpr std::size_t most_in_memory = std::size_t{8} << 20U;
constexpr std::size_t block_size = std::size_t{1} << 20U;

struct Header {
  std::uint64_t mark = 0;
  std::uint64_t size = 0;
};

[[noreturn]] void fail(std::string const& place, system::Error const& error) {
  throw Failure(
      {.sentence = says::cannot_write, .arguments = {{"file", place}, {"reason", system::text_of(error)}}},
      cannot_write);
}

std::string temporary_folder() {
  std::error_code error;
  auto const folder = std::filesystem::temp_directory_path(error);
  return error ? "/tmp" : system::name_of(folder);
}

system::File open_nameless() {
  auto const folder = temporary_folder();
  auto opened = system::File::nameless(folder);
  if (auto const* const error = std::get_if<system::Error>(&opened)) fail(folder, *error);
  return std::get<system::File>(std::move(opened));
}

/// Passes on the complete entries at the beginning of `bytes`; returns their length.
std::size_t replay_entries(std::string_view bytes,
                           std::function<void(std::uint64_t, std::string_view)> const& take) {
  std::size_t at = 0;
  while (bytes.size() - at >= sizeof(Header)) {
    Header header;
    std::memcpy(&header, bytes.data() + at, sizeof(header));
    if (bytes.size() - at - sizeof(header) < header.size) break;
    take(header.mark, bytes.substr(at + sizeof(header), header.size));
    at += sizeof(header) + header.size;
  }
  return at;
}

}  // namespace

void Spool::add(std::uint64_t mark, std::string_view text) {
  // Reserved at once: memory that is never written costs nothing, while growth by doubling copies everything
  // repeatedly.
  if (buffer_.capacity() < most_in_memory) buffer_.reserve(most_in_memory + block_size);
  Header const header{.mark = mark, .size = text.size()};
  buffer_.append(reinterpret_cast<char const*>(&header), sizeof(header)).append(text);
  if (buffer_.size() >= most_in_memory) spill();
}

void Spool::spill() {
  if (!file_.is_open()) file_ = open_nameless();
  if (auto const error = file_.write(buffer_)) fail(temporary_folder(), *error);
  buffer_.clear();
}

void Spool::replay(std::function<void(std::uint64_t, std::string_view)> const& take) {
  if (file_.is_open()) {
    spill();
    if (auto const error = file_.rewind()) fail(temporary_folder(), *error);
    std::string block(block_size, '\0');
    while (true) {
      auto const result = file_.read(block);
      if (auto const* const error = std::get_if<system::Error>(&result)) fail(temporary_folder(), *error);
      auto const got = std::get<std::size_t>(result);
      if (got == 0) break;
      buffer_.append(block, 0, got);
      buffer_.erase(0, replay_entries(buffer_, take));
    }
  }
  static_cast<void>(replay_entries(buffer_, take));
}

}  // namespace axisc::cli
