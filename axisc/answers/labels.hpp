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

}  // namespace axisc::labels
