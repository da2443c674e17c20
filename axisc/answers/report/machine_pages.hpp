// What a client shows of a machine while it is edited: its report, pictures, and the line above a cascade of
// filters.
#pragma once

#include "analysis/motion/chain_answer.hpp"
#include "axisc/files/image_file.hpp"
#include "configuration/files.hpp"
#include "diagnostics/finding.hpp"
#include "image/runtime_host.hpp"
#include "presentation/pictures/figure.hpp"
#include "validator/check.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// A machine that is checked and compiled once for what is asked of it. Failure for an input that cannot be
/// read and for an unknown NC cycle time; after errors in its lists there is the report alone.
class MachinePages {
 public:
  /// `files` outlives this object.
  MachinePages(configuration::Files& files, std::string path, validator::CheckOptions options,
               Language language);

  /// A whole document.
  [[nodiscard]] std::string report();
  /// `response`, `step`, `delay`, `corner` or `circle`; of the axis where one is named. Failure for another
  /// word, and after errors.
  [[nodiscard]] pictures::Figure figure(std::string const& kind, std::optional<std::string> const& axis);
  /// "delay 12.4 ms, 0.35 mm at a corner at 60000 mm/min" for the axis, or for each axis if none is named; or
  /// the reason why there are no figures.
  [[nodiscard]] std::string cascade(std::optional<std::string> const& axis);

 private:
  [[nodiscard]] std::string say(SentenceRef text) const;
  [[nodiscard]] std::string name() const;
  [[nodiscard]] std::string cascade_text(motion::ChainAnswer const& answer,
                                         machine::AxisConfiguration const& axis) const;

  std::string path_;
  Language language_;
  SourceSet sources_;
  std::vector<Finding> findings_;
  validator::CheckResult result_;
  std::optional<ImageFile> image_;
  std::optional<image::RuntimeHost> host_;
};

}  // namespace axisc
