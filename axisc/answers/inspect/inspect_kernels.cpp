#include "axisc/answers/inspect/inspect_parts.hpp"
#include "axisc/answers/labels.hpp"
#include "axisc/asked/filter_symbols.hpp"
#include "design/kernels/kernel_analysis.hpp"
#include "design/kernels/kernel_kinds.hpp"

#include <algorithm>
#include <cmath>

namespace axisc::says {

constexpr Sentence number{"kernel {number}", "Kern {number}"};
constexpr Sentence passes{"passes unchanged", "unverändert"};
constexpr Sentence kernel{"kernel", "Kern"};
constexpr Sentence taps{"taps", "Koeffizienten"};
constexpr Sentence sum{"sum of the taps", "Summe der Koeffizienten"};
constexpr Sentence zeros{"no gain at", "keine Verstärkung bei"};
constexpr Sentence command{"command", "Befehl"};
constexpr Sentence change{"change in motion", "Wechsel in Bewegung"};
constexpr Sentence fade{"over {cycles} ({time})", "über {cycles} ({time})"};
constexpr Sentence standstill{"only at standstill", "nur im Stillstand"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

bool concerns(image::ImageGroup const& group, std::span<std::size_t const> axes) {
  return std::any_of(group.members.begin(), group.members.end(), [&](std::size_t member) {
    return std::find(axes.begin(), axes.end(), member) != axes.end();
  });
}

Value change_of(std::uint32_t cycles, design::CycleTime cycle_time) {
  if (cycles == 0) return Words(says::standstill);
  return Words(says::fade, {{"cycles", exact(cycles, Unit::cycle)},
                            {"time", rounded(cycles * cycle_time.seconds() * 1e3, Unit::millisecond)}});
}

/// What each command does with the axes of a channel.
Table commands_table(image::ImageContents const& image, image::ImageGroup const& group) {
  Table table{.key = {}, .audience = Audience::people};
  auto const add = [&](std::string command, auto const& kernel_of, std::uint32_t fade_cycles) {
    std::vector<Field> row{shown(says::command, std::move(command))};
    bool is_any = false;
    for (std::size_t member = 0; member < group.members.size(); ++member) {
      auto kernel = kernel_of(member);
      is_any = is_any || !kernel.is_nothing();
      row.push_back(shown(as_given(axis_label(image, group.members[member])), std::move(kernel)));
    }
    row.push_back(shown(says::change, value_if(is_any, change_of(fade_cycles, image.cycle_time))));
    add_row(table, std::move(row));
  };
  auto const slot_of = [&](std::size_t member) { return image.axes[group.members[member]].slot; };
  for (auto const& bank : group.banks) {
    add(
        to_text(machine::FilterCommand{
            .filter_switch = machine::FilterSwitch::on, .hsc = bank.hsc, .parameters = bank.parameters}),
        [&](std::size_t member) {
          auto const& slot = slot_of(member);
          bool const is_switched = slot && slot->family == bank.family();
          return is_switched ? kernel_name(bank.kernels[member]) : Value();
        },
        bank.fade_cycles);
  }
  auto const add_off = [&](std::string command, bool guards) {
    auto const reaches = [&](std::size_t member) {
      auto const& slot = slot_of(member);
      return slot && (slot->family == machine::KernelFamily::guard) == guards;
    };
    bool is_any = false;
    for (std::size_t member = 0; member < group.members.size(); ++member) is_any = is_any || reaches(member);
    if (!is_any) return;
    add(
        std::move(command), [&](std::size_t member) { return reaches(member) ? kernel_name({}) : Value(); },
        group.off_fade_cycles);
  };
  add_off("#FILTER OFF", false);
  add_off("#VIB GUARD OFF", true);
  return table;
}

}  // namespace

Value kernel_name(std::optional<std::size_t> kernel) {
  return kernel ? Words(says::number, {{"number", *kernel}}) : Words(says::passes);
}

Table kernels_table(image::ImageContents const& image, std::span<std::size_t const> kernels,
                    Audience audience) {
  Table table{.key = "kernels", .audience = audience};
  for (auto const index : kernels) {
    auto const& kernel = image.kernels[index];
    auto const& wanted = kernel.specification;
    auto const& made = kernel.design;
    auto const& kind = design::kind_of(wanted.type);
    std::vector<double> zeros;
    for (auto const zero : design::zero_frequencies(made, image.cycle_time)) zeros.push_back(zero.value);
    add_row(table,
            {shown(says::kernel, index),
             {"type", labels::type, kernel_symbol(wanted.type)},
             {"order", labels::order, wanted.order},
             shown(says::taps, made.taps.size()),
             {"frequency_hz", labels::frequency,
              value_if(kind.uses_frequency, exact(wanted.frequency.value, Unit::hertz))},
             {"quality", labels::quality, value_if(kind.uses_quality, exact(wanted.quality))},
             {"share_percent", labels::share, exact(wanted.share_percent, Unit::percent)},
             data("reading", reading_value(wanted.reading)),
             data("computed_for", reading_value(wanted.cycle_time)),
             data("half_width", made.half_width),
             data("delay_cycles", made.delay_cycles),
             {"group_delay_cycles", labels::delay, rounded(made.group_delay_cycles, Unit::cycle)},
             {"group_delay_ms", labels::delay,
              rounded(made.group_delay_cycles * image.cycle_time.seconds() * 1e3, Unit::millisecond)},
             {"overshoot_percent", labels::overshoot, rounded(kernel.overshoot * 100, Unit::percent)},
             {"peak_gain", labels::peak_gain, rounded(kernel.peak_gain)},
             {"kernel_sum", says::sum, exact(made.kernel_sum)},
             {"self_test_samples", labels::self_test, kernel.self_test_input.size()},
             {"zeros_hz", says::zeros,
              Numbers{.values = std::move(zeros), .unit = Unit::hertz, .digits = Digits::significant(5)}},
             data("taps", Numbers{made.taps}),
             data("tail_sums", Numbers{made.tail_sums})});
  }
  return table;
}

Sections channel_sections(image::ImageContents const& image, std::span<std::size_t const> axes) {
  Sections channels{.key = "channels", .items = {}};
  for (auto const& group : image.groups) {
    Names names;
    for (auto const axis : group.members) names.push_back(axis_label(image, axis));
    Table banks{.key = "banks", .audience = Audience::programs};
    for (auto const& bank : group.banks) {
      Numbers kernels;
      for (auto const kernel : bank.kernels) {
        kernels.values.push_back(kernel ? static_cast<double>(*kernel) : std::nan(""));
      }
      add_row(banks, {data("keywords", bank.hsc ? "HSC" : to_text(bank.parameters)),
                      data("fade_cycles", bank.fade_cycles), data("kernels", std::move(kernels))});
    }
    auto const number = std::to_string(channels.items.size() + 1);
    channels.items.push_back(
        {.key = {},
         .title = Words(labels::one_channel, {{"name", group.name.empty() ? number : group.name}}),
         .blocks = {Facts{{data("axes", std::move(names))}}, std::move(banks),
                    Facts{{data("off_fade_cycles", group.off_fade_cycles)}}, commands_table(image, group)},
         .identity = {data("name", group.name)},
         .audience = concerns(group, axes) ? Audience::all : Audience::programs});
  }
  return channels;
}

}  // namespace axisc
