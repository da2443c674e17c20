// The files of one call: those of the disk, or what the caller's functions give.
#pragma once

#include "axisc/axisc.h"
#include "axisc/files/disk_files.hpp"

#include <atomic>
#include <map>

namespace axisc::interface {

/// Thrown where a cancelled call would read on.
struct Cancelled {};

/// Keeps what the functions gave, so that a file stays the same during the call.
class ProvidedFiles final : public configuration::Files {
 public:
  /// `from.read` null: the disk.
  ProvidedFiles(axisc_files const& from, std::atomic<bool> const& is_cancelled)
      : from_(from), is_cancelled_(is_cancelled) {}

  [[nodiscard]] std::variant<std::string, configuration::FileError> read(std::string const& path) override;
  [[nodiscard]] std::optional<configuration::FileError> read_pieces(
      std::string const& path, configuration::PieceReceiver const& receive) override;
  [[nodiscard]] bool is_file(std::string const& path) override;
  [[nodiscard]] std::vector<std::string> names_in(std::string const& folder) override;
  [[nodiscard]] bool is_same(std::string const& one, std::string const& other) override;

  void stop_if_cancelled() const {
    if (is_cancelled_) throw Cancelled();
  }

 private:
  using Given = std::variant<std::string, configuration::FileError>;
  [[nodiscard]] Given const& given(std::string const& path);

  axisc_files from_;
  std::atomic<bool> const& is_cancelled_;
  DiskFiles disk_;
  std::map<std::string, Given> given_;
};

}  // namespace axisc::interface
