#include "cli/files/image_file.hpp"
#include "cli/formats/inspect_writer.hpp"
#include "cli/report/text_table.hpp"
#include "design/kernel_analysis.hpp"
#include "design/kernel_kinds.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <set>

namespace axisc::cli {

namespace {

constexpr std::size_t most_zeros = 6;

Text type_text(design::KernelType type) {
  switch (type) {
    case design::KernelType::moving_average:
      return Text::inspect_moving_average;
    case design::KernelType::gaussian:
      return Text::inspect_gaussian;
    case design::KernelType::windowed_sinc:
      return Text::inspect_windowed_sinc;
    case design::KernelType::time_delay:
      return Text::inspect_time_delay;
    case design::KernelType::novib:
      break;
  }
  return Text::inspect_novib;
}

bool concerns(image::ImageGroup const& group, std::span<std::size_t const> axes) {
  return std::any_of(group.members.begin(), group.members.end(), [&](std::size_t member) {
    return std::find(axes.begin(), axes.end(), member) != axes.end();
  });
}

}  // namespace

std::string InspectWriter::slot_text(std::size_t axis) const {
  auto const& slot = image_.axes[axis].slot;
  if (!slot) return {};
  bool const hsc = slot->family == machine::KernelFamily::hsc;
  auto const when = say(slot->on_at_start ? Text::inspect_on_at_start : Text::inspect_on_by_command);
  return "\n  " +
         say(hsc ? Text::inspect_slot_hsc : Text::inspect_slot_fir, {{"index", std::to_string(slot->index)},
                                                                     {"switch", when},
                                                                     {"kernel", kernel_name(slot->kernel)}}) +
         "\n";
}

std::string InspectWriter::kernel_name(std::optional<std::size_t> kernel) const {
  if (!kernel) return say(Text::inspect_passes);
  return say(Text::inspect_kernel, {{"number", std::to_string(*kernel)}});
}

std::string InspectWriter::kernels_text(std::span<std::size_t const> axes) const {
  std::set<std::size_t> reachable;
  auto const reach = [&](std::optional<std::size_t> kernel) {
    if (kernel) reachable.insert(*kernel);
  };
  for (auto const axis : axes) {
    if (image_.axes[axis].slot) reach(image_.axes[axis].slot->kernel);
  }
  for (auto const& group : image_.groups) {
    if (!concerns(group, axes)) continue;
    for (auto const& bank : group.banks) std::for_each(bank.kernels.begin(), bank.kernels.end(), reach);
  }
  if (reachable.empty()) return {};
  std::vector<std::vector<std::string>> rows{
      {say(Text::inspect_kernels), say(Text::inspect_column_type), say(Text::inspect_column_order),
       say(Text::inspect_column_taps), say(Text::inspect_column_frequency), say(Text::inspect_column_quality),
       say(Text::inspect_column_share), say(Text::inspect_column_delay), say(Text::inspect_column_overshoot),
       say(Text::inspect_column_peak_gain)}};
  for (auto const kernel : reachable) rows.push_back(kernel_row(kernel));
  std::string text = "\n" + text_table(rows, 0);
  for (auto const kernel : reachable) text += kernel_details(kernel);
  return text;
}

std::vector<std::string> InspectWriter::kernel_row(std::size_t index) const {
  auto const& kernel = image_.kernels[index];
  auto const& wanted = kernel.specification;
  return {std::to_string(index),
          say(type_text(wanted.type)),
          std::to_string(wanted.order),
          std::to_string(kernel.design.taps.size()),
          design::kind_of(wanted.type).uses_frequency ? format_exact(wanted.frequency.value) + " Hz" : "-",
          design::kind_of(wanted.type).uses_quality ? format_exact(wanted.quality) : "-",
          format_exact(wanted.share_percent) + " %",
          delay(kernel.design.group_delay_cycles),
          rounded(kernel.overshoot * 100) + " %",
          rounded(kernel.peak_gain)};
}

std::string InspectWriter::kernel_details(std::size_t index) const {
  auto const& kernel = image_.kernels[index];
  std::string text =
      "\n  " +
      say(Text::inspect_kernel_proof, {{"number", std::to_string(index)},
                                       {"sum", format_exact(kernel.design.kernel_sum)},
                                       {"samples", std::to_string(kernel.self_test_input.size())}}) +
      "\n    ";
  auto const zeros = design::zero_frequencies(kernel.design, image_.cycle_time);
  if (zeros.empty()) return text + say(Text::inspect_no_zeros) + "\n";
  std::string list;
  for (std::size_t i = 0; i < std::min(zeros.size(), most_zeros); ++i) {
    list += (i == 0 ? "" : ", ") + rounded(zeros[i].value);
  }
  if (zeros.size() <= most_zeros) return text + say(Text::inspect_zeros, {{"frequencies", list}}) + "\n";
  return text +
         say(Text::inspect_zeros_more,
             {{"frequencies", list}, {"more", std::to_string(zeros.size() - most_zeros)}}) +
         "\n";
}

std::string InspectWriter::channels_text(std::span<std::size_t const> axes) const {
  std::string text;
  for (std::size_t i = 0; i < image_.groups.size(); ++i) {
    if (concerns(image_.groups[i], axes)) text += channel_text(i);
  }
  return text;
}

std::string InspectWriter::change(std::uint32_t fade_cycles) const {
  if (fade_cycles == 0) return say(Text::inspect_standstill);
  return say(Text::inspect_fade,
             {{"cycles", std::to_string(fade_cycles)}, {"ms", milliseconds(fade_cycles)}});
}

std::string InspectWriter::channel_text(std::size_t index) const {
  auto const& group = image_.groups[index];
  auto const name = group.name.empty() ? std::to_string(index + 1) : group.name;
  std::vector<std::vector<std::string>> rows{{say(Text::inspect_column_command)}};
  for (auto const axis : group.members) rows.front().push_back(axis_label(image_, axis));
  rows.front().push_back(say(Text::inspect_column_change));
  for (auto const& bank : group.banks) {
    auto const keywords = bank.hsc ? std::string("HSC") : to_text(bank.parameters);
    rows.push_back({keywords.empty() ? "#FILTER ON" : "#FILTER ON [" + keywords + "]"});
    bool any = false;
    for (std::size_t member = 0; member < group.members.size(); ++member) {
      auto const& slot = image_.axes[group.members[member]].slot;
      bool const concerned = slot && (slot->family == machine::KernelFamily::hsc) == bank.hsc;
      rows.back().push_back(concerned ? kernel_name(bank.kernels[member]) : "-");
      any = any || concerned;
    }
    rows.back().push_back(any ? change(bank.fade_cycles) : "-");
  }
  rows.push_back({"#FILTER OFF"});
  for (auto const axis : group.members) {
    rows.back().push_back(image_.axes[axis].slot ? say(Text::inspect_passes) : "-");
  }
  rows.back().push_back(change(group.off_fade_cycles));
  return "\n" + say(Text::inspect_channel, {{"name", name}}) + "\n" + text_table(rows, 2);
}

}  // namespace axisc::cli
