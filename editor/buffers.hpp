// Open documents take the place of the files on the disk.
#pragma once

#include "configuration/files.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace axisc::editor {

struct Document {
  std::string uri;   ///< as the client writes it
  std::string path;  ///< normalised
  std::string text;  ///< UTF-8
  std::optional<std::int64_t> version = {};
};

using Documents = std::map<std::string, Document>;  ///< by URI

class Buffers final : public configuration::Files {
 public:
  /// Both outlive this object; the documents do not change meanwhile.
  Buffers(Documents const& documents, configuration::Files& disk);

  /// The open document of a file, however its path is written; null for others.
  [[nodiscard]] Document const* document(std::string const& path) const;
  /// That of the open document, as the client writes it, else one of the path.
  [[nodiscard]] std::string uri(std::string const& path) const;
  /// Its text was given out.
  [[nodiscard]] bool has_read(Document const& document) const { return read_.contains(&document); }

  [[nodiscard]] std::variant<std::string, configuration::FileError> read(std::string const& path) override;
  [[nodiscard]] std::optional<configuration::FileError> read_pieces(
      std::string const& path, configuration::PieceReceiver const& receive) override;
  [[nodiscard]] bool is_file(std::string const& path) override;
  [[nodiscard]] std::vector<std::string> names_in(std::string const& folder) override;
  [[nodiscard]] bool is_same(std::string const& one, std::string const& other) override;

 private:
  configuration::Files& disk_;
  std::map<std::string, Document const*> by_path_;
  std::multimap<std::string, Document const*> by_name_;  ///< the last part of the path
  std::set<Document const*> read_;
};

}  // namespace axisc::editor
