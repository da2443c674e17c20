#include "schema/motion_words.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace axisc::schema::says {

constexpr Sentence exact_stop{
    "Exact stop at the end of this block: the next one begins when every axis is within P-AXIS-00236 of its "
    "setpoint. A block without motion must not have it (20003).",
    "Genauhalt am Ende dieses Satzes: der nächste beginnt, wenn jede Achse bis auf P-AXIS-00236 bei ihrem "
    "Sollwert ist. In einem Satz ohne Bewegung ist es unzulässig (20003)."};
constexpr Sentence exact_stops{"Exact stops at the end of every block, until G359.",
                               "Genauhalt am Ende jedes Satzes, bis G359."};
constexpr Sentence no_exact_stops{"Ends the exact stops of G360.", "Beendet die Genauhalte von G360."};
constexpr Sentence foreign_stop{"Not a word of this control. On others it ends exact stops; here G359 does.",
                                "Kein Wort dieser Steuerung. Auf anderen beendet es Genauhalte, hier G359."};
constexpr Sentence refused_foreign{"`{word}` is not a word of this control; `G359` ends exact stops",
                                   "`{word}` ist kein Wort dieser Steuerung; Genauhalte beendet `G359`"};
constexpr Sentence accelerate_at_begin{
    "A higher feed is reached from the beginning of the block on. This is the initial state.",
    "Auf einen höheren Vorschub wird ab dem Satzanfang beschleunigt. Das ist der Grundzustand."};
constexpr Sentence brake_in_time{
    "A lower feed of the next block is reached at the end of this one. This is the initial state; it ends "
    "G901.",
    "Ein niedrigerer Vorschub des nächsten Satzes ist am Ende des Satzes erreicht. Das ist der Grundzustand; "
    "es beendet G901."};
constexpr Sentence brake_late{
    "The path slows down for a lower feed of the next block only behind the end of this one. The limits of "
    "the axes are kept. No effect from G00 to G01 and with the slope HSC.",
    "Die Bahn bremst auf einen niedrigeren Vorschub des nächsten Satzes erst hinter dem Ende dieses Satzes. "
    "Die Grenzen der Achsen werden eingehalten. Ohne Wirkung von G00 auf G01 und beim Slope HSC."};
constexpr Sentence brake_here{
    "While G901 is on, the path has slowed down to the next feed at the end of this block after all. It is "
    "no stop: that is G60.",
    "Während G901 wirkt, ist die Bahn am Ende dieses Satzes trotzdem schon auf den nächsten Vorschub "
    "gebremst. Es ist kein Halt: das ist G60."};
constexpr Sentence feed_over_way{
    "The feed changes evenly over the way (G193) or the time (G293) of the block.",
    "Der Vorschub ändert sich stetig über den Weg (G193) oder die Zeit (G293) des Satzes."};
constexpr Sentence refused_feed{
    "`{word}` cannot be simulated: it changes the feed within the block; write blocks with F of their own",
    "`{word}` ist nicht simulierbar: es ändert den Vorschub im Satz; stattdessen Sätze mit eigenem F "
    "schreiben"};
constexpr Sentence corner_deceleration{
    "Slower before and behind corners, by the parameters of #CORNER PARAM.",
    "Vor und hinter Ecken langsamer, nach den Parametern von #CORNER PARAM."};
constexpr Sentence refused_corner_deceleration{
    "`{word}` cannot be simulated: the control drives slower at corners; write the feed of these blocks, or "
    "leave it out",
    "`{word}` ist nicht simulierbar: die Steuerung fährt an Ecken langsamer; den Vorschub dieser Sätze "
    "schreiben oder es weglassen"};
constexpr Sentence no_corner_deceleration{"Ends G13. This is the initial state.",
                                          "Beendet G13. Das ist der Grundzustand."};
constexpr Sentence rounding{
    "Two polynomials of fourth order replace the corner, at most PATH_DEV away from it, 1 mm where nothing "
    "is programmed; their coefficients are not documented. `simulate --sharp-corners` follows the corner and "
    "names this bound.",
    "Zwei Polynome vierter Ordnung ersetzen die Ecke, höchstens PATH_DEV von ihr entfernt, 1 mm, wo nichts "
    "programmiert ist; ihre Koeffizienten sind nicht dokumentiert. `simulate --sharp-corners` folgt der Ecke "
    "und nennt diese Schranke."};
constexpr Sentence refused_rounding{
    "`{word}` cannot be simulated: the control rounds this corner by up to 1 mm, or PATH_DEV; "
    "`--sharp-corners` leaves corners sharp",
    "`{word}` ist nicht simulierbar: die Steuerung verschleift diese Ecke um bis zu 1 mm oder PATH_DEV; mit "
    "`--sharp-corners` bleiben Ecken scharf"};
constexpr Sentence rounding_parameters{
    "Parameters of the contouring that G61 and G261 switch on. They change nothing by themselves.",
    "Parameter des Überschleifens, das G61 und G261 einschalten. Für sich allein ändern sie nichts."};
constexpr Sentence no_rounding{"Ends polynomial contouring. This is the initial state.",
                               "Beendet das Polynomüberschleifen. Das ist der Grundzustand."};
constexpr Sentence slope{
    "How acceleration comes and goes: at once (STEP), in ramps of constant jerk (TRAPEZ), as sin² (SIN2), or "
    "across blocks (HSC: a reading). DEFAULT is P-CHAN-00071. After a TYPE weights apply to all values. Any "
    "other TYPE: message 120020.",
    "Wie Beschleunigung kommt und geht: sprungförmig (STEP), in Rampen konstanten Rucks (TRAPEZ), als sin² "
    "(SIN2), satzübergreifend (HSC: Lesart). DEFAULT: P-CHAN-00071. Nach TYPE gelten Gewichte für alles. "
    "Anderer TYPE: Meldung 120020."};
constexpr Sentence slope_number{
    "The older form of #SLOPE: 0 STEP, 1 TRAPEZ, 2 SIN2, 3 HSC. Another number: 120178.",
    "Die ältere Form von #SLOPE: 0 STEP, 1 TRAPEZ, 2 SIN2, 3 HSC. Andere Zahl: 120178."};
constexpr Sentence weigh_acceleration{
    "Weighs the accelerations of feed blocks (G01 to G03), in percent of the values of the lists, of the "
    "axes named in the block: an axis keeps its weight until it is named again. Above 100 % up to "
    "P-AXIS-00292.",
    "Gewichtet die Beschleunigungen von Vorschubsätzen (G01 bis G03) in Prozent der Listenwerte, für die "
    "Achsen, die der Satz nennt: eine Achse behält ihr Gewicht, bis sie wieder genannt wird. Über 100 % bis "
    "P-AXIS-00292."};
constexpr Sentence weigh_accelerations{
    "Weighs the accelerations of feed blocks (G01 to G03) of all axes, in percent of the values of the "
    "lists. Above 100 % up to P-AXIS-00292.",
    "Gewichtet die Beschleunigungen von Vorschubsätzen (G01 bis G03) aller Achsen in Prozent der "
    "Listenwerte. Über 100 % bis P-AXIS-00292."};
constexpr Sentence weigh_ramp{
    "Weighs the ramp times of feed blocks (G01 to G03), in percent of the values of the lists, of the axes "
    "named in the block: an axis keeps its weight until it is named again. Down to P-AXIS-00293, at least "
    "P-AXIS-00201.",
    "Gewichtet die Rampenzeiten von Vorschubsätzen (G01 bis G03) in Prozent der Listenwerte, für die Achsen, "
    "die der Satz nennt: eine Achse behält ihr Gewicht, bis sie wieder genannt wird. Bis hinab zu "
    "P-AXIS-00293, mindestens P-AXIS-00201."};
constexpr Sentence weigh_ramps{
    "Weighs the ramp times of feed blocks (G01 to G03) of all axes, in percent of the values of the lists. "
    "Down to P-AXIS-00293, at least P-AXIS-00201.",
    "Gewichtet die Rampenzeiten von Vorschubsätzen (G01 bis G03) aller Achsen in Prozent der Listenwerte. "
    "Bis hinab zu P-AXIS-00293, mindestens P-AXIS-00201."};
constexpr Sentence weigh_curve_ramp{
    "Weighs the ramp time of curved paths (P-AXIS-00199) of all axes, in percent.",
    "Gewichtet die Rampenzeit gekrümmter Bahnen (P-AXIS-00199) aller Achsen in Prozent."};
constexpr Sentence weigh_rapid_acceleration{
    "Weighs the acceleration of G00, in percent of the value of the lists, of the axes named in the block.",
    "Gewichtet die Beschleunigung von G00 in Prozent des Listenwerts, für die Achsen, die der Satz nennt."};
constexpr Sentence weigh_rapid_accelerations{
    "Weighs the acceleration of G00 of all axes, in percent of the values of the lists.",
    "Gewichtet die Beschleunigung von G00 aller Achsen in Prozent der Listenwerte."};
constexpr Sentence weigh_rapid_ramps{
    "Weighs the ramp time of G00 of all axes, in percent of the values of the lists.",
    "Gewichtet die Rampenzeit von G00 aller Achsen in Prozent der Listenwerte."};
constexpr Sentence weigh_velocity{
    "Weighs the highest velocity (P-AXIS-00212) of the axes named in the block, in percent: never above the "
    "value of the list; 0 is 1 µm/s.",
    "Gewichtet die Höchstgeschwindigkeit (P-AXIS-00212) der Achsen, die der Satz nennt, in Prozent: nie über "
    "den Listenwert; 0 ist 1 µm/s."};
constexpr Sentence weigh_velocities{
    "Weighs the highest velocity (P-AXIS-00212) of all axes, in percent: never above the values of the "
    "lists; 0 is 1 µm/s.",
    "Gewichtet die Höchstgeschwindigkeit (P-AXIS-00212) aller Achsen in Prozent: nie über die Listenwerte; 0 "
    "ist 1 µm/s."};
constexpr Sentence weigh_rapid_velocities{
    "Weighs the velocity of G00 (P-AXIS-00209) of all axes, in percent: never above P-AXIS-00212; 0 is 1 "
    "µm/s.",
    "Gewichtet die Geschwindigkeit von G00 (P-AXIS-00209) aller Achsen in Prozent: nie über P-AXIS-00212; 0 "
    "ist 1 µm/s."};
constexpr Sentence feed_hold{"Weighs the deceleration of a feed hold, which no plan contains.",
                             "Gewichtet die Verzögerung eines Vorschubhalts, den kein Plan enthält."};
constexpr Sentence look_ahead{
    "Chooses functions of the look-ahead, as a sum: 2 velocity at corners, 4 chord error, 8 acceleration in "
    "curves. The limit of the chord error is not known, so that it is never applied. Outside of 0 to 14: "
    "20151.",
    "Wählt Funktionen der Vorausschau als Summe: 2 Geschwindigkeit an Ecken, 4 Sehnenfehler, 8 "
    "Beschleunigung in Kurven. Die Grenze des Sehnenfehlers ist nicht bekannt, er wird daher nie begrenzt. "
    "Außerhalb von 0 bis 14: 20151."};
constexpr Sentence whole_look_ahead{"All functions of the look-ahead again. This is the initial state.",
                                    "Wieder alle Funktionen der Vorausschau. Das ist der Grundzustand."};
constexpr Sentence look_ahead_of_axes{"Chooses how axes limit the velocity at corners.",
                                      "Wählt, wie Achsen die Geschwindigkeit an Ecken begrenzen."};
constexpr Sentence refused_look_ahead{
    "`{word}` cannot be simulated: the meaning of its values is not documented; `G115` chooses for all axes",
    "`{word}` ist nicht simulierbar: die Bedeutung seiner Werte ist nicht dokumentiert; `G115` wählt für "
    "alle Achsen"};
constexpr Sentence vector_limit{
    "Limits along the path: VEL in mm/min; ACC, DEC, RADIAL_ACC in mm/min², or mm/s² by P-CHAN-00351. "
    "Without value those of the channel list count. ACC and DEC count on circles only with P-CHAN-00350. ALL "
    "is all four.",
    "Grenzen längs der Bahn: VEL in mm/min; ACC, DEC, RADIAL_ACC in mm/min² oder nach P-CHAN-00351 in mm/s². "
    "Ohne Wert gelten die der Kanalliste. ACC und DEC gelten auf Kreisen nur mit P-CHAN-00350. ALL sind alle "
    "vier."};
constexpr Sentence least_corner_velocity{
    "The path passes corners at this velocity at least, in mm/min, even where an axis then takes a larger "
    "step than its list allows. P-CHAN-00009 wins with limited jerk.",
    "Die Bahn fährt mindestens mit dieser Geschwindigkeit durch Ecken, in mm/min, auch wo eine Achse dann "
    "einen größeren Schritt macht, als ihre Liste erlaubt. Bei begrenztem Ruck hat P-CHAN-00009 Vorrang."};
constexpr Sentence feed_forward{
    "Switches feedforward on for the axes of the channel; programs begin without. Their positions then "
    "arrive 5 cycles later, but with P-AXIS-00566. Where axes differ in that, `simulate` lets it act at "
    "rest, a reading.",
    "Schaltet die Vorsteuerung der Achsen des Kanals ein; Programme beginnen ohne. Ihre Positionen kommen "
    "dann 5 Zyklen später an, außer mit P-AXIS-00566. Sind Achsen darin verschieden, wirkt es in `simulate` "
    "im Stand: eine Lesart."};
constexpr Sentence weigh_feedforward{
    "Weighs what is fed forward, in percent up to 100, of the axes named in the block. It changes what the "
    "drive gets beside the position, which is planned and filtered as before.",
    "Gewichtet, was vorgesteuert wird, in Prozent bis 100, für die Achsen, die der Satz nennt. Es ändert, "
    "was der Antrieb neben der Position bekommt; geplant und gefiltert wird diese wie zuvor."};
constexpr Sentence feed_no_more{
    "Switches feedforward off again, but where P-AXIS-00255 keeps it on. This is the initial state.",
    "Schaltet die Vorsteuerung wieder aus, außer wo P-AXIS-00255 sie immer einschaltet. Das ist der "
    "Grundzustand."};
constexpr Sentence dynamic_weight{
    "Weighs velocities and accelerations by the load of the machine.",
    "Gewichtet Geschwindigkeiten und Beschleunigungen nach der Last der Maschine."};
constexpr Sentence refused_dynamic_weight{
    "`{word}` cannot be simulated: its weights are not known; `G131` and `G133` give weights",
    "`{word}` ist nicht simulierbar: seine Gewichte sind nicht bekannt; `G131` und `G133` geben Gewichte an"};

}  // namespace axisc::schema::says

namespace axisc::schema {
namespace {

using enum WordUse;
using enum MotionEffect;
using Of = Weighting::Of;
using In = Weighting::In;
constexpr auto block = WordReach::block;
constexpr auto modal = WordReach::modal;

constexpr MotionWord weight(std::string_view word, std::string_view form, Weighting weighting,
                            SentenceRef meaning, std::string_view source) {
  return {.word = word,
          .form = form,
          .use = computed,
          .effect = weigh,
          .weighting = weighting,
          .meaning = meaning,
          .source = source};
}

constexpr MotionWord row(std::string_view word, std::string_view form, WordReach reach, MotionEffect effect,
                         SentenceRef meaning, std::string_view source) {
  return {.word = word,
          .form = form,
          .use = computed,
          .reach = reach,
          .effect = effect,
          .meaning = meaning,
          .source = source};
}

constexpr MotionWord accept(std::string_view word, std::string_view form, MotionEffect effect,
                            SentenceRef meaning, std::string_view source) {
  return {
      .word = word, .form = form, .use = accepted, .effect = effect, .meaning = meaning, .source = source};
}

constexpr MotionWord accepted_weight(std::string_view word, std::string_view form, Weighting weighting,
                                     SentenceRef meaning, std::string_view source) {
  return {.word = word,
          .form = form,
          .use = accepted,
          .effect = weigh,
          .weighting = weighting,
          .meaning = meaning,
          .source = source};
}

constexpr MotionWord hold(std::string_view word, std::string_view form, Weighting weighting,
                          std::string_view source) {
  return accepted_weight(word, form, weighting, says::feed_hold, source);
}

constexpr MotionWord refuse(std::string_view word, std::string_view form, WordReach reach,
                            SentenceRef meaning, Sentence const& refusal, std::string_view source,
                            MotionEffect effect = nothing) {
  return {.word = word,
          .form = form,
          .use = refused,
          .reach = reach,
          .effect = effect,
          .meaning = meaning,
          .refusal = &refusal,
          .source = source};
}

constexpr std::string_view page_of_stops = "prog/206301707";
constexpr std::string_view page_of_braking = "prog/206238219";
constexpr std::string_view page_of_accelerations = "prog/206590731";
constexpr std::string_view page_of_ramps = "prog/206596619";
constexpr std::string_view page_of_velocities = "prog/206573067";
constexpr std::string_view page_of_feedforward = "old/15556769419";
constexpr std::string_view page_of_look_ahead = "prog/206736907";
constexpr std::string_view page_of_rounding = "prog/475164939";

constexpr std::array table{
    row("G60", "G60", block, stop, says::exact_stop, page_of_stops),
    row("G360", "G360", modal, stop_from_here, says::exact_stops, page_of_stops),
    row("G359", "G359", modal, stop_no_more, says::no_exact_stops, page_of_stops),
    refuse("G64", "G64", modal, says::foreign_stop, says::refused_foreign, "prog/5251491951026763659"),
    accept("G08", "G08", nothing, says::accelerate_at_begin, page_of_braking),
    accept("G900", "G900", brake_in_time, says::brake_in_time, page_of_braking),
    row("G901", "G901", modal, brake_late, says::brake_late, page_of_braking),
    row("G09", "G09", block, brake_in_time_here, says::brake_here, page_of_braking),
    refuse("G193", "G193", block, says::feed_over_way, says::refused_feed, page_of_braking),
    refuse("G293", "G293", block, says::feed_over_way, says::refused_feed, page_of_braking),
    refuse("G13", "G13", modal, says::corner_deceleration, says::refused_corner_deceleration,
           "prog/206449675"),
    accept("G12", "G12", nothing, says::no_corner_deceleration, "prog/206449675"),
    refuse("G61", "G61", block, says::rounding, says::refused_rounding, page_of_rounding, round_corner),
    refuse("G261", "G261", modal, says::rounding, says::refused_rounding, page_of_rounding, round_corners),
    refuse("#CONTOUR MODE ON", "#CONTOUR MODE ON [keywords]", modal, says::rounding, says::refused_rounding,
           "prog/475073291", round_corners),
    accept("G260", "G260", round_no_more, says::no_rounding, page_of_rounding),
    accept("#CONTOUR MODE OFF", "#CONTOUR MODE OFF", round_no_more, says::no_rounding, "prog/475073291"),
    accept("#CONTOUR MODE", "#CONTOUR MODE [keywords]", set_rounding, says::rounding_parameters,
           "prog/475156491"),
    row("#SLOPE", "#SLOPE [TYPE=STEP | TRAPEZ | SIN2 | HSC], #SLOPE DEFAULT", modal, slope, says::slope,
        "prog/207190411"),
    row("#SET SLOPE PROFIL", "#SET SLOPE PROFIL[number]", modal, slope_number, says::slope_number,
        "prog/207190411"),
    weight("G130", "G130 X50 Y80", {.of = Of::acceleration, .in = In::feed, .by_axis = true},
           says::weigh_acceleration, page_of_accelerations),
    weight("G131", "G131=percent", {.of = Of::acceleration, .in = In::feed}, says::weigh_accelerations,
           page_of_accelerations),
    weight("G132", "G132 X50 Y80", {.of = Of::ramp_times, .in = In::feed, .by_axis = true}, says::weigh_ramp,
           page_of_ramps),
    weight("G133", "G133=percent", {.of = Of::ramp_times, .in = In::feed}, says::weigh_ramps, page_of_ramps),
    weight("G134", "G134=percent", {.of = Of::curve_ramp_time, .in = In::all}, says::weigh_curve_ramp,
           page_of_ramps),
    weight("G230", "G230 X50 Y80", {.of = Of::acceleration, .in = In::rapid, .by_axis = true},
           says::weigh_rapid_acceleration, page_of_accelerations),
    weight("G231", "G231=percent", {.of = Of::acceleration, .in = In::rapid}, says::weigh_rapid_accelerations,
           page_of_accelerations),
    weight("G233", "G233=percent", {.of = Of::ramp_times, .in = In::rapid}, says::weigh_rapid_ramps,
           page_of_ramps),
    weight("G127", "G127 X50 Y80", {.of = Of::velocity, .in = In::feed, .by_axis = true},
           says::weigh_velocity, page_of_velocities),
    weight("G128", "G128=percent", {.of = Of::velocity, .in = In::feed}, says::weigh_velocities,
           page_of_velocities),
    weight("G129", "G129=percent", {.of = Of::velocity, .in = In::rapid}, says::weigh_rapid_velocities,
           "prog/206578955"),
    hold("G333", "G333 X50 Y80", {.of = Of::acceleration, .in = In::no_plan, .by_axis = true},
         page_of_accelerations),
    hold("G334", "G334=percent", {.of = Of::acceleration, .in = In::no_plan}, page_of_accelerations),
    hold("G338", "G338 X50 Y80", {.of = Of::ramp_times, .in = In::no_plan, .by_axis = true}, page_of_ramps),
    hold("G339", "G339=percent", {.of = Of::ramp_times, .in = In::no_plan}, page_of_ramps),
    row("G115", "G115=sum", modal, limit_by, says::look_ahead, page_of_look_ahead),
    refuse("G116", "G116 X1", modal, says::look_ahead_of_axes, says::refused_look_ahead, page_of_look_ahead),
    row("G117", "G117", modal, limit_by_all, says::whole_look_ahead, page_of_look_ahead),
    row("G135", "G135", modal, feed_forward, says::feed_forward, page_of_feedforward),
    accepted_weight("G136", "G136 X50 Y80", {.of = Of::feedforward, .in = In::no_plan, .by_axis = true},
                    says::weigh_feedforward, page_of_feedforward),
    row("G137", "G137", modal, feed_no_more, says::feed_no_more, page_of_feedforward),
    row("#VECTOR LIMIT", "#VECTOR LIMIT ON [VEL=v ACC=a DEC=a RADIAL_ACC=a], #VECTOR LIMIT OFF", modal,
        MotionEffect::vector_limit, says::vector_limit, "prog/207477899"),
    row("#TRANSVELMIN", "#TRANSVELMIN ON [v], #TRANSVELMIN OFF", modal, MotionEffect::least_corner_velocity,
        says::least_corner_velocity, "old/15557044875"),
    refuse("#DYNAMIC WEIGHT", "#DYNAMIC WEIGHT", modal, says::dynamic_weight, says::refused_dynamic_weight,
           ""),
};

constexpr std::size_t highest_function = 999;
constexpr std::size_t no_row = table.size();

/// The number of a G word; beyond the highest for all others.
constexpr std::size_t function_of(std::string_view word) {
  std::size_t number = highest_function + 1;
  if (word.size() < 2 || word.front() != 'G') return number;
  number = 0;
  for (char const digit : word.substr(1)) {
    bool const is_digit = digit >= '0' && digit <= '9' && number <= highest_function;
    if (!is_digit) return highest_function + 1;
    number = number * 10 + static_cast<std::size_t>(digit - '0');
  }
  return number;
}

/// By the number of a G word its row.
constexpr auto rows_by_function = [] {
  std::array<std::size_t, highest_function + 1> rows{};
  for (std::size_t& each : rows) each = no_row;
  for (std::size_t i = 0; i < table.size(); ++i) {
    std::size_t const number = function_of(table.at(i).word);
    if (number <= highest_function) rows.at(number) = i;
  }
  return rows;
}();

/// The words of a text that blanks separate.
std::vector<std::string_view> split_at_blanks(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    std::size_t const blank = std::min(text.find(' '), text.size());
    if (blank > 0) words.push_back(text.substr(0, blank));
    text.remove_prefix(std::min(blank + 1, text.size()));
  }
  return words;
}

template <typename Words>
bool begins_with(std::span<std::string_view const> words, Words const& name) {
  return words.size() >= name.size() && std::equal(name.begin(), name.end(), words.begin());
}

}  // namespace

std::span<MotionWord const> motion_words() {
  return table;
}

MotionWord const* find_motion_word(int number) {
  auto const place = static_cast<std::size_t>(number);
  if (number < 0 || place > highest_function || rows_by_function.at(place) == no_row) return nullptr;
  return &table.at(rows_by_function.at(place));
}

MotionWord const* find_motion_word(std::span<std::string_view const> words) {
  MotionWord const* longest = nullptr;
  for (MotionWord const& word : table) {
    if (word.word.front() != '#' || !begins_with(words, split_at_blanks(word.word))) continue;
    if (longest == nullptr || length_of(word) > length_of(*longest)) longest = &word;
  }
  return longest;
}

MotionWord const* find_motion_word(std::string_view text) {
  std::string const upper = ascii::upper_case(text.substr(0, text.find_first_of("=[")));
  if (upper.starts_with('G')) {
    return find_motion_word(
        static_cast<int>(function_of(std::string_view(upper).substr(0, upper.find(' ')))));
  }
  return find_motion_word(split_at_blanks(upper));
}

std::size_t length_of(MotionWord const& word) {
  return 1 + static_cast<std::size_t>(std::count(word.word.begin(), word.word.end(), ' '));
}

std::string address_of(std::string_view source) {
  std::string_view const page = source.substr(source.find('/') + 1);
  std::string address = "https://infosys.beckhoff.com/content/1033/";
  address += source.starts_with("old/") ? "tccncprogramming/" : "tf5200_programming_manual/";
  return address.append(page).append(".html");
}

}  // namespace axisc::schema
