// Open documents take the place of the files on the disk.
#pragma once

#include "axisc/workspace/asked_files.hpp"
#include "configuration/files.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace axisc {

struct OpenDocument {
  std::string uri;   ///< as the client writes it
  std::string path;  ///< normalised
  std::string text;  ///< UTF-8
  std::optional<std::int64_t> version = {};
};

using OpenDocuments = std::map<std::string, OpenDocument>;  ///< by URI

/// The open documents by their paths: made where one is opened or closed, not for each question.
struct OpenPaths {
  explicit OpenPaths(OpenDocuments const& documents);

  std::map<std::string, OpenDocument const*> by_path;
  std::multimap<std::string, OpenDocument const*> by_name;   ///< the last part of the path
  std::map<std::string, std::vector<std::string>> names_in;  ///< by folder, with `/` at the end
};

class Buffers final : public configuration::Files {
 public:
  /// Both must outlive this object; the documents do not change meanwhile.
  Buffers(OpenDocuments const& documents, configuration::Files& disk)
      : Buffers(std::make_shared<OpenPaths const>(documents), disk) {}
  Buffers(std::shared_ptr<OpenPaths const> open, configuration::Files& disk)
      : disk_(disk), open_(std::move(open)) {}

  /// The open document of a file, however its path is written; null for others.
  [[nodiscard]] OpenDocument const* document(std::string const& path) const;
  /// The URI of the open document, as the client writes it, otherwise one of the path.
  [[nodiscard]] std::string uri(std::string const& path) const;
  /// Whether the document's text has been read.
  [[nodiscard]] bool has_read(OpenDocument const& document) const { return read_.contains(&document); }
  /// The same files, without a record of what was asked for.
  [[nodiscard]] Buffers anew() const { return {open_, disk_}; }
  /// The files that were asked for, whether they exist or not.
  [[nodiscard]] AskedFiles const& asked() const { return asked_; }

  [[nodiscard]] std::variant<std::string, configuration::FileError> read(std::string const& path) override;
  [[nodiscard]] std::optional<configuration::FileError> read_pieces(
      std::string const& path, configuration::PieceReceiver const& receive) override;
  [[nodiscard]] bool is_file(std::string const& path) override;
  [[nodiscard]] std::vector<std::string> names_in(std::string const& folder) override;
  [[nodiscard]] bool is_same(std::string const& one, std::string const& other) override;

 private:
  configuration::Files& disk_;
  std::shared_ptr<OpenPaths const> open_;
  std::set<OpenDocument const*> read_;
  mutable AskedFiles asked_;
};

}  // namespace axisc
