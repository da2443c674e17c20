// A POSIX file descriptor that is closed once.
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

namespace axisc::cli {

class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int number) : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  FileDescriptor(FileDescriptor const&) = delete;
  FileDescriptor& operator=(FileDescriptor const&) = delete;
  ~FileDescriptor();

  [[nodiscard]] int get() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  /// 0, or the error number: network file systems report a full disk only here.
  [[nodiscard]] int close();

 private:
  int number_ = -1;
};

/// Writes all of `bytes`; 0, or the error number.
[[nodiscard]] int write_all(int descriptor, std::string_view bytes);

/// Standard input, output and error are open from here on, so that no file takes the place of one that the caller
/// closed; writing to a replaced one fails like writing to the closed one.
void occupy_standard_descriptors();

}  // namespace axisc::cli
