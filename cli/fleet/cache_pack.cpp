#include "cli/fleet/cache_pack.hpp"

#include "cli/fleet/unique_name.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

namespace axisc::cli {

namespace {

constexpr std::string_view magic = "axpack01";
/// Larger files are not the cache's: a writer begins a new pack at `full_pack`, and entries are results of one input.
constexpr std::uint64_t largest_pack = std::uint64_t{1} << 30U;
constexpr std::uint64_t most_rows = std::uint64_t{1} << 21U;
constexpr std::size_t buffered = std::size_t{1} << 18U;

struct Footer {
  std::uint64_t rows = 0;
  std::uint64_t table_begin = 0;
  std::uint64_t checksum = 0;
  char mark[8] = {'a', 'x', 'p', 'k', 'e', 'n', 'd', '1'};
};

static_assert(std::is_trivially_copyable_v<PackRow>);

bool read_at(system::File const& file, std::uint64_t offset, void* target, std::size_t size) {
  auto* next = static_cast<char*>(target);
  while (size > 0) {
    auto const result = file.read_at(offset, {next, size});
    auto const* const got = std::get_if<std::size_t>(&result);
    if (got == nullptr || *got == 0) return false;
    next += *got;
    offset += *got;
    size -= *got;
  }
  return true;
}

/// For reading, and for updating the times of last use if the file is writable.
std::optional<system::File> open_pack(std::string const& path) {
  for (auto const access : {system::Access::update_now, system::Access::read_now}) {
    auto opened = system::File::open(path, access, system::Link::refused);
    if (auto* const file = std::get_if<system::File>(&opened)) return std::move(*file);
  }
  return std::nullopt;
}

std::string_view bytes_of(std::vector<PackRow> const& rows) {
  return {reinterpret_cast<char const*>(rows.data()), rows.size() * sizeof(PackRow)};
}

}  // namespace

std::optional<CachePack> CachePack::open(std::string const& path) {
  CachePack pack;
  pack.path_ = path;
  auto file = open_pack(path);
  if (!file) return std::nullopt;
  pack.file_ = std::move(*file);
  auto const status = pack.file_.status();
  auto const* const facts = std::get_if<system::FileStatus>(&status);
  if (facts == nullptr || facts->kind != system::FileKind::regular) return std::nullopt;
  pack.file_size_ = facts->size;
  Footer footer;
  if (pack.file_size_ < magic.size() + sizeof(Footer) || pack.file_size_ > largest_pack) return std::nullopt;
  auto const end = pack.file_size_ - sizeof(Footer);
  if (!read_at(pack.file_, end, &footer, sizeof(footer))) return std::nullopt;
  constexpr std::uint64_t per_row = sizeof(PackRow) + sizeof(std::uint32_t);
  bool const fits = std::memcmp(footer.mark, Footer{}.mark, sizeof(footer.mark)) == 0 &&
                    footer.rows <= most_rows && footer.table_begin >= magic.size() &&
                    footer.table_begin <= end && (end - footer.table_begin) % per_row == 0 &&
                    (end - footer.table_begin) / per_row == footer.rows;
  if (!fits) return std::nullopt;
  pack.rows_.resize(footer.rows);
  pack.last_uses_.resize(footer.rows);
  pack.uses_begin_ = footer.table_begin + footer.rows * sizeof(PackRow);
  if (!read_at(pack.file_, footer.table_begin, pack.rows_.data(), footer.rows * sizeof(PackRow)) ||
      !read_at(pack.file_, pack.uses_begin_, pack.last_uses_.data(), footer.rows * sizeof(std::uint32_t)) ||
      digest_of(bytes_of(pack.rows_)).low != footer.checksum) {
    return std::nullopt;
  }
  bool const inside = std::all_of(pack.rows_.begin(), pack.rows_.end(), [&](PackRow const& row) {
    return row.offset <= footer.table_begin && row.size <= footer.table_begin - row.offset;
  });
  return inside ? std::optional(std::move(pack)) : std::nullopt;
}

std::optional<std::string> CachePack::read(std::size_t row) const {
  auto const& place = rows_[row];
  std::string content(place.size, '\0');
  if (!read_at(file_, place.offset, content.data(), content.size())) return std::nullopt;
  if (digest_of(content).low != place.checksum) return std::nullopt;
  return content;
}

void CachePack::mark_used(std::vector<std::uint32_t> const& rows, std::uint32_t now) {
  // Exact times do not matter, and most runs follow one another quickly.
  constexpr std::uint32_t minute = 60;
  bool changed = false;
  for (auto const row : rows) {
    if (last_uses_[row] + minute >= now && last_uses_[row] <= now) continue;
    last_uses_[row] = now;
    changed = true;
  }
  if (!changed) return;
  std::string_view const bytes(reinterpret_cast<char const*>(last_uses_.data()),
                               last_uses_.size() * sizeof(std::uint32_t));
  static_cast<void>(file_.write_at(uses_begin_, bytes));
}

PackWriter::PackWriter(std::string const& folder)
    : file_(folder + "/" + unique_name() + std::string(pack_extension), Durability::of_name),
      offset_(magic.size()),
      buffer_(magic) {}

void PackWriter::add(Digest const& key, std::string_view content, std::uint32_t last_use) {
  entries_.push_back(
      {.row = {.key = key, .offset = offset_, .size = content.size(), .checksum = digest_of(content).low},
       .last_use = last_use});
  offset_ += content.size();
  buffer_ += content;
  if (buffer_.size() < buffered) return;
  file_.write(buffer_);
  buffer_.clear();
}

void PackWriter::commit() {
  std::sort(entries_.begin(), entries_.end(),
            [](Entry const& left, Entry const& right) { return left.row.key < right.row.key; });
  std::vector<PackRow> rows;
  std::vector<std::uint32_t> uses;
  for (auto const& entry : entries_) {
    rows.push_back(entry.row);
    uses.push_back(entry.last_use);
  }
  Footer const footer{.rows = rows.size(), .table_begin = offset_, .checksum = digest_of(bytes_of(rows)).low};
  file_.write(buffer_);
  file_.write(bytes_of(rows));
  file_.write({reinterpret_cast<char const*>(uses.data()), uses.size() * sizeof(std::uint32_t)});
  file_.write({reinterpret_cast<char const*>(&footer), sizeof(footer)});
  file_.commit();
}

}  // namespace axisc::cli
