// Any bytes as a TwinCAT project: findings inside the file, and fixes that leave what is outside CDATA sections.
#include "diagnostics/fix_batch.hpp"
#include "diagnostics/writers/writers.hpp"
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
    if (path == "m.tsproj") return bytes_;
    return axisc::configuration::FileError::not_found;
  }

 private:
  std::string bytes_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  OneFile files(std::string(reinterpret_cast<char const*>(data), size));
  axisc::SourceSet sources;
  axisc::validator::CheckOptions options;
  options.pedantic = true;
  auto const result = axisc::validator::check(files, "m.tsproj", options, sources);
  axisc::FixBatch batch(sources);
  for (auto const& finding : result.findings) {
    if (finding.place && finding.place->span.end > sources[finding.place->source].bytes().size())
      std::abort();
    if (axisc::write_text(finding, sources, {.language = axisc::Language::english, .color = false}).empty())
      std::abort();
    if (finding.fix) static_cast<void>(batch.add(*finding.fix));
  }
  if (batch.apply().size() > 1) std::abort();
  return 0;
}
