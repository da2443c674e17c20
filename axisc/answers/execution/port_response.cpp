#include "axisc/answers/execution/port_response.hpp"

#include "design/kernels/kernel_analysis.hpp"

#include <variant>

namespace axisc {

namespace {

design::WeightedChain chain_of(std::vector<image::ImageFilter> const& filters, double weight) {
  design::WeightedChain chain{.weight = weight, .filters = {}};
  for (auto const& filter : filters) chain.filters.push_back(filter.design);
  return chain;
}

std::optional<design::KernelDesign> switched_on(image::ImageContents const& image,
                                                image::RuntimeHost const& host, std::size_t axis) {
  auto const state = host.axis_state(static_cast<std::uint32_t>(axis));
  auto const* const known = std::get_if<axisrt_axis_state>(&state);
  if (known == nullptr || known->kernel == AXISRT_NO_KERNEL) return std::nullopt;
  return image.kernels[known->kernel].design;
}

}  // namespace

PortResponse::PortResponse(image::ImageContents const& image, image::RuntimeHost const& host,
                           std::size_t axis, Port port)
    : cycle_time_(image.cycle_time) {
  auto const& contents = image.axes[axis];
  switch (port) {
    case Port::setpoint:
      chains_.push_back(chain_of(contents.filters, 1));
      kernel_ = switched_on(image, host, axis);
      break;
    case Port::interface: chains_.push_back(chain_of(contents.interface_filters, 1)); break;
    case Port::velocity:
      for (auto const& stage : image.axes[contents.control->source].control->stages) {
        chains_.push_back(chain_of(stage.filters, -stage.weight));
      }
      break;
  }
}

design::ResponsePoint PortResponse::at(design::Hertz frequency) const {
  auto const filters = chains_.size() == 1 && chains_.front().weight == 1
                           ? design::chain_response(chains_.front().filters, frequency, cycle_time_)
                           : design::parallel_response(chains_, frequency, cycle_time_);
  if (!kernel_) return filters;
  return design::in_series(filters, design::kernel_response(*kernel_, frequency, cycle_time_));
}

}  // namespace axisc
