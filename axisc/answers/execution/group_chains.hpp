// Chains of one channel's axes, with its filters switched as a program would.
#pragma once

#include "analysis/motion/chain_answer.hpp"
#include "analysis/motion/group_runtime.hpp"
#include "axisc/files/image_file.hpp"
#include "configuration/machine/part.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// Position units per NC cycle.
[[nodiscard]] double path_velocity(double feed_mm_per_min, design::CycleTime cycle_time);

class GroupChains {
 public:
  /// The channel of a machine, which has axes; it is compiled alone, when the first answer is wanted. `path`
  /// is the machine's, for messages.
  GroupChains(machine::Machine const& machine, std::size_t group,
              std::vector<machine::FilterCommand> commands, std::string path);
  /// An image, which has no orders but its own and outlives this. `group` refers to the image's axes.
  GroupChains(ImageFile const& image, machine::MachineGroup group,
              std::vector<machine::FilterCommand> commands, std::string path);

  /// Orders that answers() accepts.
  void add_order(std::uint32_t order);
  /// By axis of the group, with this order instead of the lists'. Failure for a chain that blocks the
  /// constant part, and for a group with more axes than a path has.
  [[nodiscard]] std::vector<motion::ChainAnswer> answers(std::optional<std::uint32_t> order);

  /// Refers to the axes of the machine, or of the image.
  [[nodiscard]] machine::MachineGroup const& group() const { return group_; }

 private:
  /// The channel's axes, and which of the groups is the channel.
  struct Part {
    machine::Machine machine;
    std::size_t group = 0;
  };

  void add_set(machine::FilterParameters const& parameters);
  [[nodiscard]] ImageFile const& image();

  machine::MachineGroup group_;
  std::optional<Part> part_;  ///< none of an image
  std::vector<machine::FilterCommand> commands_;
  std::string path_;
  std::optional<ImageFile> compiled_;
  ImageFile const* image_ = nullptr;  ///< of who has no machine
  std::optional<motion::GroupRuntime> runtime_;
};

}  // namespace axisc
