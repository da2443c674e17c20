#include "image/fmu/zip_archive.hpp"

#include <algorithm>
#include <cstdint>
#include <zlib.h>

namespace axisc::image {

namespace {

constexpr std::uint16_t version = 20;  // of the format that is needed: deflate
constexpr std::uint16_t stored = 0, deflated = 8;
constexpr std::uint16_t first_day = 0x21;  // 1980-01-01
constexpr int memory_level = 6;            // more of it makes longer blocks, which pack libraries worse

void put16(std::string& bytes, std::size_t value) {
  bytes += static_cast<char>(value & 0xFFU);
  bytes += static_cast<char>(value >> 8U & 0xFFU);
}

void put32(std::string& bytes, std::size_t value) {
  put16(bytes, value & 0xFFFFU);
  put16(bytes, value >> 16U);
}

std::string deflated_bytes(std::string const& content) {
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, -MAX_WBITS, memory_level, Z_DEFAULT_STRATEGY);
  std::string bytes(deflateBound(&stream, static_cast<uLong>(content.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));  // zlib does not write there
  stream.avail_in = static_cast<uInt>(content.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return bytes;
}

struct Entry {
  std::string fields;  ///< which local header and directory have alike
  std::string data;
};

Entry entry_of(ExportedFile const& file) {
  Entry entry{.fields = {}, .data = deflated_bytes(file.content)};
  bool const is_smaller = entry.data.size() < file.content.size();
  if (!is_smaller) entry.data = file.content;
  auto const* const content = reinterpret_cast<Bytef const*>(file.content.data());
  put16(entry.fields, version);
  put16(entry.fields, 0);
  put16(entry.fields, is_smaller ? deflated : stored);
  put16(entry.fields, 0);
  put16(entry.fields, first_day);
  put32(entry.fields, crc32(crc32(0, nullptr, 0), content, static_cast<uInt>(file.content.size())));
  put32(entry.fields, entry.data.size());
  put32(entry.fields, file.content.size());
  put16(entry.fields, file.name.size());
  put16(entry.fields, 0);
  return entry;
}

}  // namespace

std::string zip_archive(std::vector<ExportedFile> files) {
  std::sort(files.begin(), files.end(),
            [](ExportedFile const& a, ExportedFile const& b) { return a.name < b.name; });
  std::string archive, directory;
  for (auto const& file : files) {
    auto const entry = entry_of(file);
    directory += "PK\1\2";
    put16(directory, version);
    directory += entry.fields;
    directory.append(10, '\0');  // comment, disk, attributes
    put32(directory, archive.size());
    directory += file.name;
    archive += "PK\3\4" + entry.fields + file.name + entry.data;
  }
  auto const begin = archive.size();
  archive += directory + "PK\5\6";
  put32(archive, 0);
  put16(archive, files.size());
  put16(archive, files.size());
  put32(archive, directory.size());
  put32(archive, begin);
  put16(archive, 0);
  return archive;
}

}  // namespace axisc::image
