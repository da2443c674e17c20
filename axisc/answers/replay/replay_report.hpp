// Report on a recording: what happened in which cycle, and where the replay differs.
#pragma once

#include "image/image_contents.hpp"
#include "image/recording.hpp"
#include "presentation/document.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// An event, in one or several consecutive cycles.
struct ReplayEvent {
  std::uint64_t first = 0, last = 0;
  std::string subject;       ///< axis or channel
  presentation::Value what;  ///< "#FILTER ON [ORDER=20]"; nothing for a status alone
  std::string call;          ///< the same text for equal calls; empty for a status alone
  axisrt_status status = AXISRT_OK;
};

struct ReplayDifference {
  std::uint64_t cycle = 0;
  std::string subject;
  double recorded = 0, computed = 0;
};

class ReplayReport {
 public:
  explicit ReplayReport(image::ImageContents const& image) : image_(image) {}

  void add(image::ReplayedEntry const& entry);
  [[nodiscard]] std::uint64_t cycles() const { return cycles_; }
  [[nodiscard]] std::uint64_t differences() const { return differences_; }

  /// `level` is the axisrt_level of the recording.
  [[nodiscard]] presentation::Document answer(std::uint32_t level) const;

 private:
  [[nodiscard]] std::string name(image::ReplayedEntry const& entry, std::size_t axis) const;
  void add_event(ReplayEvent event);
  void add_call(image::ReplayedEntry const& entry);
  void add_statuses(image::ReplayedEntry const& entry);
  void compare(image::ReplayedEntry const& entry);

  image::ImageContents const& image_;
  std::uint64_t cycles_ = 0;
  std::uint64_t differences_ = 0;
  std::optional<ReplayDifference> first_difference_;
  std::vector<ReplayEvent> events_;
};

}  // namespace axisc
