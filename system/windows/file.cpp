#include "system/file.hpp"

#include "system/windows/error.hpp"
#include "system/windows/links.hpp"
#include "system/windows/wide.hpp"

#include <aclapi.h>
#include <algorithm>
#include <sddl.h>
#include <windows.h>

namespace axisc::system {
namespace {

constexpr DWORD share_everything = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
constexpr DWORD most_at_once = 1U << 30U;
/// Windows has no bits for groups; the access list defines what others may do.
constexpr unsigned permissions_of_owner = 0600;

HANDLE handle_of(std::intptr_t handle) {
  return reinterpret_cast<HANDLE>(handle);  // NOLINT(performance-no-int-to-ptr)
}

std::intptr_t number_of(HANDLE handle) {
  return reinterpret_cast<std::intptr_t>(handle);
}

FileKind kind_of(DWORD attributes) {
  return (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? FileKind::folder : FileKind::regular;
}

std::optional<Error> error_unless(bool good) {
  return good ? std::nullopt : std::optional(last_error());
}

OVERLAPPED place_at(std::uint64_t offset) {
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(offset);
  place.OffsetHigh = static_cast<DWORD>(offset >> 32U);
  return place;
}

Result<std::size_t> read_some(HANDLE file, std::span<char> buffer, OVERLAPPED* place) {
  DWORD got = 0;
  auto const wanted = static_cast<DWORD>(std::min<std::size_t>(buffer.size(), most_at_once));
  if (::ReadFile(file, buffer.data(), wanted, &got, place) != 0) return std::size_t{got};
  DWORD const error = ::GetLastError();
  if (error == ERROR_HANDLE_EOF || error == ERROR_BROKEN_PIPE) return std::size_t{0};
  // This is the error of reading a folder.
  if (error == ERROR_INVALID_FUNCTION) {
    return Error{.refusal = Refusal::is_folder, .number = static_cast<int>(error)};
  }
  return error_of(error);
}

/// An access list that names the owner alone and inherits nothing.
class OwnerOnly {
 public:
  OwnerOnly() {
    ::ConvertStringSecurityDescriptorToSecurityDescriptorW(L"D:P(A;;FA;;;OW)", SDDL_REVISION_1,
                                                           &attributes_.lpSecurityDescriptor, nullptr);
  }
  OwnerOnly(OwnerOnly const&) = delete;
  OwnerOnly& operator=(OwnerOnly const&) = delete;
  ~OwnerOnly() { ::LocalFree(attributes_.lpSecurityDescriptor); }

  [[nodiscard]] bool is_valid() const { return attributes_.lpSecurityDescriptor != nullptr; }
  SECURITY_ATTRIBUTES* get() { return &attributes_; }

 private:
  SECURITY_ATTRIBUTES attributes_{
      .nLength = sizeof(SECURITY_ATTRIBUTES), .lpSecurityDescriptor = nullptr, .bInheritHandle = FALSE};
};

HANDLE opened(std::string const& path, DWORD access, DWORD disposition, DWORD flags,
              SECURITY_ATTRIBUTES* security = nullptr) {
  return ::CreateFileW(wide_path(path).c_str(), access, share_everything, security, disposition, flags,
                       nullptr);
}

Result<FileStatus> status_from(HANDLE file) {
  if (::GetFileType(file) != FILE_TYPE_DISK) return FileStatus{.permissions = permissions_of_owner};
  BY_HANDLE_FILE_INFORMATION facts{};
  if (::GetFileInformationByHandle(file, &facts) == 0) {
    // An inherited handle may be readable although nothing else is known about it.
    if (::GetLastError() == ERROR_INVALID_HANDLE) return FileStatus{.permissions = permissions_of_owner};
    return last_error();
  }
  return FileStatus{.kind = kind_of(facts.dwFileAttributes),
                    .size = std::uint64_t{facts.nFileSizeHigh} << 32U | facts.nFileSizeLow,
                    .device = facts.dwVolumeSerialNumber,
                    .inode = std::uint64_t{facts.nFileIndexHigh} << 32U | facts.nFileIndexLow,
                    .permissions = permissions_of_owner};
}

Result<File> duplicate_of(DWORD stream, File (*make)(std::intptr_t)) {
  HANDLE copy = nullptr;
  auto* const process = ::GetCurrentProcess();
  if (::DuplicateHandle(process, ::GetStdHandle(stream), process, &copy, 0, FALSE, DUPLICATE_SAME_ACCESS) ==
      0) {
    return last_error();
  }
  return make(number_of(copy));
}

}  // namespace

File::~File() {
  if (is_open()) ::CloseHandle(handle_of(handle_));
}

Result<File> File::open(std::string const& path, Access access, Link link) {
  DWORD const rights = access == Access::write ? GENERIC_WRITE : GENERIC_READ;
  DWORD const flags = FILE_FLAG_BACKUP_SEMANTICS | (link == Link::refused ? FILE_FLAG_OPEN_REPARSE_POINT : 0);
  auto* const file = opened(path, rights, OPEN_EXISTING, flags);
  if (file == INVALID_HANDLE_VALUE) return last_error();
  File result(number_of(file));
  BY_HANDLE_FILE_INFORMATION facts{};
  bool const is_link = link == Link::refused && ::GetFileInformationByHandle(file, &facts) != 0 &&
                       (facts.dwFileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0;
  if (is_link) return error_of(ERROR_CANT_RESOLVE_FILENAME);
  return result;
}

Result<File> File::create(std::string const& path, Privacy privacy) {
  OwnerOnly owner;
  if (privacy == Privacy::owner && !owner.is_valid()) return last_error();
  auto* const file = opened(path, GENERIC_READ | GENERIC_WRITE | WRITE_DAC, CREATE_NEW, FILE_ATTRIBUTE_NORMAL,
                            privacy == Privacy::owner ? owner.get() : nullptr);
  if (file == INVALID_HANDLE_VALUE) return last_error();
  return File(number_of(file));
}

Result<File> File::standard_input() {
  return duplicate_of(STD_INPUT_HANDLE, [](std::intptr_t handle) { return File(handle); });
}

Result<File> File::standard_output() {
  return duplicate_of(STD_OUTPUT_HANDLE, [](std::intptr_t handle) { return File(handle); });
}

Result<FileStatus> File::status() const {
  return status_from(handle_of(handle_));
}

bool File::is_ready() const {
  DWORD waiting = 0;
  return ::PeekNamedPipe(handle_of(handle_), nullptr, 0, nullptr, &waiting, nullptr) != 0 && waiting > 0;
}

Result<std::size_t> File::read(std::span<char> buffer) const {
  return read_some(handle_of(handle_), buffer, nullptr);
}

Result<std::size_t> File::read_at(std::uint64_t offset, std::span<char> buffer) const {
  auto place = place_at(offset);
  return read_some(handle_of(handle_), buffer, &place);
}

std::optional<Error> File::write(std::string_view bytes) const {
  while (!bytes.empty()) {
    DWORD written = 0;
    auto const wanted = static_cast<DWORD>(std::min<std::size_t>(bytes.size(), most_at_once));
    if (::WriteFile(handle_of(handle_), bytes.data(), wanted, &written, nullptr) == 0) return last_error();
    bytes.remove_prefix(written);
  }
  return std::nullopt;
}

std::optional<Error> File::sync() const {
  return error_unless(::FlushFileBuffers(handle_of(handle_)) != 0);
}

std::optional<Error> File::close() {
  if (!is_open()) return std::nullopt;
  return error_unless(::CloseHandle(handle_of(std::exchange(handle_, none))) != 0);
}

// A member like its sister in system/posix. NOLINTNEXTLINE(readability-convert-member-functions-to-static)
std::optional<Error> File::take_over_owner(FileStatus const& /*other*/) const {
  return std::nullopt;
}

void File::take_over_attributes(std::string const& path) const {
  PACL list = nullptr;
  PSECURITY_DESCRIPTOR descriptor = nullptr;
  DWORD const got = ::GetNamedSecurityInfoW(wide_path(path).data(), SE_FILE_OBJECT, DACL_SECURITY_INFORMATION,
                                            nullptr, nullptr, &list, nullptr, &descriptor);
  if (got != ERROR_SUCCESS) return;
  ::SetSecurityInfo(handle_of(handle_), SE_FILE_OBJECT, DACL_SECURITY_INFORMATION, nullptr, nullptr, list,
                    nullptr);
  ::LocalFree(descriptor);
}

Result<FileStatus> status_of(std::string const& path, Link link) {
  DWORD const flags = FILE_FLAG_BACKUP_SEMANTICS | (link == Link::refused ? FILE_FLAG_OPEN_REPARSE_POINT : 0);
  auto* const file = opened(path, FILE_READ_ATTRIBUTES, OPEN_EXISTING, flags);
  if (file == INVALID_HANDLE_VALUE) return last_error();
  auto status = status_from(file);
  FILE_ATTRIBUTE_TAG_INFO tag{};
  bool const may_be_link = link == Link::refused && std::holds_alternative<FileStatus>(status) &&
                           ::GetFileInformationByHandleEx(file, FileAttributeTagInfo, &tag, sizeof(tag)) != 0;
  if (may_be_link && is_link(tag.FileAttributes, tag.ReparseTag)) {
    std::get<FileStatus>(status).kind = FileKind::link;
  }
  ::CloseHandle(file);
  return status;
}

std::optional<Error> refuses_writing(std::string const& path) {
  DWORD const attributes = ::GetFileAttributesW(wide_path(path).c_str());
  if (attributes == INVALID_FILE_ATTRIBUTES) return last_error();
  if ((attributes & FILE_ATTRIBUTE_DIRECTORY) != 0) return std::nullopt;
  return error_unless((attributes & FILE_ATTRIBUTE_READONLY) == 0 ||
                      (::SetLastError(ERROR_ACCESS_DENIED), false));
}

std::optional<Error> replace(std::string const& from, std::string const& to) {
  return error_unless(::MoveFileExW(wide_path(from).c_str(), wide_path(to).c_str(),
                                    MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != 0);
}

std::optional<Error> give_new_name(std::string const& from, std::string const& to) {
  return error_unless(::MoveFileExW(wide_path(from).c_str(), wide_path(to).c_str(), MOVEFILE_WRITE_THROUGH) !=
                      0);
}

void remove(std::string const& path) {
  ::DeleteFileW(wide_path(path).c_str());
}

void sync_folder(std::string const& /*folder*/) {}

}  // namespace axisc::system
