#include "axisc/answers/inspect/inspect_writer.hpp"
#include "axisc/answers/sentences.hpp"
#include "axisc/answers/text_table.hpp"
#include "axisc/files/image_file.hpp"
#include "design/kernel_analysis.hpp"
#include "design/kernel_kinds.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <set>

namespace axisc::says {

constexpr Sentence slot_fir{"filter_fir, {switch}: {kernel}", "filter_fir, {switch}: {kernel}"};
constexpr Sentence slot_hsc{"HSC filter, filter[{index}], {switch}: {kernel}",
                            "HSC-Filter, filter[{index}], {switch}: {kernel}"};
constexpr Sentence on_at_start{"works from start-up", "wirkt ab dem Hochlauf"};
constexpr Sentence on_by_command{"works after an NC command", "wirkt nach einem NC-Befehl"};
constexpr Sentence kernel{"kernel {number}", "Kern {number}"};
constexpr Sentence passes{"passes unchanged", "unverändert"};
constexpr Sentence kernels{"kernel", "Kern"};
constexpr Sentence moving_average{"moving average", "gleitender Mittelwert"};
constexpr Sentence gaussian{"Gaussian", "Gauß"};
constexpr Sentence windowed_sinc{"windowed sinc", "gefensterter Sinc"};
constexpr Sentence time_delay{"time delay", "Totzeit"};
constexpr Sentence novib{"NoVib", "NoVib"};
constexpr Sentence column_taps{"taps", "Koeffizienten"};
constexpr Sentence kernel_proof{
    "kernel {number}: sum of the taps exactly {sum}, self-test of {samples} samples",
    "Kern {number}: Summe der Koeffizienten genau {sum}, Selbsttest mit {samples} Werten"};
constexpr Sentence zeros{"no gain at {frequencies} Hz", "keine Verstärkung bei {frequencies} Hz"};
constexpr Sentence zeros_more{"no gain at {frequencies} Hz and {more} more frequencies",
                              "keine Verstärkung bei {frequencies} Hz und {more} weiteren Frequenzen"};
constexpr Sentence no_zeros{"no frequency is removed entirely", "keine Frequenz wird ganz entfernt"};
constexpr Sentence channel{"channel {name}", "Kanal {name}"};
constexpr Sentence column_command{"command", "Befehl"};
constexpr Sentence column_change{"change in motion", "Wechsel in Bewegung"};
constexpr Sentence fade{"over {cycles} cycles ({ms} ms)", "über {cycles} Zyklen ({ms} ms)"};
constexpr Sentence standstill{"only at standstill", "nur im Stillstand"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr std::size_t most_zeros = 6;

SentenceRef type_text(design::KernelType type) {
  switch (type) {
    case design::KernelType::moving_average:
      return says::moving_average;
    case design::KernelType::gaussian:
      return says::gaussian;
    case design::KernelType::windowed_sinc:
      return says::windowed_sinc;
    case design::KernelType::time_delay:
      return says::time_delay;
    case design::KernelType::novib:
      break;
  }
  return says::novib;
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
  auto const when = say(slot->on_at_start ? says::on_at_start : says::on_by_command);
  return "\n  " +
         say(hsc ? says::slot_hsc : says::slot_fir, {{"index", std::to_string(slot->index)},
                                                     {"switch", when},
                                                     {"kernel", kernel_name(slot->kernel)}}) +
         "\n";
}

std::string InspectWriter::kernel_name(std::optional<std::size_t> kernel) const {
  if (!kernel) return say(says::passes);
  return say(says::kernel, {{"number", std::to_string(*kernel)}});
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
      {say(says::kernels), say(says::inspect_column_type), say(says::inspect_column_order),
       say(says::column_taps), say(says::inspect_column_frequency), say(says::inspect_column_quality),
       say(says::inspect_column_share), say(says::inspect_column_delay), say(says::inspect_column_overshoot),
       say(says::inspect_column_peak_gain)}};
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
          design::kind_of(wanted.type).uses_frequency ? exact(wanted.frequency.value) + " Hz" : "-",
          design::kind_of(wanted.type).uses_quality ? exact(wanted.quality) : "-",
          exact(wanted.share_percent) + " %",
          delay(kernel.design.group_delay_cycles),
          rounded(kernel.overshoot * 100) + " %",
          rounded(kernel.peak_gain)};
}

std::string InspectWriter::kernel_details(std::size_t index) const {
  auto const& kernel = image_.kernels[index];
  std::string text = "\n  " +
                     say(says::kernel_proof, {{"number", std::to_string(index)},
                                              {"sum", exact(kernel.design.kernel_sum)},
                                              {"samples", std::to_string(kernel.self_test_input.size())}}) +
                     "\n    ";
  auto const zeros = design::zero_frequencies(kernel.design, image_.cycle_time);
  if (zeros.empty()) return text + say(says::no_zeros) + "\n";
  std::string list;
  for (std::size_t i = 0; i < std::min(zeros.size(), most_zeros); ++i) {
    list += (i == 0 ? "" : ", ") + rounded(zeros[i].value);
  }
  if (zeros.size() <= most_zeros) return text + say(says::zeros, {{"frequencies", list}}) + "\n";
  return text +
         say(says::zeros_more, {{"frequencies", list}, {"more", std::to_string(zeros.size() - most_zeros)}}) +
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
  if (fade_cycles == 0) return say(says::standstill);
  return say(says::fade, {{"cycles", std::to_string(fade_cycles)}, {"ms", milliseconds(fade_cycles)}});
}

std::string InspectWriter::channel_text(std::size_t index) const {
  auto const& group = image_.groups[index];
  auto const name = group.name.empty() ? std::to_string(index + 1) : group.name;
  std::vector<std::vector<std::string>> rows{{say(says::column_command)}};
  for (auto const axis : group.members) rows.front().push_back(axis_label(image_, axis));
  rows.front().push_back(say(says::column_change));
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
    rows.back().push_back(image_.axes[axis].slot ? say(says::passes) : "-");
  }
  rows.back().push_back(change(group.off_fade_cycles));
  return "\n" + say(says::channel, {{"name", name}}) + "\n" + text_table(rows, 2);
}

}  // namespace axisc
