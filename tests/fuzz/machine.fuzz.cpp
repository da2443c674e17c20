// Any bytes as a list or as a machine file: findings, never a crash; every place lies inside its source.
#include "diagnostics/whole_report.hpp"
#include "validator/check.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

class OneFile : public axisc::configuration::Files {
 public:
  explicit OneFile(std::string bytes) : bytes_(std::move(bytes)) {}
  std::variant<std::string, axisc::configuration::FileError> read(std::string const& path) override {
    if (path == "x.lis" || path == "input") return bytes_;
    if (path == "m.json") return bytes_;
    return axisc::configuration::FileError::not_found;
  }

 private:
  std::string bytes_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string const bytes(reinterpret_cast<char const*>(data), size);
  for (char const* path : {"x.lis", "m.json"}) {
    OneFile files(bytes);
    axisc::SourceSet sources;
    axisc::validator::CheckOptions options;
    options.pedantic = true;
    auto const result = axisc::validator::check(files, path, options, sources);
    for (auto const& finding : result.findings) {
      if (finding.place && finding.place->span.end > sources[finding.place->source].bytes().size())
        std::abort();
      for (auto const language : {axisc::Language::english, axisc::Language::german}) {
        if (axisc::write_text(finding, sources, {.language = language, .color = false}).empty()) std::abort();
      }
    }
    if (axisc::test::write_json(result.findings, sources, {.files = 1}, {}).empty()) std::abort();
  }
  return 0;
}
