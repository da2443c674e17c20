#include "system/program.hpp"

#include "system/windows/error.hpp"
#include "system/windows/wide.hpp"

#include <algorithm>
#include <thread>
#include <utility>
#include <windows.h>

namespace axisc::system {
namespace {

/// A handle that is closed once.
class Handle {
 public:
  explicit Handle(HANDLE handle = nullptr) : handle_(handle) {}
  Handle(Handle const&) = delete;
  Handle& operator=(Handle const&) = delete;
  ~Handle() { close(); }

  [[nodiscard]] HANDLE get() const { return handle_; }
  HANDLE* place() { return &handle_; }
  void close() {
    if (handle_ != nullptr && handle_ != INVALID_HANDLE_VALUE) ::CloseHandle(handle_);
    handle_ = nullptr;
  }

 private:
  HANDLE handle_;
};

struct Pipe {
  Handle reader;
  Handle writer;  ///< that other programs inherit

  [[nodiscard]] bool open() {
    SECURITY_ATTRIBUTES attributes{
        .nLength = sizeof(SECURITY_ATTRIBUTES), .lpSecurityDescriptor = nullptr, .bInheritHandle = TRUE};
    return ::CreatePipe(reader.place(), writer.place(), &attributes, 0) != 0 &&
           ::SetHandleInformation(reader.get(), HANDLE_FLAG_INHERIT, 0) != 0;
  }
  [[nodiscard]] std::string read_to_the_end() const {
    std::string text;
    std::string buffer(1U << 14U, '\0');
    DWORD got = 0;
    while (::ReadFile(reader.get(), buffer.data(), static_cast<DWORD>(buffer.size()), &got, nullptr) != 0 &&
           got > 0) {
      text.append(buffer, 0, got);
    }
    return text;
  }
};

/// As programs of Microsoft's C library take their command line apart: a quote is written \", and backslashes
/// before a quote are doubled.
std::wstring quoted(std::wstring const& argument) {
  std::wstring text = L"\"";
  std::size_t backslashes = 0;
  for (wchar_t const character : argument) {
    if (character == L'\\') {
      ++backslashes;
      continue;
    }
    text.append(character == L'"' ? 2 * backslashes + 1 : backslashes, L'\\');
    text += character;
    backslashes = 0;
  }
  return text.append(2 * backslashes, L'\\') + L'"';
}

/// In the folders of PATH alone: the system itself would take one from the working folder first.
std::wstring found_program(std::string const& name) {
  std::wstring folders(32768, L'\0');
  folders.resize(::GetEnvironmentVariableW(L"PATH", folders.data(), static_cast<DWORD>(folders.size())));
  for (std::size_t begin = 0; begin < folders.size();) {
    auto const end = std::min(folders.find(L';', begin), folders.size());
    auto const folder = folders.substr(begin, end - begin);
    begin = end + 1;
    bool const is_absolute = folder.size() > 2 && (folder[1] == L':' || folder.starts_with(L"\\\\"));
    auto program = folder + L"\\" + wide(name) + L".exe";
    if (is_absolute && ::GetFileAttributesW(program.c_str()) != INVALID_FILE_ATTRIBUTES) return program;
  }
  return {};
}

}  // namespace

Result<ProgramOutcome> run_program(std::vector<std::string> const& arguments) {
  auto const program = found_program(arguments.front());
  if (program.empty()) return error_of(ERROR_FILE_NOT_FOUND);
  std::wstring command = quoted(program);
  for (std::size_t i = 1; i < arguments.size(); ++i) command += L' ' + quoted(wide(arguments[i]));
  Pipe output;
  Pipe errors;
  if (!output.open() || !errors.open()) return last_error();
  STARTUPINFOW start{};
  start.cb = sizeof(start);
  start.dwFlags = STARTF_USESTDHANDLES;
  start.hStdOutput = output.writer.get();
  start.hStdError = errors.writer.get();
  PROCESS_INFORMATION process{};
  if (::CreateProcessW(program.c_str(), command.data(), nullptr, nullptr, TRUE, CREATE_NO_WINDOW, nullptr,
                       nullptr, &start, &process) == 0) {
    return last_error();
  }
  Handle const running(process.hProcess);
  Handle const first_thread(process.hThread);
  output.writer.close();
  errors.writer.close();
  ProgramOutcome outcome;
  {
    // Both at once: a program may wait until one of them is read.
    std::thread reader([&] { outcome.errors = errors.read_to_the_end(); });
    outcome.output = output.read_to_the_end();
    reader.join();
  }
  DWORD status = 1;
  ::WaitForSingleObject(running.get(), INFINITE);
  ::GetExitCodeProcess(running.get(), &status);
  outcome.status = static_cast<int>(status);
  return outcome;
}

}  // namespace axisc::system
