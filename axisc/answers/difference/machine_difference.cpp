#include "axisc/answers/difference/machine_difference.hpp"

#include "axisc/answers/dynamics/driven_axis.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <string_view>

namespace axisc {

namespace {

/// The names of the old machine as the new one calls its axes: an axis that is renamed stays in its channel.
class NewNames {
 public:
  explicit NewNames(std::vector<AxisPair> const& pairs) {
    for (auto const& [was, is] : pairs) {
      if (was != nullptr && is != nullptr) names_[was->name] = is->name;
    }
  }

  [[nodiscard]] std::string of(std::string const& name) const {
    auto const found = names_.find(name);
    return found == names_.end() ? name : found->second;
  }
  [[nodiscard]] std::vector<std::string> of(std::vector<std::string> names) const {
    for (auto& name : names) name = of(name);
    return names;
  }

 private:
  std::map<std::string, std::string> names_;
};

bool same_programs(ComparedChannel const& a, ComparedChannel const& b) {
  return std::equal(a.programs.begin(), a.programs.end(), b.programs.begin(), b.programs.end(),
                    [](ComparedProgram const& was, ComparedProgram const& is) {
                      return was.name == is.name && was.mark == is.mark;
                    });
}

std::optional<AxisMotion> motion_of(ComparedMachine const& side, ComparedAxis const& axis) {
  auto const driven = side.machine ? driven_axis(*side.machine, axis.index) : std::nullopt;
  if (!driven) return std::nullopt;
  WantedMove const move;
  return AxisMotion{.slope = driven->slope(),
                    .has_channel_list = driven->has_channel_list(),
                    .at_feed_s = driven->feed(move).seconds,
                    .in_rapid_s = driven->rapid(move.distance_mm).seconds,
                    .corner_velocity = driven->corner_velocity(),
                    .uncomputed = driven->uncomputed()};
}

class Comparison {
 public:
  Comparison(ComparedMachine const& before, ComparedMachine const& after, bool all)
      : difference_{.before = before, .after = after}, all_(all) {}

  MachineDifference machines() && {
    auto const pairs = pair_axes(difference_.before, difference_.after);
    for (auto const& [was, is] : pairs) {
      if (was == nullptr) difference_.axes_added.push_back(is);
      if (is == nullptr) difference_.axes_removed.push_back(was);
      if (was != nullptr && is != nullptr) add_axis(*was, *is);
    }
    add_chains();
    NewNames const names(pairs);
    if (difference_.before.tells_channels && difference_.after.tells_channels) {
      add_channels(names);
      if (knows_all()) add_gantries(names);
    }
    return std::move(difference_);
  }

  MachineDifference axes(ComparedAxis const& was, ComparedAxis const& is) && {
    are_chosen_ = true;
    difference_.of_one_machine = &difference_.before == &difference_.after;
    add_axis(was, is);
    add_chains();
    return std::move(difference_);
  }

 private:
  [[nodiscard]] bool knows_all() const { return difference_.before.tells_all && difference_.after.tells_all; }

  void add_axis(ComparedAxis const& was, ComparedAxis const& is) {
    auto const& before = difference_.before;
    auto const& after = difference_.after;
    AxisDifference axis;
    axis.before = &was;
    axis.after = &is;
    axis.parameters = compare_parameters(before, was, after, is);
    if (!all_) leave_out(axis.parameters);
    axis.renamed = !are_chosen_ && before.tells_channels && after.tells_channels && was.name != is.name;
    auto const is_set = [&](std::string_view name) {
      return std::any_of(axis.parameters.begin(), axis.parameters.end(),
                         [&](ParameterChange const& change) { return change.name == name; });
    };
    axis.other_type = knows_all() && was.type != is.type && !is_set("kenngr.achs_typ");
    axis.other_drive = knows_all() && was.drive != is.drive && !is_set("kenngr.antr_typ");
    compared_.push_back(std::move(axis));
  }

  /// What the differences do to the axes: of all at once, because the runtime executes whole images.
  void add_chains() {
    auto const& before = difference_.before;
    auto const& after = difference_.after;
    if (before.image && after.image) {
      std::vector<image::AxesToCompare> pairs;
      for (auto const& axis : compared_) pairs.push_back({axis.before->index, axis.after->index});
      auto chains = image::compare_chains({before.image->bytes.bytes(), before.image->contents},
                                          {after.image->bytes.bytes(), after.image->contents}, pairs);
      for (std::size_t i = 0; i < compared_.size(); ++i) compared_[i].chain = std::move(chains[i]);
    }
    for (auto& axis : compared_) {
      auto const was = motion_of(before, *axis.before);
      auto const is = motion_of(after, *axis.after);
      if (was && is && *was != *is) axis.motion = MotionDifference{.before = *was, .after = *is};
      if (!axis.empty() || !axis.parameters.empty()) difference_.axes.push_back(std::move(axis));
    }
    compared_.clear();
  }

  void leave_out(std::vector<ParameterChange>& parameters) {
    std::erase_if(parameters, [&](ParameterChange const& change) {
      if (difference_.of_one_machine && is_own(*change.row)) {
        if (!change.equal) difference_.left_out.push_back(change.name);
        return true;
      }
      difference_.set_to_default += change.equal ? 1 : 0;
      return change.equal;
    });
  }

  /// An image does not tell the channels of a single axis.
  [[nodiscard]] std::vector<ComparedChannel const*> channels_of(ComparedMachine const& machine) const {
    std::vector<ComparedChannel const*> channels;
    for (auto const& channel : machine.channels) {
      if (knows_all() || channel.axes.size() > 1) channels.push_back(&channel);
    }
    return channels;
  }

  void add_channels(NewNames const& names) {
    auto const old_channels = channels_of(difference_.before);
    auto const new_channels = channels_of(difference_.after);
    std::vector<ComparedChannel const*> partners(new_channels.size());
    std::set<ComparedChannel const*> paired;
    std::map<std::string_view, std::deque<ComparedChannel const*>> old_names;
    for (auto const* const was : old_channels) old_names[was->name].push_back(was);
    for (std::size_t i = 0; i < new_channels.size(); ++i) {
      auto& named = old_names[new_channels[i]->name];
      if (named.empty()) continue;
      partners[i] = named.front();
      named.pop_front();
      paired.insert(partners[i]);
    }
    // A channel that is renamed keeps its place.
    for (std::size_t i = 0; i < std::min(old_channels.size(), new_channels.size()); ++i) {
      if (partners[i] == nullptr && paired.insert(old_channels[i]).second) partners[i] = old_channels[i];
    }
    for (std::size_t i = 0; i < new_channels.size(); ++i) {
      bool const is_same = partners[i] != nullptr && same_channel(*partners[i], *new_channels[i], names);
      if (!is_same) difference_.channels.push_back({.before = partners[i], .after = new_channels[i]});
    }
    for (auto const* const was : old_channels) {
      if (!paired.contains(was)) difference_.channels.push_back({.before = was, .after = nullptr});
    }
  }

  [[nodiscard]] bool same_channel(ComparedChannel const& was, ComparedChannel const& is,
                                  NewNames const& names) const {
    if (was.name != is.name || names.of(was.axes) != is.axes) return false;
    return !knows_all() || (names.of(was.spindles) == is.spindles && was.couplings == is.couplings &&
                            same_programs(was, is) && was.dynamics == is.dynamics);
  }

  void add_gantries(NewNames const& names) {
    // As the new machine calls the axes.
    using Gantry = std::pair<std::string, std::vector<std::string>>;
    std::set<Gantry> old_gantries;
    std::set<Gantry> new_gantries;
    for (auto const& is : difference_.after.gantries) new_gantries.emplace(is.master, is.slaves);
    for (auto const& was : difference_.before.gantries) {
      Gantry renamed(names.of(was.master), names.of(was.slaves));
      if (!new_gantries.contains(renamed)) difference_.gantries_before.push_back(was);
      old_gantries.insert(std::move(renamed));
    }
    for (auto const& is : difference_.after.gantries) {
      if (!old_gantries.contains({is.master, is.slaves})) difference_.gantries_after.push_back(is);
    }
  }

  MachineDifference difference_;
  std::vector<AxisDifference> compared_;  ///< until their chains are known
  bool all_;
  bool are_chosen_ = false;  ///< the axes are those that the command line names
};

}  // namespace

std::vector<std::string> programs_with_other_content(ChannelDifference const& channel) {
  std::vector<std::string> names;
  if (channel.before == nullptr || channel.after == nullptr) return names;
  for (auto const& was : channel.before->programs) {
    for (auto const& is : channel.after->programs) {
      if (was.name == is.name && !(was.mark == is.mark)) names.push_back(is.name);
    }
  }
  return names;
}

bool AxisDifference::empty() const {
  bool const same_parameters = std::all_of(parameters.begin(), parameters.end(),
                                           [](ParameterChange const& change) { return change.equal; });
  return same_parameters && !renamed && !other_type && !other_drive && !chain && !motion;
}

bool MachineDifference::empty() const {
  return axes_removed.empty() && axes_added.empty() && channels.empty() && gantries_before.empty() &&
         gantries_after.empty() && same_cycle_time() &&
         std::all_of(axes.begin(), axes.end(), [](AxisDifference const& axis) { return axis.empty(); });
}

bool MachineDifference::needs_restart() const {
  if (of_one_machine) return false;
  return std::any_of(axes.begin(), axes.end(), [](AxisDifference const& axis) {
    return std::any_of(axis.parameters.begin(), axis.parameters.end(),
                       [](ParameterChange const& change) { return change.restart && !change.equal; });
  });
}

MachineDifference compare_machines(ComparedMachine const& before, ComparedMachine const& after, bool all) {
  return Comparison(before, after, all).machines();
}

MachineDifference compare_axes(ComparedMachine const& before, ComparedAxis const& old_axis,
                               ComparedMachine const& after, ComparedAxis const& new_axis, bool all) {
  return Comparison(before, after, all).axes(old_axis, new_axis);
}

}  // namespace axisc
