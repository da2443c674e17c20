#include "axisc/answers/comparison/motion_words.hpp"

#include <array>

namespace axisc::says {

constexpr Sentence of_projection{"ramps along a line between axes",
                                 "Rampen entlang einer Geraden zwischen Achsen"};
constexpr Sentence of_borders{"TRAPEZ and SIN2 between blocks", "TRAPEZ und SIN2 zwischen Sätzen"};
constexpr Sentence of_sine{"the shape of SIN2", "die Form von SIN2"};
constexpr Sentence of_circle{"acceleration on circles", "Beschleunigung auf Kreisen"};
constexpr Sentence of_corner{"steps of the velocity at corners", "Geschwindigkeitssprünge an Ecken"};
constexpr Sentence of_weights{"transition weights with P-CHAN-00117 = 0",
                              "Übergangsgewichte mit P-CHAN-00117 = 0"};
constexpr Sentence of_cycles{"ramps of any length, or of whole cycles",
                             "Rampen beliebiger Länge oder aus ganzen Zyklen"};
constexpr Sentence of_hsc{"HSC across blocks, or as TRAPEZ", "HSC über Sätze hinweg oder wie TRAPEZ"};

constexpr Sentence projection_needs{
    "an oblique line of two axes with unlike ramp times, with the slope TRAPEZ",
    "eine schräge Gerade zweier Achsen mit ungleichen Rampenzeiten, mit dem Slope TRAPEZ"};
constexpr Sentence borders_needs{
    "a line of several blocks, such as 5, 10 and 20 mm, with the slope TRAPEZ",
    "eine Gerade aus mehreren Sätzen, etwa 5, 10 und 20 mm, mit dem Slope TRAPEZ"};
constexpr Sentence sine_needs{
    "one block with the slope SIN2 in which the axis reaches its acceleration, or with unlike ramp times",
    "ein Satz mit dem Slope SIN2, in dem die Achse ihre Beschleunigung erreicht, oder mit ungleichen "
    "Rampenzeiten"};
constexpr Sentence circle_needs{
    "a circle with a feed above what the acceleration of its two axes allows",
    "ein Kreis mit einem Vorschub über dem, was die Beschleunigung seiner beiden Achsen erlaubt"};
constexpr Sentence corner_needs{
    "corners between two axes, from an axis into a 45° line and back, and 90° where the transition "
    "weights of the axes differ",
    "Ecken zwischen zwei Achsen, von einer Achse in eine 45°-Gerade und zurück, und 90°, wo sich die "
    "Übergangsgewichte der Achsen unterscheiden"};
constexpr Sentence weights_needs{
    "a corner of two axes with P-CHAN-00117 = 0 where P-AXIS-00154 exceeds P-AXIS-00013, such as 1000 and "
    "100; otherwise a circle tangent to a line with P-CHAN-00009 = 1",
    "eine Ecke zweier Achsen mit P-CHAN-00117 = 0, wo P-AXIS-00154 größer als P-AXIS-00013 ist, etwa 1000 "
    "und 100; sonst ein Kreis tangential an einer Geraden mit P-CHAN-00009 = 1"};
constexpr Sentence cycles_needs{"one short block", "ein kurzer Satz"};
constexpr Sentence hsc_needs{"ten blocks of 2 mm on a line, with the slope HSC",
                             "zehn Sätze von 2 mm auf einer Geraden, mit dem Slope HSC"};

}  // namespace axisc::says

namespace axisc {

namespace {

using comparison::motion_key_count;

constexpr std::array<SentenceRef, motion_key_count> subjects{
    says::of_projection, says::of_borders, says::of_sine,   says::of_circle,
    says::of_corner,     says::of_weights, says::of_cycles, says::of_hsc};
constexpr std::array<SentenceRef, motion_key_count> needs{
    says::projection_needs, says::borders_needs, says::sine_needs,   says::circle_needs,
    says::corner_needs,     says::weights_needs, says::cycles_needs, says::hsc_needs};

}  // namespace

SentenceRef subject_of(comparison::MotionKey key) {
  return subjects.at(comparison::index_of(key));
}

SentenceRef telling_motion_of(comparison::MotionKey key) {
  return needs.at(comparison::index_of(key));
}

}  // namespace axisc
