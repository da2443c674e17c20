#include "axisc/answers/inspect/inspect_formats.hpp"
#include "axisc/answers/inspect/inspect_writer.hpp"
#include "axisc/answers/sentences.hpp"
#include "axisc/answers/text_table.hpp"
#include "axisc/asked/filter_symbols.hpp"
#include "axisc/files/image_file.hpp"
#include "axisc/files/key_file.hpp"
#include "diagnostics/format_number.hpp"
#include "image/image_readings.hpp"

namespace axisc::says {

constexpr Sentence heading{"{file}: coefficient image, format {format}, {bytes} bytes, axes: {axes}",
                           "{file}: Koeffizientenabbild, Format {format}, {bytes} Bytes, Achsen: {axes}"};
constexpr Sentence compiler{"compiled by", "übersetzt mit"};
constexpr Sentence image_version{"image version", "Abbildversion"};
constexpr Sentence signature{"signature", "Signatur"};
constexpr Sentence inspect_unsigned{"none", "keine"};
constexpr Sentence inspect_signed{"Ed25519, key {key} (not checked)",
                                  "Ed25519, Schlüssel {key} (nicht geprüft)"};
constexpr Sentence signed_right{"Ed25519, key {key}, valid", "Ed25519, Schlüssel {key}, gültig"};
constexpr Sentence memory{"memory", "Speicher"};
constexpr Sentence memory_value{"{bytes} bytes, aligned to {alignment}",
                                "{bytes} Bytes, ausgerichtet auf {alignment}"};
constexpr Sentence digest{"all sources", "alle Quellen"};
constexpr Sentence sources{"lists", "Listen"};
constexpr Sentence stripped{"none (compiled with --strip)", "keine (mit --strip übersetzt)"};
constexpr Sentence axis{"axis {axis}, number {number}, {type}", "Achse {axis}, Nummer {number}, {type}"};
constexpr Sentence translatory{"translatory", "translatorisch"};
constexpr Sentence rotary{"rotary", "rotatorisch"};
constexpr Sentence spindle{"spindle", "Spindel"};
constexpr Sentence velocity{"velocity limit", "Höchstgeschwindigkeit"};
constexpr Sentence acceleration{"acceleration limit", "Höchstbeschleunigung"};
constexpr Sentence window{"position window", "Positionsfenster"};
constexpr Sentence computed_as{"computed as", "gerechnet als"};
constexpr Sentence chain{"setpoint chain", "Sollwertkette"};
constexpr Sentence chain_value{"delay {cycles} cycles ({ms} ms), peak gain {gain}",
                               "Verzögerung {cycles} Zyklen ({ms} ms), Spitzenverstärkung {gain}"};
constexpr Sentence gain_at_most{"at most {gain}", "höchstens {gain}"};
constexpr Sentence step{"step", "Sprung"};
constexpr Sentence step_value{"settles within 0.01 % in {time}, overshoots by {overshoot} %",
                              "nach {time} auf 0,01 % eingeschwungen, Überschwingen {overshoot} %"};
constexpr Sentence step_unsettled{"does not settle within 0.01 % in {time}, overshoots by {overshoot} %",
                                  "nach {time} nicht auf 0,01 % eingeschwungen, Überschwingen {overshoot} %"};
constexpr Sentence magnitude{"magnitude", "Betrag"};
constexpr Sentence corner_at{"-3 dB at {frequency} Hz", "-3 dB bei {frequency} Hz"};
constexpr Sentence no_corner{"above -3 dB up to 0.5/T", "über -3 dB bis 0,5/T"};
constexpr Sentence magnitude_at{"{decibels} dB at {frequency} Hz", "{decibels} dB bei {frequency} Hz"};
constexpr Sentence nothing_at{"nothing passes at {frequency} Hz", "bei {frequency} Hz geht nichts durch"};
constexpr Sentence no_filter{"no filter: setpoints pass unchanged",
                             "kein Filter: Sollwerte gehen unverändert durch"};
constexpr Sentence setpoint{"setpoint", "Sollwert"};
constexpr Sentence inspect_interface{"interface", "Schnittstelle"};
constexpr Sentence column_prototype{"prototype", "Prototyp"};
constexpr Sentence column_time_constant{"time constant", "Zeitkonstante"};
constexpr Sentence proof{
    "largest pole radius {radius}, gain at 0 Hz {gain}, self-test of {samples} samples",
    "größter Polradius {radius}, Verstärkung bei 0 Hz {gain}, Selbsttest mit {samples} Werten"};
constexpr Sentence pure_delay{"pure delay of {cycles} cycles", "reine Verzögerung um {cycles} Zyklen"};
constexpr Sentence pass_through{"passes setpoints through unchanged", "lässt Sollwerte unverändert durch"};

}  // namespace axisc::says

namespace axisc {

namespace {

class InspectText : public InspectWriter {
 public:
  using InspectWriter::InspectWriter;

  std::string header(Shown const& shown) const {
    std::string text = say(says::heading, {{"file", shown.file},
                                           {"format", version()},
                                           {"bytes", std::to_string(image_.size)},
                                           {"axes", std::to_string(image_.axes.size())}}) +
                       "\n";
    text += row(says::inspect_cycle_time, exact(image_.cycle_time.microseconds()) + " µs");
    text += row(says::compiler, "axisc " + image_.compiler_version);
    text += row(says::image_version, std::to_string(image_.image_version));
    text += row(says::signature, signature(shown));
    if (shown.memory) {
      text += row(says::memory, say(says::memory_value, {{"bytes", std::to_string(*shown.memory)},
                                                         {"alignment", std::to_string(AXISRT_ALIGNMENT)}}));
    }
    text += row(says::digest, "SHA-256 " + hexadecimal(image_.source_digest));
    std::vector<std::vector<std::string>> lists;
    for (auto const& list : image_.lists) lists.push_back({list.name, "SHA-256 " + hexadecimal(list.sha256)});
    if (lists.empty()) return text + row(says::sources, say(says::stripped));
    return text + "  " + say(says::sources) + "\n" + text_table(lists, 4);
  }

  std::string axis(std::size_t index, image::ChainFigures const& chain) const {
    auto const& axis = image_.axes[index];
    bool const linear = axis.type == 1;
    bool const reaches_gain = image::reaches_peak_gain(image_, index);
    std::string text = say(says::axis, {{"axis", axis_label(image_, index)},
                                        {"number", std::to_string(axis.number)},
                                        {"type", say(type_text(axis.type))}}) +
                       "\n";
    text += row(says::velocity, rounded(axis.velocity_limit / 1e3) + (linear ? " mm/s" : " °/s"));
    text += row(says::acceleration, rounded(axis.acceleration_limit) + (linear ? " mm/s²" : " °/s²"));
    text += row(says::window, linear ? rounded(axis.position_window / 10) + " µm"
                                     : rounded(axis.position_window / 1e4) + " °");
    text += row(says::chain, say(says::chain_value, {{"cycles", rounded(axis.delay_cycles)},
                                                     {"ms", milliseconds(axis.delay_cycles)},
                                                     {"gain", gain(axis.peak_gain, reaches_gain)}}));
    if (auto const readings = image::readings_of(image_, index); readings != design::Readings{}) {
      text += row(says::computed_as, image::readings_text(readings));
    }
    if (!axis.filters.empty() || axis.slot) text += step(chain) + magnitudes(index);
    if (!axis.filters.empty() || !axis.slot) text += filters(axis, axis.filters, false);
    text += slot_text(index) + filters(axis, axis.interface_filters, true);
    return text + control_text(index);
  }

 private:
  std::string gain(double peak_gain, bool is_reached) const {
    return is_reached ? rounded(peak_gain) : say(says::gain_at_most, {{"gain", rounded(peak_gain)}});
  }

  std::string step(image::ChainFigures const& chain) const {
    auto const cycles = chain.settling_cycles.value_or(image::longest_settling);
    return row(says::step, say(chain.settling_cycles ? says::step_value : says::step_unsettled,
                               {{"time", delay(static_cast<double>(cycles))},
                                {"overshoot", rounded(chain.overshoot * 100)}}));
  }

  /// Where the chain begins to weaken setpoints, and what it leaves of those that its filters are made for.
  std::string magnitudes(std::size_t index) const {
    auto const corner = image::corner_frequency(image_, index);
    std::string text =
        corner ? say(says::corner_at, {{"frequency", rounded(corner->value)}}) : say(says::no_corner);
    for (auto const frequency : image::characteristic_frequencies(image_, index)) {
      auto const decibels = image::decibels(image::chain_magnitude(image_, index, frequency));
      text +=
          "; " + say(decibels ? says::magnitude_at : says::nothing_at,
                     {{"decibels", rounded(decibels.value_or(0))}, {"frequency", rounded(frequency.value)}});
    }
    return row(says::magnitude, text);
  }

  std::string signature(Shown const& shown) const {
    if (!shown.signer) return say(says::inspect_unsigned);
    return say(shown.signature_checked ? says::signed_right : says::inspect_signed,
               {{"key", key_name(*shown.signer)}});
  }
  std::string version() const {
    return std::to_string(image_.format_major) + "." + std::to_string(image_.format_minor);
  }
  static SentenceRef type_text(std::uint32_t type) {
    if (type == 2) return says::rotary;
    return type == 4 ? says::spindle : says::translatory;
  }

  std::string filters(image::ImageAxis const& axis, std::vector<image::ImageFilter> const& chain,
                      bool interface) const {
    if (chain.empty()) return interface ? "" : "\n  " + say(says::no_filter) + "\n";
    std::vector<std::vector<std::string>> rows{
        {say(interface ? says::inspect_interface : says::setpoint), say(says::inspect_column_type),
         say(says::column_prototype), say(says::inspect_column_order), say(says::inspect_column_frequency),
         say(says::inspect_column_quality), say(says::column_time_constant), say(says::inspect_column_share),
         say(says::inspect_column_delay), say(says::inspect_column_overshoot),
         say(says::inspect_column_peak_gain)}};
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
            design::uses_frequency(type) ? exact(wanted.frequency.value) + " Hz" : "-",
            design::uses_quality(type) ? exact(wanted.quality) : "-",
            design::uses_time_constant(type) ? exact(wanted.time_constant.value) + " µs" : "-",
            exact(wanted.share_percent) + " %",
            say(says::inspect_delay_value, {{"cycles", rounded(made.group_delay_cycles)},
                                            {"ms", milliseconds(made.group_delay_cycles)}}),
            rounded(filter.overshoot * 100) + " %",
            gain(filter.peak_gain, image::reaches_peak_gain(filter))};
  }

  std::string details(image::ImageAxis const& axis, image::ImageFilter const& filter, bool interface) const {
    auto const& made = filter.design;
    std::string text = "\n  " + filter_path(filter, interface) + ": " +
                       say(says::proof, {{"radius", format_rounded(made.pole_radius, 9)},
                                         {"gain", rounded(made.dc_gain)},
                                         {"samples", std::to_string(filter.self_test_input.size())}}) +
                       "\n";
    if (made.realisation == design::Realisation::delay) {
      text += "    " + say(says::pure_delay, {{"cycles", std::to_string(made.delay_cycles)}}) + "\n";
    }
    if (made.realisation == design::Realisation::pass_through) {
      text += "    " + say(says::pass_through) + "\n";
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
  InspectText const text_writer(shown.image, language);
  std::string text = text_writer.header(shown);
  for (std::size_t i = 0; i < shown.axes.size(); ++i) {
    text += "\n" + text_writer.axis(shown.axes[i], shown.figures[i]);
  }
  text += text_writer.kernels_text(shown.axes) + text_writer.channels_text(shown.axes);
  return text;
}

}  // namespace axisc
