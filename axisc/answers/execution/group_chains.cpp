#include "axisc/answers/execution/group_chains.hpp"

#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/environment/sentences.hpp"

#include <algorithm>

namespace axisc {

double path_velocity(double feed_mm_per_min, design::CycleTime cycle_time) {
  return feed_mm_per_min / 60 * cycle_time.seconds() * motion::units_per_mm;
}

GroupChains::GroupChains(machine::Machine const& machine, std::size_t group,
                         std::vector<machine::FilterCommand> commands, std::string path)
    : group_(machine.groups[group]), commands_(std::move(commands)), path_(std::move(path)) {
  auto part = machine::part_of(machine, group_.axes);
  auto const own = std::find(part.groups.begin(), part.groups.end(), group);
  part_.emplace(
      Part{.machine = std::move(part.machine), .group = static_cast<std::size_t>(own - part.groups.begin())});
  for (auto const& command : commands_) add_set(command.parameters);
}

GroupChains::GroupChains(ImageFile const& image, machine::MachineGroup group,
                         std::vector<machine::FilterCommand> commands, std::string path)
    : group_(std::move(group)), commands_(std::move(commands)), path_(std::move(path)), image_(&image) {}

ImageFile const& GroupChains::image() {
  if (image_ != nullptr) return *image_;
  if (!compiled_) compiled_ = image_of(part_->machine, path_);
  return *compiled_;
}

void GroupChains::add_order(std::uint32_t order) {
  auto parameters = commands_.front().parameters;
  parameters.order = order;
  add_set(parameters);
}

std::vector<motion::ChainAnswer> GroupChains::answers(std::optional<std::uint32_t> order) {
  auto const& executed = part_ ? part_->machine.groups[part_->group] : group_;
  if (!runtime_) runtime_.emplace(group_runtime(image(), executed, path_, part_ ? &part_->machine : nullptr));
  static_cast<void>(runtime_->reset({}));
  for (auto command : commands_) {
    if (order && command.reaches(machine::KernelFamily::fir)) command.parameters.order = order;
    static_cast<void>(runtime_->command(command));
  }
  auto answered = motion::chain_answers(*runtime_);
  if (auto const* const missing = std::get_if<motion::NoAnswer>(&answered)) {
    throw Failure(
        {says::blocks_constant,
         {{"axis", axis_label(image().contents, executed.axes[missing->axis])}, {"group", group_.name}}});
  }
  return std::get<std::vector<motion::ChainAnswer>>(std::move(answered));
}

void GroupChains::add_set(machine::FilterParameters const& parameters) {
  auto& sets = part_->machine.groups[part_->group].filter_sets;
  if (parameters.empty() || std::find(sets.begin(), sets.end(), parameters) != sets.end()) return;
  sets.push_back(parameters);
}

}  // namespace axisc
