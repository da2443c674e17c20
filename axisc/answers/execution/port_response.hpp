// Frequency response of the filters at one port of an axis.
#pragma once

#include "axisc/files/image_file.hpp"
#include "design/filter_analysis.hpp"
#include "design/kernels/kernel_design.hpp"

#include <optional>
#include <vector>

namespace axisc {

/// Setpoint: the cascade with the kernel that the runtime has switched on. Additional interface: its filter.
/// Velocity: from all three velocities to the additive velocity, -Σ weight·stage, without its limit.
class PortResponse {
 public:
  PortResponse(image::ImageContents const& image, image::RuntimeHost const& host, std::size_t axis,
               Port port);

  [[nodiscard]] design::ResponsePoint at(design::Hertz frequency) const;

 private:
  std::vector<design::WeightedChain> chains_;
  std::optional<design::KernelDesign> kernel_;
  design::CycleTime cycle_time_;
};

}  // namespace axisc
