// Any bytes as a controller's lists: a start-up list that names the other pieces of the input as lists of
// each kind. Findings, never a crash; every place lies inside its source.
#include "diagnostics/writers/writers.hpp"
#include "validator/check.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>

namespace {

/// Pieces of the input, parted by a byte that no list has: the start-up list, then 1.lis, 2.lis and so on.
class Pieces final : public axisc::configuration::Files {
 public:
  explicit Pieces(std::string_view bytes) {
    std::string name = "hochlauf.lis";
    for (std::size_t number = 1; number < 10; ++number) {
      std::size_t const end = bytes.find('\x1f');
      files_.emplace(name, bytes.substr(0, end));
      if (end == std::string_view::npos) return;
      bytes.remove_prefix(end + 1);
      name = std::to_string(number) + ".lis";
    }
  }

  std::variant<std::string, axisc::configuration::FileError> read(std::string const& path) override {
    auto const found = files_.find(path);
    if (found == files_.end()) return axisc::configuration::FileError::not_found;
    return found->second;
  }
  bool is_file(std::string const& path) override { return files_.contains(path); }

 private:
  std::map<std::string, std::string> files_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  Pieces files({reinterpret_cast<char const*>(data), size});
  axisc::validator::CheckOptions options;
  options.pedantic = true;
  for (bool const from_folder : {false, true}) {
    options.from_folder = from_folder;
    axisc::SourceSet sources;
    auto const result = axisc::validator::check(files, "hochlauf.lis", options, sources);
    for (auto const& finding : result.findings) {
      bool const is_outside =
          finding.place && finding.place->span.end > sources[finding.place->source].bytes().size();
      if (is_outside) std::abort();
      for (auto const language : {axisc::Language::english, axisc::Language::german}) {
        if (axisc::write_text(finding, sources, {.language = language, .color = false}).empty()) std::abort();
      }
    }
  }
  return 0;
}
