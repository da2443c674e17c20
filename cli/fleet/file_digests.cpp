#include "cli/fleet/file_digests.hpp"

#include "cli/files/output_file.hpp"
#include "system/file.hpp"
#include "system/path.hpp"
#include "validator/loading/loader.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

namespace axisc::cli {

namespace {

constexpr std::string_view magic = "axfiles1";
constexpr std::int64_t second = 1'000'000'000;
constexpr std::int64_t racy = 2 * second;
constexpr std::int64_t day = 86'400 * second;
/// 80 MB; the least recently used rows are dropped.
constexpr std::size_t most_rows = 1'000'000;

using Row = FileDigests::Row;
static_assert(std::is_trivially_copyable_v<Row>);

bool by_path(Row const& left, Row const& right) {
  return left.path < right.path;
}

constexpr std::size_t head = magic.size() + sizeof(std::uint64_t);

/// None for a link, a pipe, a device, and a file that is too large for a table.
std::optional<std::string> bytes_of_table(std::string const& table) {
  auto const opened = system::File::open(table, system::Access::read_now, system::Link::refused);
  auto const* const file = std::get_if<system::File>(&opened);
  if (file == nullptr) return std::nullopt;
  auto const status = file->status();
  auto const* const facts = std::get_if<system::FileStatus>(&status);
  bool const fits = facts != nullptr && facts->kind == system::FileKind::regular &&
                    facts->size <= head + most_rows * sizeof(Row);
  if (!fits) return std::nullopt;
  std::string bytes(static_cast<std::size_t>(facts->size), '\0');
  for (std::size_t filled = 0; filled < bytes.size();) {
    auto const result = file->read(std::span(bytes).subspan(filled));
    auto const* const got = std::get_if<std::size_t>(&result);
    if (got == nullptr || *got == 0) return std::nullopt;
    filled += *got;
  }
  return bytes;
}

/// The rows of a table, in ascending order; none if it is damaged.
std::vector<Row> read_rows(std::string const& table) {
  auto const bytes = bytes_of_table(table);
  if (!bytes || bytes->size() < head || !bytes->starts_with(magic)) return {};
  auto const content = std::string_view(*bytes).substr(head);
  std::uint64_t checksum = 0;
  std::memcpy(&checksum, bytes->data() + magic.size(), sizeof(checksum));
  if (content.size() % sizeof(Row) != 0 || digest_of(content).low != checksum) return {};
  std::vector<Row> rows(content.size() / sizeof(Row));
  if (!rows.empty()) std::memcpy(static_cast<void*>(rows.data()), content.data(), content.size());
  return rows;
}

/// Both in ascending order; of two rows for one path the second one counts.
std::vector<Row> merged(std::vector<Row> const& older, std::vector<Row> const& newer) {
  std::vector<Row> rows;
  rows.reserve(older.size() + newer.size());
  auto next = newer.begin();
  for (auto const& row : older) {
    for (; next != newer.end() && next->path < row.path; ++next) rows.push_back(*next);
    if (next == newer.end() || row.path < next->path) rows.push_back(row);
  }
  rows.insert(rows.end(), next, newer.end());
  return rows;
}

void drop_oldest(std::vector<Row>& rows) {
  if (rows.size() <= most_rows) return;
  auto const keep = rows.begin() + static_cast<std::ptrdiff_t>(most_rows);
  std::nth_element(rows.begin(), keep, rows.end(),
                   [](Row const& left, Row const& right) { return left.seen > right.seen; });
  rows.erase(keep, rows.end());
  std::sort(rows.begin(), rows.end(), by_path);
}

}  // namespace

std::optional<FileFacts> facts_of(std::string const& path) {
  auto const status = system::status_of(path);
  auto const* const facts = std::get_if<system::FileStatus>(&status);
  if (facts == nullptr || facts->kind != system::FileKind::regular) return std::nullopt;
  return FileFacts{.device = facts->device,
                   .inode = facts->inode,
                   .size = facts->size,
                   .changed = facts->content_changed,
                   .inode_changed = facts->status_changed};
}

std::int64_t nanoseconds_now() {
  return std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count();
}

FileDigests::FileDigests(std::string table) : table_(std::move(table)), rows_(read_rows(table_)) {
  std::error_code error;
  working_folder_ = system::name_of(std::filesystem::current_path(error));
}

Digest FileDigests::key_of(std::string const& path) const {
  return digest_of(validator::is_absolute(path) ? path : working_folder_ + "/" + path);
}

std::optional<Digest> FileDigests::known(std::string const& path, FileFacts const& facts) {
  Row wanted{.path = key_of(path), .facts = {}, .digest = {}};
  auto const row = std::lower_bound(rows_.begin(), rows_.end(), wanted, by_path);
  if (row == rows_.end() || row->path != wanted.path || row->facts != facts) return std::nullopt;
  if (auto const now = nanoseconds_now(); now - row->seen > day) {
    wanted = *row;
    wanted.seen = now;
    std::lock_guard const lock(mutex_);
    learned_.push_back(wanted);
  }
  return row->digest;
}

void FileDigests::learn(std::string const& path, FileFacts const& facts, std::int64_t begun,
                        Digest const& digest) {
  if (std::max(facts.changed, facts.inode_changed) + racy > begun) return;
  Row const row{.path = key_of(path), .facts = facts, .digest = digest, .seen = begun};
  std::lock_guard const lock(mutex_);
  learned_.push_back(row);
}

void FileDigests::save() {
  if (learned_.empty()) return;
  // Several inputs may have read one file.
  std::stable_sort(learned_.begin(), learned_.end(), by_path);
  auto const is_same = [](Row const& left, Row const& right) { return left.path == right.path; };
  learned_.erase(std::unique(learned_.begin(), learned_.end(), is_same), learned_.end());
  // Another process may have saved meanwhile.
  auto rows = merged(read_rows(table_), learned_);
  drop_oldest(rows);
  std::string_view const content(reinterpret_cast<char const*>(rows.data()), rows.size() * sizeof(Row));
  auto const checksum = digest_of(content).low;
  OutputFile file(table_, Durability::of_name);
  file.write(magic);
  file.write({reinterpret_cast<char const*>(&checksum), sizeof(checksum)});
  file.write(content);
  file.commit();
  learned_.clear();
}

}  // namespace axisc::cli
