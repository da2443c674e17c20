// Any bytes as a TwinCAT project and as a list in XML: findings inside the file, fixes of a project's lists
// and of nothing else.
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
    if (path == "m.tsproj" || path == "m.xml") return bytes_;
    return axisc::configuration::FileError::not_found;
  }

 private:
  std::string bytes_;
};

/// The number of files that the fixes would change.
std::size_t check_as(std::string const& path, std::string const& bytes) {
  OneFile files(bytes);
  axisc::SourceSet sources;
  axisc::validator::CheckOptions options;
  options.pedantic = true;
  auto const result = axisc::validator::check(files, path, options, sources);
  axisc::FixBatch batch(sources);
  for (auto const& finding : result.findings) {
    if (finding.place) {
      auto const& source = sources[finding.place->source];
      if (finding.place->span.end > source.bytes().size()) std::abort();
      auto const line = source.position(finding.place->span.begin).line;
      if (line > source.lines_before() + source.line_count()) std::abort();
    }
    if (axisc::write_text(finding, sources, {.language = axisc::Language::english, .color = false}).empty())
      std::abort();
    if (finding.fix) static_cast<void>(batch.add(*finding.fix));
  }
  return batch.apply().size();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string const bytes(reinterpret_cast<char const*>(data), size);
  if (check_as("m.tsproj", bytes) > 1) std::abort();
  if (check_as("m.xml", bytes) > 0) std::abort();
  return 0;
}
