#include "cli/fleet/recorded_files.hpp"

#include <utility>

namespace axisc::cli {

namespace {

/// Larger files (NC programs) are hashed piece by piece and read twice.
constexpr std::uint64_t most_kept = std::uint64_t{16} << 20U;

}  // namespace

class RecordedFiles::Reading {
 public:
  Reading(FileDigests* digests, std::string const& path)
      : digests_(digests), path_(path), begun_(nanoseconds_now()), before_(facts_of(path)) {}

  void learn(Digest const& digest) const {
    if (digests_ != nullptr && before_ && before_ == facts_of(path_)) {
      digests_->learn(path_, *before_, begun_, digest);
    }
  }

 private:
  FileDigests* digests_;
  std::string const& path_;
  std::int64_t begun_;
  std::optional<FileFacts> before_;
};

void RecordedFiles::record(std::string const& path, FileState const& state) {
  auto const [known, is_new] = dependencies_.emplace(path, state);
  if (!is_new && known->second != state) complete_ = false;
}

std::variant<std::string, configuration::FileError> RecordedFiles::read(std::string const& path) {
  if (auto const kept = kept_.find(path); kept != kept_.end()) {
    auto bytes = std::move(kept->second);
    kept_.erase(kept);
    record(path, {.digest = digest_of(bytes), .error = {}});
    return bytes;
  }
  Reading const reading(digests_, path);
  auto bytes = disk_.read(path);
  if (auto const* const error = std::get_if<configuration::FileError>(&bytes)) {
    record(path, {.digest = {}, .error = *error});
    return bytes;
  }
  auto const digest = digest_of(std::get<std::string>(bytes));
  record(path, {.digest = digest, .error = {}});
  reading.learn(digest);
  return bytes;
}

std::optional<configuration::FileError> RecordedFiles::read_pieces(
    std::string const& path, configuration::PieceReceiver const& receive) {
  Reading const reading(digests_, path);
  Hasher hasher;
  bool wanted = true;
  auto const error = disk_.read_pieces(path, [&](std::string_view piece) {
    hasher.bytes(piece);
    // The rest is read only for the digest.
    wanted = wanted && receive(piece);
    return true;
  });
  auto const digest = error ? Digest{} : hasher.finish();
  record(path, {.digest = digest, .error = error});
  if (!error) reading.learn(digest);
  return error;
}

FileState RecordedFiles::state_of(std::string const& path) {
  auto const facts = facts_of(path);
  if (facts && digests_ != nullptr) {
    if (auto const digest = digests_->known(path, *facts)) return {.digest = *digest, .error = {}};
  }
  Reading const reading(digests_, path);
  if (!facts || facts->size <= most_kept) {
    auto bytes = disk_.read(path);
    if (auto const* const error = std::get_if<configuration::FileError>(&bytes)) {
      return {.digest = {}, .error = *error};
    }
    auto const digest = digest_of(std::get<std::string>(bytes));
    reading.learn(digest);
    kept_.insert_or_assign(path, std::get<std::string>(std::move(bytes)));
    return {.digest = digest, .error = {}};
  }
  Hasher hasher;
  auto const error = disk_.read_pieces(path, [&hasher](std::string_view piece) {
    hasher.bytes(piece);
    return true;
  });
  if (error) return {.digest = {}, .error = error};
  auto const digest = hasher.finish();
  reading.learn(digest);
  return {.digest = digest, .error = {}};
}

}  // namespace axisc::cli
