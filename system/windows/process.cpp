#include "system/process.hpp"

#include "system/windows/error.hpp"
#include "system/windows/wide.hpp"

#include <algorithm>
#include <cstdlib>
#include <windows.h>

namespace axisc::system {

namespace {

HANDLE handle_of(Stream stream) {
  return ::GetStdHandle(stream == Stream::output ? STD_OUTPUT_HANDLE : STD_ERROR_HANDLE);
}

UINT code_page_before = 0;

void restore_code_page() {
  ::SetConsoleOutputCP(code_page_before);
}

}  // namespace

void prepare_streams() {
  code_page_before = ::GetConsoleOutputCP();
  if (code_page_before != 0 && code_page_before != CP_UTF8 && ::SetConsoleOutputCP(CP_UTF8) != 0) {
    static_cast<void>(std::atexit(restore_code_page));
  }
  for (Stream const stream : {Stream::output, Stream::error}) {
    DWORD mode = 0;
    auto* const handle = handle_of(stream);
    if (::GetConsoleMode(handle, &mode) != 0) {
      ::SetConsoleMode(handle, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
    }
  }
}

void keep_memory() {}

bool is_terminal(Stream stream) {
  DWORD mode = 0;
  return ::GetConsoleMode(handle_of(stream), &mode) != 0;
}

std::optional<std::size_t> terminal_width() {
  CONSOLE_SCREEN_BUFFER_INFO facts{};
  if (::GetConsoleScreenBufferInfo(handle_of(Stream::output), &facts) == 0) return std::nullopt;
  int const width = facts.srWindow.Right - facts.srWindow.Left + 1;
  return width > 0 ? std::optional(static_cast<std::size_t>(width)) : std::nullopt;
}

std::optional<Error> write(Stream stream, std::string_view bytes) {
  constexpr std::size_t most_at_once = std::size_t{1} << 24U;
  while (!bytes.empty()) {
    DWORD written = 0;
    auto const wanted = static_cast<DWORD>(std::min(bytes.size(), most_at_once));
    if (::WriteFile(handle_of(stream), bytes.data(), wanted, &written, nullptr) == 0) return last_error();
    bytes.remove_prefix(written);
  }
  return std::nullopt;
}

std::string_view environment_variable(char const* name) {
  char const* const value =
      std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing changes the environment
  return value == nullptr ? std::string_view{} : value;
}

std::string_view language_of_settings() {
  return PRIMARYLANGID(::GetUserDefaultUILanguage()) == LANG_GERMAN ? "de" : "en";
}

bool shell_expands_patterns() {
  return false;
}

ProcessName process_name() {
  wchar_t host[256] = {};
  DWORD size = 256;
  ::GetComputerNameW(host, &size);
  return {.number = ::GetCurrentProcessId(), .host = narrow(host)};
}

}  // namespace axisc::system
