#include "editor/reading/machine_reading.hpp"

#include "validator/check.hpp"
#include "validator/loading/loader.hpp"

#include <utility>
#include <variant>

namespace axisc::editor {

MachineReading::MachineReading(Buffers files, std::string path, OptionsOf const& options)
    : files_(std::move(files)), path_(std::move(path)), options_(options) {
  auto const chosen = options_(path_);
  catalogue_ = chosen.catalogue;
  auto loaded = validator::load(files_, path_, chosen, sources_);
  if (auto* const found = std::get_if<validator::LoadedMachine>(&loaded)) machine_ = std::move(*found);
}

std::vector<Finding> const& MachineReading::findings() {
  if (findings_) return *findings_;
  auto& findings = findings_.emplace();
  if (!machine_) return findings;
  (void)validator::check(*machine_, files_, options_(path_), sources_, [&](Finding& finding) {
    if (!finding.place) finding.file = finding.file.empty() ? path_ : validator::beside(path_, finding.file);
    findings.push_back(std::move(finding));
  });
  return findings;
}

OpenList const& MachineReading::list(OpenDocument const& document) {
  auto& known = lists_[&document];
  if (!known) {
    known = std::make_unique<OpenList const>(document, files_, machine(), sources_, catalogue_,
                                             options_(document.path).kind);
  }
  return *known;
}

}  // namespace axisc::editor
