// Labels that many answers have.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::labels {

inline constexpr Sentence cycle_time{"NC cycle time", "NC-Zykluszeit"};
inline constexpr Sentence axis{"axis", "Achse"};
inline constexpr Sentence axes{"axes", "Achsen"};
inline constexpr Sentence channel{"channel", "Kanal"};
inline constexpr Sentence number{"number", "Nummer"};
inline constexpr Sentence name{"name", "Name"};
inline constexpr Sentence list{"list", "Liste"};
inline constexpr Sentence type{"type", "Typ"};
inline constexpr Sentence parameter{"parameter", "Parameter"};
inline constexpr Sentence value{"value", "Wert"};
inline constexpr Sentence meaning{"meaning", "Bedeutung"};
inline constexpr Sentence from{"from", "aus"};
inline constexpr Sentence order{"order", "Ordnung"};
inline constexpr Sentence frequency{"frequency", "Frequenz"};
inline constexpr Sentence quality{"quality", "Güte"};
inline constexpr Sentence share{"share", "Anteil"};
inline constexpr Sentence delay{"delay", "Verzögerung"};
inline constexpr Sentence overshoot{"overshoot", "Überschwingen"};
inline constexpr Sentence peak_gain{"peak gain", "Spitzenverstärkung"};
inline constexpr Sentence time{"time", "Zeit"};
inline constexpr Sentence phase{"phase", "Phase"};
inline constexpr Sentence group_delay{"group delay", "Gruppenlaufzeit"};
inline constexpr Sentence difference{"difference", "Differenz"};
inline constexpr Sentence deviation{"deviation", "Abweichung"};
inline constexpr Sentence gain{"gain", "Verstärkung"};
inline constexpr Sentence magnitude{"magnitude", "Betrag"};
inline constexpr Sentence before{"before", "vorher"};
inline constexpr Sentence what{"what", "was"};
inline constexpr Sentence lists{"lists", "Listen"};
inline constexpr Sentence line{"line", "Zeile"};
inline constexpr Sentence damping{"damping", "Dämpfung"};
inline constexpr Sentence drive{"drive", "Antrieb"};
inline constexpr Sentence compiler{"compiled by", "kompiliert mit"};
inline constexpr Sentence one_axis{"axis {axis}", "Achse {axis}"};
inline constexpr Sentence one_channel{"channel {name}", "Kanal {name}"};
inline constexpr Sentence step_overshoot{"overshoot of a step", "Überschwingen eines Sprungs"};
inline constexpr Sentence present{"present", "jetzt"};
inline constexpr Sentence contour_deviation{"contour deviation [µm]", "Bahnabweichung [µm]"};

}  // namespace axisc::labels
