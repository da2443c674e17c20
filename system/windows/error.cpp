#include "system/windows/error.hpp"

#include "system/windows/wide.hpp"

#include <windows.h>

namespace axisc::system {

Error error_of(unsigned long number) {
  auto const refusal = [number] {
    switch (number) {
      case ERROR_FILE_NOT_FOUND:
      case ERROR_PATH_NOT_FOUND:
      case ERROR_INVALID_NAME:
      case ERROR_BAD_PATHNAME:
      case ERROR_BAD_NETPATH:
      case ERROR_BAD_NET_NAME:
      case ERROR_INVALID_DRIVE:
      case ERROR_DIRECTORY: return Refusal::not_found;
      case ERROR_FILE_EXISTS:
      case ERROR_ALREADY_EXISTS: return Refusal::exists;
      case ERROR_ACCESS_DENIED:
      case ERROR_SHARING_VIOLATION:
      case ERROR_LOCK_VIOLATION:
      case ERROR_USER_MAPPED_FILE: return Refusal::no_permission;
      case ERROR_WRITE_PROTECT: return Refusal::read_only;
      case ERROR_DISK_FULL:
      case ERROR_HANDLE_DISK_FULL: return Refusal::no_space;
      case ERROR_BROKEN_PIPE:
      case ERROR_NO_DATA:
      case ERROR_PIPE_NOT_CONNECTED: return Refusal::closed_pipe;
      case ERROR_INVALID_HANDLE: return Refusal::not_open;
      case ERROR_CANT_RESOLVE_FILENAME: return Refusal::link_loop;
      default: return Refusal::other;
    }
  };
  return {.refusal = refusal(), .number = static_cast<int>(number)};
}

Error last_error() {
  return error_of(::GetLastError());
}

std::string text_of(Error const& error) {
  wchar_t text[512] = {};
  DWORD const size = ::FormatMessageW(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS, nullptr,
                                      static_cast<DWORD>(error.number), 0, text, 512, nullptr);
  std::string words = narrow({text, size});
  words.erase(words.find_last_not_of(" .\r\n") + 1);
  return words.empty() ? "error " + std::to_string(error.number) : words;
}

}  // namespace axisc::system
