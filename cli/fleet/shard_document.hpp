// The result of a shard, as `axisc lint --shard` wrote it.
#pragma once

#include "cli/checking/checked_input.hpp"
#include "cli/fleet/shard_record.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace axisc::cli {

class ShardDocument {
 public:
  /// Failure for a file that cannot be read or is not a complete result of a shard.
  explicit ShardDocument(std::string const& file);

  [[nodiscard]] std::string const& file() const { return file_; }
  [[nodiscard]] FindingFormat format() const { return format_; }
  [[nodiscard]] ShardRecord const& record() const { return record_; }
  [[nodiscard]] Language language() const { return language_; }
  [[nodiscard]] bool has_statistics() const { return has_statistics_; }

  /// The result of the input at `index` of the record's inputs; call it with rising indices.
  [[nodiscard]] CheckedInput next_input(std::size_t index);

 private:
  void read_json();
  void read_sarif(std::string_view runs);
  void read_record(std::string_view json);
  [[noreturn]] void refuse(SentenceRef reason) const;

  std::string file_;
  std::string bytes_;
  FindingFormat format_ = FindingFormat::json;
  ShardRecord record_;
  Language language_ = Language::english;
  bool has_statistics_ = false;
  std::vector<std::string_view> elements_;
  std::size_t next_element_ = 0;
  std::vector<Artifact> artifacts_;
};

}  // namespace axisc::cli
