#include "cli/fleet/cache_store.hpp"
#include "system/folder.hpp"

#include <algorithm>
#include <memory>
#include <set>

namespace axisc::cli {

namespace {

constexpr std::uint64_t small_pack = std::uint64_t{8} << 20U;

struct Entry {
  std::size_t pack = 0;
  std::size_t row = 0;
  std::uint32_t last_use = 0;
  std::uint64_t size = 0;
};

/// Every entry of the packs once, most recently used first. A time in the future does not count.
std::vector<Entry> entries_of(std::vector<CachePack> const& packs) {
  auto const now = seconds_now();
  std::set<Digest> known;
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < packs.size(); ++i) {
    for (std::size_t row = 0; row < packs[i].rows().size(); ++row) {
      if (!known.insert(packs[i].rows()[row].key).second) continue;
      auto const used = packs[i].last_use(row);
      entries.push_back({.pack = i,
                         .row = row,
                         .last_use = used <= now ? used : 0,
                         .size = packs[i].rows()[row].size + sizeof(PackRow) + sizeof(std::uint32_t)});
    }
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](Entry const& left, Entry const& right) { return left.last_use > right.last_use; });
  return entries;
}

/// The rows to keep, by pack.
std::vector<std::vector<std::size_t>> choose(std::vector<CachePack> const& packs, std::uint64_t limit) {
  std::vector<std::vector<std::size_t>> kept(packs.size());
  std::uint64_t size = 0;
  for (auto const& entry : entries_of(packs)) {
    size += entry.size;
    if (size > limit) break;
    kept[entry.pack].push_back(entry.row);
  }
  return kept;
}

/// Packs that lose entries, and small packs, are rewritten as few.
void rewrite(std::string const& folder, std::vector<CachePack> const& packs,
             std::vector<std::vector<std::size_t>> const& kept) {
  std::vector<std::size_t> replaced;
  std::unique_ptr<PackWriter> writer;
  for (std::size_t i = 0; i < packs.size(); ++i) {
    bool const is_whole = kept[i].size() == packs[i].rows().size();
    if (is_whole && packs[i].file_size() > small_pack) continue;
    replaced.push_back(i);
    for (auto const row : kept[i]) {
      auto const content = packs[i].read(row);
      if (!content) continue;
      if (!writer) writer = std::make_unique<PackWriter>(folder);
      writer->add(packs[i].rows()[row].key, *content, packs[i].last_use(row));
      if (!writer->is_full()) continue;
      writer->commit();
      writer.reset();
    }
  }
  if (writer) writer->commit();
  for (auto const i : replaced) system::remove(packs[i].path());
}

/// Removes files of killed processes and unreadable packs.
void remove_rubbish(std::string const& folder, std::vector<CachePack> const& packs) {
  std::set<std::string> whole;
  for (auto const& pack : packs) whole.insert(pack.path());
  constexpr std::int64_t day = 86'400;
  std::int64_t const yesterday = std::int64_t{seconds_now()} - day;
  auto const entries = system::entries_of(folder);
  auto const* const found = std::get_if<std::vector<system::FolderEntry>>(&entries);
  if (found == nullptr) return;
  for (auto const& entry : *found) {
    auto const path = system::name_in(folder, entry.name);
    bool const is_damaged = entry.name.ends_with(pack_extension) && !whole.contains(path);
    auto const status = system::status_of(path, system::Link::refused);
    auto const* const facts = std::get_if<system::FileStatus>(&status);
    bool const is_left = entry.name.starts_with(".axisc-") && facts != nullptr &&
                         facts->content_changed / 1'000'000'000 < yesterday;
    if (is_damaged || is_left) system::remove(path);
  }
}

}  // namespace

void tidy_cache(std::string const& folder, std::uint64_t limit) {
  auto const opened = system::File::open_or_create(folder + "/lock");
  auto const* const lock = std::get_if<system::File>(&opened);
  if (lock == nullptr || !is_regular(*lock) || !lock->lock()) return;
  auto const packs = open_packs(folder);
  remove_rubbish(folder, packs);
  std::uint64_t size = 0;
  for (auto const& pack : packs) size += pack.file_size();
  rewrite(folder, packs, choose(packs, size > limit ? limit / 4 * 3 : limit));
}

}  // namespace axisc::cli
