#include "cli/fleet/cache_store.hpp"

#include "cli/codes.hpp"
#include "cli/failure.hpp"
#include "cli/sentences.hpp"
#include "system/folder.hpp"
#include "system/path.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

namespace axisc::cli {

namespace {

namespace fs = std::filesystem;

/// Limits the number of files that every run opens.
constexpr std::size_t most_packs = 64;

std::vector<std::string> names_of_packs(std::string const& folder) {
  std::vector<std::string> names;
  auto const entries = system::entries_of(folder);
  if (auto const* const found = std::get_if<std::vector<system::FolderEntry>>(&entries)) {
    for (auto const& entry : *found) {
      if (entry.name.ends_with(pack_extension)) names.push_back(system::name_in(folder, entry.name));
    }
  }
  return names;
}

}  // namespace

std::uint32_t seconds_now() {
  return static_cast<std::uint32_t>(
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
          .count());
}

std::vector<CachePack> open_packs(std::string const& folder) {
  std::vector<CachePack> packs;
  for (auto const& path : names_of_packs(folder)) {
    if (auto pack = CachePack::open(path)) packs.push_back(*std::move(pack));
  }
  return packs;
}

CacheStore::CacheStore(std::string folder, std::uint64_t limit) : folder_(std::move(folder)), limit_(limit) {
  std::error_code error;
  fs::create_directories(system::path_of(folder_), error);
  if (error) {
    throw Failure(
        {.sentence = says::cannot_write, .arguments = {{"file", folder_}, {"reason", error.message()}}},
        cannot_write);
  }
  packs_ = open_packs(folder_);
  used_.resize(packs_.size());
  std::size_t rows = 0;
  for (auto const& pack : packs_) rows += pack.rows().size();
  places_.reserve(rows);
  for (std::size_t i = 0; i < packs_.size(); ++i) {
    for (std::size_t row = 0; row < packs_[i].rows().size(); ++row) {
      places_.try_emplace(packs_[i].rows()[row].key,
                          Place{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(row)});
    }
  }
}

std::optional<std::string> CacheStore::find(Digest const& key) {
  auto const found = places_.find(key);
  if (found == places_.end()) return std::nullopt;
  auto const& place = found->second;
  auto content = packs_[place.pack].read(place.row);
  if (!content) return std::nullopt;
  std::lock_guard const lock(mutex_);
  used_[place.pack].push_back(place.row);
  return content;
}

void CacheStore::add(Digest const& key, std::string_view content) {
  std::lock_guard const lock(mutex_);
  if (broken_) return;
  try {
    if (!writer_) writer_ = std::make_unique<PackWriter>(folder_);
    writer_->add(key, content, seconds_now());
    if (!writer_->is_full()) return;
    writer_->commit();
  } catch (Failure const& failure) {
    // The results are correct nevertheless.
    broken_ = failure;
  }
  writer_.reset();
}

void CacheStore::finish() {
  if (broken_) throw Failure(*broken_);
  if (writer_) writer_->commit();
  writer_.reset();
  auto const now = seconds_now();
  std::uint64_t size = 0;
  for (std::size_t i = 0; i < packs_.size(); ++i) packs_[i].mark_used(used_[i], now);
  std::size_t packs = 0;
  for (auto const& path : names_of_packs(folder_)) {
    ++packs;
    auto const status = system::status_of(path);
    if (auto const* const facts = std::get_if<system::FileStatus>(&status)) size += facts->size;
  }
  if (size > limit_ || packs > most_packs) tidy_cache(folder_, limit_);
}

}  // namespace axisc::cli
