#include "axisc/answers/inspect/inspect_answer.hpp"

#include "axisc/answers/axis_type.hpp"
#include "axisc/answers/inspect/inspect_parts.hpp"
#include "axisc/answers/labels.hpp"
#include "axisc/files/key_file.hpp"
#include "codegen/source_digest.hpp"
#include "image/checked_bounds.hpp"
#include "image/image_readings.hpp"
#include "image/signature.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace axisc::says {

constexpr Sentence image{"coefficient image {file}", "Koeffizientenabbild {file}"};
constexpr Sentence format{"format", "Format"};
constexpr Sentence size{"size", "Größe"};
constexpr Sentence image_version{"image version", "Abbildversion"};
constexpr Sentence signature{"signature", "Signatur"};
constexpr Sentence not_signed{"none", "keine"};
constexpr Sentence not_checked{"Ed25519, key {key} (not checked)",
                               "Ed25519, Schlüssel {key} (nicht geprüft)"};
constexpr Sentence valid{"Ed25519, key {key}, valid", "Ed25519, Schlüssel {key}, gültig"};
constexpr Sentence bounds{"proved bounds", "bewiesene Schranken"};
constexpr Sentence bound_records{"{records} records (`axisc certify` checks them)",
                                 "{records} Datensätze (`axisc certify` prüft sie)"};
constexpr Sentence no_bounds{"none", "keine"};
constexpr Sentence memory{"memory", "Speicher"};
constexpr Sentence memory_value{"{bytes}, aligned to {alignment}", "{bytes}, ausgerichtet auf {alignment}"};
constexpr Sentence digest{"all sources", "alle Quellen"};
constexpr Sentence sha{"SHA-256 {digest}", "SHA-256 {digest}"};
constexpr Sentence stripped{"none (compiled with --strip)", "keine (mit --strip kompiliert)"};
constexpr Sentence velocity{"velocity limit", "Höchstgeschwindigkeit"};
constexpr Sentence acceleration{"acceleration limit", "Höchstbeschleunigung"};
constexpr Sentence window{"position window", "Positionsfenster"};
constexpr Sentence computed_as{"computed as", "gerechnet als"};
constexpr Sentence step{"step", "Sprung"};
constexpr Sentence settled{"settles within 0.01 % in {cycles} ({time})",
                           "nach {cycles} ({time}) auf 0,01 % eingeschwungen"};
constexpr Sentence unsettled{"does not settle within 0.01 % in {cycles} ({time})",
                             "nach {cycles} ({time}) nicht auf 0,01 % eingeschwungen"};
constexpr Sentence corner{"-3 dB", "-3 dB"};
constexpr Sentence no_corner{"nowhere up to 0.5/T", "nirgends bis 0,5/T"};
constexpr Sentence nothing_passes{"nothing passes", "nichts geht durch"};
constexpr Sentence no_filter{"no filter: setpoints pass unchanged",
                             "kein Filter: Sollwerte gehen unverändert durch"};
constexpr Sentence slot{"linear-phase filter", "linearphasiger Filter"};
constexpr Sentence guard_slot{"Vibration Guard", "Vibration Guard"};
constexpr Sentence kernels{"kernels", "Kerne"};
constexpr Sentence from_start{"{path}, works from start-up: {kernel}",
                              "{path}, wirkt ab dem Hochlauf: {kernel}"};
constexpr Sentence by_command{"{path}, works after an NC command: {kernel}",
                              "{path}, wirkt nach einem NC-Befehl: {kernel}"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

std::string slot_path(image::ImageSlot const& slot) {
  switch (slot.family) {
    case machine::KernelFamily::hsc: return "filter[" + std::to_string(slot.index) + "]";
    case machine::KernelFamily::fir: return "filter_fir";
    case machine::KernelFamily::guard: return "vib_guard";
  }
  return {};
}

std::string_view family_word(machine::KernelFamily family) {
  switch (family) {
    case machine::KernelFamily::hsc: return "HSC";
    case machine::KernelFamily::fir: return "FIR";
    case machine::KernelFamily::guard: return "VIB GUARD";
  }
  return {};
}

/// The step response and the magnitudes of a setpoint chain.
Section chain_section(image::ImageContents const& image, std::size_t axis, image::ChainFigures const& chain) {
  auto const cycles = static_cast<double>(chain.settling_cycles.value_or(image::longest_settling));
  auto const time = rounded(cycles * image.cycle_time.seconds() * 1e3, Unit::millisecond);
  Words const step{chain.settling_cycles ? says::settled : says::unsettled,
                   {{"cycles", exact(cycles, Unit::cycle)}, {"time", time}}};
  Value corner = Nothing{Words(says::no_corner)};
  if (auto const frequency = image::corner_frequency(image, axis)) {
    corner = rounded(frequency->value, Unit::hertz);
  }
  Table magnitudes{.key = "magnitudes"};
  for (auto const frequency : image::characteristic_frequencies(image, axis)) {
    Value magnitude = Nothing{Words(says::nothing_passes)};
    if (auto const decibels = image::decibels(image::chain_magnitude(image, axis, frequency))) {
      magnitude = rounded(*decibels, Unit::decibel);
    }
    add_row(magnitudes, {{"frequency_hz", labels::frequency, rounded(frequency.value, Unit::hertz)},
                         {"magnitude_db", labels::magnitude, std::move(magnitude)}});
  }
  Facts facts{{data("settling_ms", value_if(chain.settling_cycles.has_value(), time)),
               shown(says::step, step),
               {"overshoot_percent", labels::overshoot, rounded(chain.overshoot * 100, Unit::percent)},
               {"corner_frequency_hz", says::corner, std::move(corner)}}};
  if (auto const readings = image::readings_of(image, axis); readings != design::Readings{}) {
    facts.fields.push_back(shown(says::computed_as, image::readings_text(readings)));
  }
  auto const& slot = image.axes[axis].slot;
  if (slot) {
    facts.fields.push_back(shown(slot->family == machine::KernelFamily::guard ? says::guard_slot : says::slot,
                                 Words(slot->on_at_start ? says::from_start : says::by_command,
                                       {{"path", slot_path(*slot)}, {"kernel", kernel_name(slot->kernel)}})));
  }
  bool const is_filtered = slot || !image.axes[axis].filters.empty();
  return {.key = "chain",
          .title = {},
          .blocks = {std::move(facts), std::move(magnitudes)},
          .audience = is_filtered ? Audience::all : Audience::programs};
}

Section axis_section(image::ImageContents const& image, std::size_t index,
                     image::ChainFigures const& figures) {
  auto const& axis = image.axes[index];
  Section section{.key = {},
                  .title = Words(labels::one_axis, {{"axis", axis_label(image, index)}}),
                  .blocks = {chain_section(image, index, figures)}};
  auto& blocks = section.blocks;
  if (axis.filters.empty() && !axis.slot) blocks.emplace_back(Paragraph{says::no_filter});
  blocks.emplace_back(filters_table(axis, false, image.cycle_time));
  blocks.emplace_back(filters_table(axis, true, image.cycle_time));
  if (auto const& slot = axis.slot) {
    blocks.emplace_back(
        data_section("linear_phase_filter",
                     {data("path", slot_path(*slot)), data("family", family_word(slot->family)),
                      data("on_at_start", slot->on_at_start), data("kernel", index_value(slot->kernel)),
                      data("channel", index_value(slot->group))}));
  }
  bool const is_guard = axis.slot && axis.slot->kernel && axis.slot->family == machine::KernelFamily::guard;
  if (is_guard) blocks.emplace_back(guard_section(image.kernels[*axis.slot->kernel], image.cycle_time));
  if (axis.control) blocks.emplace_back(control_section(image, index));
  blocks.emplace_back(values_table("values", axis.values, Audience::programs));
  return section;
}

Table axes_table(image::ImageContents const& image, std::span<std::size_t const> axes,
                 std::span<image::ChainFigures const> figures) {
  Table table{.key = "axes"};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    auto const& axis = image.axes[axes[i]];
    bool const linear = axis.type == 1;
    bool const gain_is_reached = image::reaches_peak_gain(image, axes[i]);
    add_row(table,
            {{"name", labels::axis, axis_label(image, axes[i])},
             {"number", labels::number, axis.number},
             {"type", labels::type, axis_type_symbol(static_cast<machine::AxisType>(axis.type))},
             data("position_unit", linear ? "0.1 um" : "1e-4 deg"),
             data("position_window", exact(axis.position_window)),
             data("velocity_limit", exact(axis.velocity_limit)),
             data("acceleration_limit", exact(axis.acceleration_limit)),
             shown(says::velocity, rounded(axis.velocity_limit / 1e3,
                                           linear ? Unit::millimetre_per_second : Unit::degree_per_second)),
             shown(says::acceleration,
                   rounded(axis.acceleration_limit,
                           linear ? Unit::millimetre_per_second_squared : Unit::degree_per_second_squared)),
             shown(says::window, linear ? rounded(axis.position_window / 10, Unit::micrometre)
                                        : rounded(axis.position_window / 1e4, Unit::degree)),
             {"delay_cycles", labels::delay, rounded(axis.delay_cycles, Unit::cycle)},
             {"delay_ms", labels::delay,
              rounded(axis.delay_cycles * image.cycle_time.seconds() * 1e3, Unit::millisecond)},
             data("peak_gain", exact(axis.peak_gain)),
             data("peak_gain_is_reached", gain_is_reached),
             shown(labels::peak_gain, peak_gain_value(axis.peak_gain, gain_is_reached))});
    table.details.push_back(axis_section(image, axes[i], figures[i]));
  }
  return table;
}

/// Those that the axes may execute.
std::vector<std::size_t> reachable_kernels(image::ImageContents const& image,
                                           std::span<std::size_t const> axes) {
  std::set<std::size_t> kernels;
  auto const add = [&](std::optional<std::size_t> kernel) {
    if (kernel) kernels.insert(*kernel);
  };
  for (auto const axis : axes) {
    if (image.axes[axis].slot) add(image.axes[axis].slot->kernel);
    for (auto const& group : image.groups) {
      auto const member = std::find(group.members.begin(), group.members.end(), axis);
      if (member == group.members.end()) continue;
      for (auto const& bank : group.banks) {
        add(bank.kernels[static_cast<std::size_t>(member - group.members.begin())]);
      }
    }
  }
  return {kernels.begin(), kernels.end()};
}

/// About the image as a whole.
std::vector<Block> head(InspectQuestion const& question, ImageFile const& file) {
  auto const& image = file.contents;
  auto const signer = image::signer(file.bytes.bytes());
  auto const digest = codegen::hexadecimal(image.source_digest);
  Facts facts{
      {data("file", question.image),
       shown(says::format, std::to_string(image.format_major) + "." + std::to_string(image.format_minor)),
       {"size", says::size, exact(static_cast<double>(image.size), Unit::byte)},
       {"cycle_time_us", labels::cycle_time, exact(image.cycle_time.microseconds(), Unit::microsecond)},
       data("compiler_version", image.compiler_version),
       shown(labels::compiler, "axisc " + image.compiler_version),
       {"image_version", says::image_version, image.image_version}}};
  auto& fields = facts.fields;
  std::vector<Block> objects{
      data_section("format", {data("major", image.format_major), data("minor", image.format_minor)})};
  if (signer) {
    auto const key = key_name(*signer);
    fields.push_back(
        shown(says::signature, Words(question.is_checked ? says::valid : says::not_checked, {{"key", key}})));
    objects.emplace_back(data_section(
        "signature", {data("algorithm", "Ed25519"), data("key", key), data("checked", question.is_checked)}));
  } else {
    fields.push_back({"signature", says::signature, Nothing{Words(says::not_signed)}});
  }
  auto const bound_records = image::bound_record_count(file.bytes.bytes());
  fields.push_back(data("bound_records", bound_records ? Value(exact(*bound_records)) : Value()));
  fields.push_back(shown(says::bounds, bound_records
                                           ? Words(says::bound_records, {{"records", exact(*bound_records)}})
                                           : Words(says::no_bounds)));
  if (question.level) {
    auto const bytes = image::runtime_memory(file.bytes.bytes(), *question.level);
    fields.push_back(shown(
        says::memory, Words(says::memory_value, {{"bytes", exact(static_cast<double>(bytes), Unit::byte)},
                                                 {"alignment", AXISRT_ALIGNMENT}})));
    objects.emplace_back(data_section("memory", {data("bytes", bytes), data("alignment", AXISRT_ALIGNMENT)}));
  }
  fields.push_back(data("source_digest", digest));
  fields.push_back(shown(says::digest, Words(says::sha, {{"digest", digest}})));
  if (image.lists.empty()) fields.push_back(shown(labels::lists, Words(says::stripped)));
  Table lists{.key = "lists"};
  for (auto const& [name, sha256] : image.lists) {
    add_row(lists,
            {{"name", labels::list, name}, {"sha256", as_given("SHA-256"), codegen::hexadecimal(sha256)}});
  }
  std::vector<Block> blocks{std::move(facts), std::move(lists)};
  blocks.insert(blocks.end(), objects.begin(), objects.end());
  return blocks;
}

}  // namespace

std::vector<Block> inspect_axes(image::ImageContents const& image, std::span<std::size_t const> axes,
                                std::span<image::ChainFigures const> figures, Audience audience) {
  std::vector<Block> blocks{axes_table(image, axes, figures)};
  auto const kernels = reachable_kernels(image, axes);
  std::vector<std::size_t> all(image.kernels.size());
  std::iota(all.begin(), all.end(), 0U);
  // Finding the zeros of a kernel takes time: one table serves people and programs where it can.
  bool const serves_all = !kernels.empty() && kernels == all;
  if (!serves_all && audience != Audience::people) {
    blocks.emplace_back(kernels_table(image, all, Audience::programs));
  }
  if (!kernels.empty()) {
    auto table = kernels_table(image, kernels, serves_all ? audience : Audience::people);
    blocks.emplace_back(part(says::kernels, {std::move(table)}));
  }
  blocks.emplace_back(channel_sections(image, axes));
  return blocks;
}

Document inspect_answer(InspectQuestion const& question, ImageFile const& file) {
  auto const axes = chosen_axes(file.contents, question.axis);
  Document answer{.version = 2,
                  .title = Words(says::image, {{"file", question.image}}),
                  .blocks = head(question, file),
                  .csv_table = "axes"};
  auto const more = inspect_axes(
      file.contents, axes, image::chain_figures(file.bytes.bytes(), file.contents, axes), Audience::all);
  answer.blocks.insert(answer.blocks.end(), more.begin(), more.end());
  return answer;
}

}  // namespace axisc
