#include "cli/options/filter_symbols.hpp"
#include "cli/files/image_file.hpp"
#include "cli/formats/inspect_formats.hpp"
#include "cli/formats/inspect_writer.hpp"
#include "cli/files/key_file.hpp"
#include "cli/report/text_table.hpp"
#include "diagnostics/format_number.hpp"

namespace axisc::cli {

namespace {

class TextForm : public InspectWriter {
 public:
  using InspectWriter::InspectWriter;

  std::string header(Shown const& shown) const {
    std::string text = say(Text::inspect_heading, {{"file", shown.file},
                                                   {"format", version()},
                                                   {"bytes", std::to_string(image_.size)},
                                                   {"axes", std::to_string(image_.axes.size())}}) +
                       "\n";
    text += row(Text::inspect_cycle_time, format_exact(image_.cycle_time.microseconds()) + " µs");
    text += row(Text::inspect_compiler, "axisc " + image_.compiler_version);
    text += row(Text::inspect_image_version, std::to_string(image_.image_version));
    text += row(Text::inspect_signature, signature(shown));
    if (shown.memory) {
      text += row(Text::inspect_memory,
                  say(Text::inspect_memory_value, {{"bytes", std::to_string(*shown.memory)},
                                                   {"alignment", std::to_string(AXISRT_ALIGNMENT)}}));
    }
    text += row(Text::inspect_digest, "SHA-256 " + hexadecimal(image_.source_digest));
    std::vector<std::vector<std::string>> lists;
    for (auto const& list : image_.lists) lists.push_back({list.name, "SHA-256 " + hexadecimal(list.sha256)});
    if (lists.empty()) return text + row(Text::inspect_sources, say(Text::inspect_stripped));
    return text + "  " + say(Text::inspect_sources) + "\n" + text_table(lists, 4);
  }

  std::string axis(std::size_t index) const {
    auto const& axis = image_.axes[index];
    bool const linear = axis.type == 1;
    std::string text = say(Text::inspect_axis, {{"axis", axis_label(image_, index)},
                                                {"number", std::to_string(axis.number)},
                                                {"type", say(type_text(axis.type))}}) +
                       "\n";
    text += row(Text::inspect_velocity, rounded(axis.velocity_limit / 1e3) + (linear ? " mm/s" : " °/s"));
    text += row(Text::inspect_acceleration, rounded(axis.acceleration_limit) + (linear ? " mm/s²" : " °/s²"));
    text += row(Text::inspect_window, linear ? rounded(axis.position_window / 10) + " µm"
                                             : rounded(axis.position_window / 1e4) + " °");
    text += row(Text::inspect_chain, say(Text::inspect_chain_value, {{"cycles", rounded(axis.delay_cycles)},
                                                                     {"ms", milliseconds(axis.delay_cycles)},
                                                                     {"gain", rounded(axis.peak_gain)}}));
    if (!axis.filters.empty() || !axis.slot) text += filters(axis, axis.filters, false);
    text += slot_text(index) + filters(axis, axis.interface_filters, true);
    return text + control_text(index);
  }

 private:
  std::string signature(Shown const& shown) const {
    if (!shown.signer) return say(Text::inspect_unsigned);
    return say(shown.signature_checked ? Text::inspect_signed_right : Text::inspect_signed,
               {{"key", key_name(*shown.signer)}});
  }
  std::string version() const {
    return std::to_string(image_.format_major) + "." + std::to_string(image_.format_minor);
  }
  static Text type_text(std::uint32_t type) {
    if (type == 2) return Text::inspect_rotary;
    return type == 4 ? Text::inspect_spindle : Text::inspect_translatory;
  }

  std::string filters(image::ImageAxis const& axis, std::vector<image::ImageFilter> const& chain,
                      bool interface) const {
    if (chain.empty()) return interface ? "" : "\n  " + say(Text::inspect_no_filter) + "\n";
    std::vector<std::vector<std::string>> rows{
        {say(interface ? Text::inspect_interface : Text::inspect_setpoint), say(Text::inspect_column_type),
         say(Text::inspect_column_prototype), say(Text::inspect_column_order),
         say(Text::inspect_column_frequency), say(Text::inspect_column_quality),
         say(Text::inspect_column_time_constant), say(Text::inspect_column_share),
         say(Text::inspect_column_delay), say(Text::inspect_column_overshoot),
         say(Text::inspect_column_peak_gain)}};
    for (auto const& filter : chain) rows.push_back(figures_of(filter));
    std::string text = "\n" + text_table(rows, 2);
    for (auto const& filter : chain) text += details(axis, filter, interface);
    return text;
  }

  std::vector<std::string> figures_of(image::ImageFilter const& filter) const {
    auto const& wanted = filter.specification;
    auto const& made = filter.design;
    auto const type = wanted.type;
    return {"filter[" + std::to_string(filter.index) + "]",
            std::string(type_word(type)),
            design::uses_prototype(type) ? std::string(prototype_word(wanted.prototype)) : "-",
            design::computes_order(type) ? "-" : std::to_string(wanted.order),
            design::uses_frequency(type) ? format_exact(wanted.frequency.value) + " Hz" : "-",
            design::uses_quality(type) ? format_exact(wanted.quality) : "-",
            design::uses_time_constant(type) ? format_exact(wanted.time_constant.value) + " µs" : "-",
            format_exact(wanted.share_percent) + " %",
            say(Text::inspect_delay_value, {{"cycles", rounded(made.group_delay_cycles)},
                                            {"ms", milliseconds(made.group_delay_cycles)}}),
            rounded(filter.overshoot * 100) + " %",
            rounded(filter.peak_gain)};
  }

  std::string details(image::ImageAxis const& axis, image::ImageFilter const& filter,
                      bool interface) const {
    auto const& made = filter.design;
    std::string text =
        "\n  " + filter_path(filter, interface) + ": " +
        say(Text::inspect_proof, {{"radius", format_rounded(made.pole_radius, 9)},
                                  {"gain", rounded(made.dc_gain)},
                                  {"samples", std::to_string(filter.self_test_input.size())}}) +
        "\n";
    if (made.realisation == design::Realisation::delay) {
      text += "    " + say(Text::inspect_pure_delay, {{"cycles", std::to_string(made.delay_cycles)}}) + "\n";
    }
    if (made.realisation == design::Realisation::pass_through) {
      text += "    " + say(Text::inspect_pass_through) + "\n";
    }
    for (std::size_t i = 0; i < made.sections.size(); ++i) text += section(i, made);
    std::vector<std::vector<std::string>> settings;
    for (auto const& value : settings_of(axis, filter, interface)) {
      settings.push_back({value.name, value.value, value.list + ":" + std::to_string(value.line)});
    }
    return text + text_table(settings, 4);
  }
};

}  // namespace

std::string inspect_text(Shown const& shown, Language language) {
  TextForm const form(shown.image, language);
  std::string text = form.header(shown);
  for (auto const index : shown.axes) text += "\n" + form.axis(index);
  text += form.kernels_text(shown.axes) + form.channels_text(shown.axes);
  return text;
}

}  // namespace axisc::cli
