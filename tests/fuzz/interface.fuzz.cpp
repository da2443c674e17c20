// Any calls of axisc.h with any texts, and functions for files that fail, lie, cancel and call again: results
// are those of the header, every text ends, and nothing else happens. A call is a byte and a text that ends
// in NUL.
#include "axisc/axisc.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

class Calls {
 public:
  Calls(std::uint8_t choice, std::uint8_t behaviour) : behaviour_(behaviour) {
    files_ = {.size = sizeof(axisc_files), .reserved = 0, .context = this, .read = read, .list = list};
    require(axisc_open(R"({"cycle_time": "1ms"})", choice % 2 == 0 ? nullptr : &files_, &workspace_) ==
            AXISC_OK);
  }
  Calls(Calls const&) = delete;
  Calls& operator=(Calls const&) = delete;
  ~Calls() { axisc_close(workspace_); }

  void call(std::uint8_t function, std::string const& text) {
    auto const* const words = text.c_str();
    auto const path = named(text);
    auto const* const name = path.c_str();
    axisc_bytes result{};
    axisc_bytes findings{};
    switch (function % 12) {
      case 0: take(axisc_put(workspace_, "x.lis", words, text.size()), result); break;
      case 1: take(axisc_put(workspace_, "machine.json", words, text.size()), result); break;
      case 2: take(axisc_put(workspace_, "part.nc", words, text.size()), result); break;
      case 3: take(axisc_put(workspace_, name, words, text.size()), result); break;
      case 4: take(axisc_check(workspace_, name, &result), result); break;
      case 5: take(axisc_fix(workspace_, name, text.size() % 2 == 0 ? 0 : 1, &result), result); break;
      case 6:
        take(axisc_compile(workspace_, name, text.size() < 8 ? nullptr : words, &result, &findings), result);
        axisc_free(&findings);
        break;
      case 7: take(axisc_answer(workspace_, question(text).c_str(), &result), result); break;
      case 8: take(axisc_message(workspace_, words, &result), result); break;
      case 9: take(axisc_read(workspace_, name, &result), result); break;
      case 10: open_another(words); break;
      default: take(axisc_drop(workspace_, name), result); break;
    }
  }

 private:
  /// No folder of this computer is searched.
  static std::string named(std::string text) {
    static constexpr std::array names = {"x.lis", "machine.json", "part.nc"};
    if (text.size() <= names.size()) return names.at(text.size() % names.size());
    std::replace(text.begin(), text.end(), '/', '_');
    return text + ".lis";
  }
  /// About the machine alone.
  static std::string question(std::string const& text) {
    for (auto const* const other : {"input", "before", "pro", "plant", "\\", "/"}) {
      if (text.find(other) != std::string::npos) return "{}";
    }
    return R"({"input": "machine.json", )" + text;
  }

  void take(int status, axisc_bytes& result) const {
    require(status >= AXISC_INTERNAL && status <= AXISC_BROKEN_OFF && status != AXISC_INTERNAL &&
            status != AXISC_BUSY);
    require(result.data == nullptr || result.data[result.size] == '\0');
    require(status >= 0 || std::strlen(axisc_error(workspace_)) > 0);
    axisc_free(&result);
  }

  static void open_another(char const* options) {
    axisc_workspace* other = nullptr;
    require(axisc_open(options, nullptr, &other) <= AXISC_OK);
    axisc_close(other);
  }

  static int read(void* context, char const* path, axisc_bytes* file) {
    auto& calls = *static_cast<Calls*>(context);
    auto const behaviour = calls.behaviour_++;
    axisc_bytes nothing{};
    if (behaviour % 16 == 3) axisc_cancel(calls.workspace_);
    if (behaviour % 16 == 5) require(axisc_read(calls.workspace_, path, &nothing) == AXISC_BUSY);
    if (behaviour % 16 == 7) return behaviour;  // no result of the header
    if (behaviour % 16 == 9) return AXISC_OK;   // without a file
    if (behaviour % 16 == 11) return AXISC_NOT_FOUND;
    std::string_view const text =
        behaviour % 2 == 0 ? "kopf.achs_nr 1\n" : R"({"axes": [{"list": "x.lis"}]})";
    return axisc_copy(file, text.data(), text.size());
  }
  static int list(void* /*context*/, char const* /*folder*/, axisc_bytes* names) {
    return axisc_copy(names, "x.lis\0\0part.nc", 14);
  }

  std::uint8_t behaviour_;
  axisc_files files_{};
  axisc_workspace* workspace_ = nullptr;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  constexpr std::size_t most_calls = 8;
  if (size < 2) return 0;
  Calls calls(data[0], data[1]);
  std::string_view rest(reinterpret_cast<char const*>(data) + 2, size - 2);
  for (std::size_t i = 0; i < most_calls && !rest.empty(); ++i) {
    auto const end = std::min(rest.find('\0', 1), rest.size());
    calls.call(static_cast<std::uint8_t>(rest.front()), std::string(rest.substr(1, end - 1)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return 0;
}
