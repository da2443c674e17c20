// Look-ups as people type them. What is right was decided by what the words mean to somebody who sets up a
// machine: the panel's number leads to its message, a colloquial name to the parameter that the manual
// describes under it, a symptom to the page that says what helps.
#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/answers/explain/explain_parts.hpp"
#include "axisc/answers/explain/explain_subject.hpp"
#include "axisc/answers/explain/search_entries.hpp"
#include "axisc/answers/explain/search_text.hpp"
#include "axisc/answers/explain/search_vocabulary.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/finding.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace axisc;

namespace {

std::vector<schema::Catalogue> const& catalogues() {
  static auto const all = catalogues_of({});
  return all;
}

struct Namer {
  std::string operator()(validator::Rule const* rule) const { return code_text(rule->code); }
  std::string operator()(schema::Parameter const* parameter) const { return std::string(parameter->name); }
  std::string operator()(schema::MotionWord const* word) const { return std::string(word->word); }
  std::string operator()(schema::Topic const* topic) const { return std::string(topic->name); }
  std::string operator()(schema::ControlMessage const* message) const {
    return std::to_string(message->numbers.front());
  }
};

/// The name of the page that is shown, or of the first row of the list.
std::string first_of(std::string const& text) {
  auto const subject = explain_subject(catalogues(), text);
  if (subject.number) return std::to_string(*subject.number);
  if (subject.topic != nullptr) return Namer()(subject.topic);
  if (subject.motion_word != nullptr) return Namer()(subject.motion_word);
  if (!subject.rules.empty()) return Namer()(subject.rules.front());
  if (!subject.parameters.empty()) return Namer()(subject.parameters.front());
  return std::visit(Namer(), subject.hits.front().subject);
}

struct LookUp {
  std::string_view typed;
  std::string_view right;
};

constexpr auto look_ups = std::to_array<LookUp>({
    // The panel.
    {"Fehler 50663", "50663"},
    {"ID 50663", "50663"},
    {"P-ERR-50663", "50663"},
    {"Feher 50663", "50663"},
    {"ID 50557: Frequenz zu gross, Achse 1 [X], Wert 600", "50557"},
    {"error 110239 filter type", "110239"},
    {"what does 51043 mean", "51043"},
    {"Meldung 70600 Achse X2", "70600"},
    {"Alarm 21990", "21990"},
    {"50555", "50555"},
    {"E50663", "50663"},
    // What the panel says beside its number.
    {"Filtertyp unbekannt", "50554"},
    {"unknown filter type", "50554"},
    {"Filterordnung zu hoch", "50553"},
    {"Zeitkonstante ungültig", "50663"},
    {"Abtastfrequenz zu klein", "50556"},
    {"quality invalid", "50555"},
    {"Achsnummer doppelt", "1001121"},
    {"Schleppabstand zu groß", "70020"},
    {"Gantry Slave ohne Master", "110244"},
    // Filters.
    {"Kerbfilter", "BANDSTOP"},
    {"Notch", "BANDSTOP"},
    {"Bandsperre", "BANDSTOP"},
    {"notch filter frequency", "BANDSTOP"},
    {"Kerbfiltr", "BANDSTOP"},
    {"Tiefpass", "LOWPASS"},
    {"low pass filter", "LOWPASS"},
    {"PT1-Glied", "PT1"},
    {"Totzeit", "TIME_DELAY"},
    {"gleitender Mittelwert", "FIR"},
    {"NoVib", "HSC"},
    {"Vibration Gaurd", "#VIB GUARD"},
    {"input shaping", "#VIB GUARD"},
    {"Butterworth", "filter[].prototype"},
    {"Guete", "filter[].guete"},
    {"Grenzfrequenz", "filter[].fg_f0"},
    {"cutoff frequency", "filter[].fg_f0"},
    {"Filterordnung", "filter[].order"},
    {"filter[1].odrer", "filter[].order"},
    {"Dämpfungsgrad", "vib_guard.damping"},
    // Symptoms.
    {"Rattern", "vibration"},
    {"chatter", "vibration"},
    {"Maschine schwingt", "vibration"},
    {"Ueberschwingen", "overshoot"},
    {"Achse brummt", "vibration"},
    {"Achse ruckelt", "vibration"},
    {"Kreisformfehler", "contour deviation"},
    {"Konturfehler", "contour deviation"},
    {"Filter wirkt nicht", "AX3007"},
    {"Achsen laufen nicht synchron", "AX4011"},
    {"Neustart nötig", "restart"},
    // Axis parameters.
    {"Umkehrspiel", "getriebe[].lose"},
    {"backlash", "getriebe[].lose"},
    {"Kv", "getriebe[].kv"},
    {"kv factor", "getriebe[].kv"},
    {"Höchstgeschwindigkeit", "getriebe[].dynamik.vb_max"},
    {"hoechstgeschwindigkeit", "getriebe[].dynamik.vb_max"},
    {"Hochstgeschwindigkeit", "getriebe[].dynamik.vb_max"},
    {"vb max", "getriebe[].dynamik.vb_max"},
    {"vb_maxx", "getriebe[].dynamik.vb_max"},
    {"max acceleration", "getriebe[].dynamik.a_max"},
    {"Schlepfehler", "getriebe[].slep_max"},
    {"Getriebespiel", "getriebe[].lose"},
    {"Referenzpunktfahrt", "kenngr.homing.homing_type"},
    {"dreht falsch herum", "getriebe[].reverse"},
    {"Anfahrzeit", "jerk"},
    {"Eilgang", "getriebe[].vb_eilgang"},
    {"in-position window", "getriebe[].window"},
    {"Getriebeübersetzung", "getriebe[].gear_fact_num"},
    {"Referenzfahrt", "kenngr.homing.homing_type"},
    {"P-AXIS-00099", "getriebe[].kv"},
    {"p axis 212", "getriebe[].dynamik.vb_max"},
    // Lists and programs.
    {"Dezimalkomma", "AX1005"},
    {"ax 3005", "AX3005"},
    {"#FILTER", "#FILTER"},
    {"G60 Genauhalt", "G60"},
    {"Überschleifen", "G61"},
    // Faults in other words than those of the page.
    {"gantry slave no master", "110244"},
    {"error filter quality wrong", "50555"},
    {"wrong data type reference", "AX2012"},
    {"Master und Slave verschieden Beschleunigung", "70205"},
    {"compensation list for wrong axis", "AX7008"},
    {"Achsgeschwindigkeit überschritten Überwachung", "50118"},
    // Names and numbers among other words.
    {"filter 1 fg_f0", "filter[].fg_f0"},
    {"what is slep_max", "getriebe[].slep_max"},
    {"AXIS00167", "getriebe[].slep_dyn"},
    {"pchan00003", "gruppe[].achs_anzahl"},
    {"parameter 212", "getriebe[].dynamik.vb_max"},
    {"PCHAN 3", "gruppe[].achs_anzahl"},
    {"ID 50663 axis2", "50663"},
    {"vib_guard.frequency", "vib_guard.freq"},
    {"vorsteuerung.shift_time", "vorsteuer.shift_time"},
    {"index too big", "AX2002"},
    {"ball screw pitch error", "lr_param.ssfk"},
    // Words that say nothing elsewhere.
    {"Genauhalt ein", "G360"},
    {"exact stop on", "G360"},
    // What is seen at the workpiece and the machine.
    {"surface finish bad waviness", "vibration"},
    {"machine knock on reversal", "getriebe[].lose"},
    {"axis not stand still after stop", "AX6003"},
    {"homing direction", "kenngr.ref_richt"},
    {"Kreis zu klein", "contour deviation"},
    {"Gewichtsausgleich", "getriebe[].torque_offset"},
    {"rapid traverse acceleration", "getriebe[].slope_profil.a_grenz"},
    {"lost position after power off", "lr_param.restore_axis_position"},
    {"drive reverse polarity", "getriebe[].reverse"},
    {"Zeitkonstante Symmetrierfilter zu klein", "70355"},
    {"polynomial contouring off", "G260"},
    {"Regel 7007", "AX7007"},
    {"machine too slow in corners", "AX8004"},
    {"Achse schwingt beim Stopp", "vibration"},
    {"encoder increments per revolution", "getriebe[].incr_per_rev"},
});
static_assert(look_ups.size() == 111);

/// Look-ups that were wrong when they were first tried. The site, which looks for words alone, is not asked.
constexpr auto wrong_at_first = std::to_array<LookUp>({
    {"Ruckzeit im Vorschub", "jerk"},
    {"jerk limited profile", "jerk"},
    {"group delay of fir filter", "delay"},
    {"Maschine rattert beim Fräsen", "vibration"},
    {"Endschalter verschieben", "kenngr.swe_neg"},
    {"Parameter geändert aber nichts passiert", "restart"},
    {"Position nach dem Einschalten weg", "lr_param.restore_axis_position"},
    {"axis too slow", "getriebe[].dynamik.vb_max"},
    {"gantry axes out of alignment", "gantry"},
    {"Ecken sind rund", "contour deviation"},
    {"Meldung Schleppfehler", "70020"},
    {"Wie schalte ich den Filter ein", "#FILTER"},
    {"Tippen Geschwindigkeit", "handbetrieb.tipp.geschw[]"},
    {"alarm following error", "70020"},
    {"soft limit reached", "kenngr.swe_neg"},
    {"reference the machine", "kenngr.homing.homing_type"},
    {"jog faster", "handbetrieb.tipp.geschw[]"},
    {"slow down acceleration", "getriebe[].dynamik.a_max"},
    {"Resonanz bei 63 Hz ausblenden", "BANDSTOP"},
    {"Auflösung Motorgeber", "getriebe[].wegaufz"},
    {"Gantry Differenz zu groß", "kenngr.gantry_max_diff_resetable"},
    {"how wide is the notch", "filter[].guete"},
    {"Schleppfehler beim Bremsen", "getriebe[].slep_max"},
    {"Filter wird abgeschaltet", "#FILTER"},
    {"Maschine warm Maß läuft weg", "lr_param.temp_comp"},
    {"homing speed too high", "getriebe[].vb_refmax"},
    {"limit switch override", "kenngr.swe_check"},
    {"Maschine wird an Ecken langsam", "AX8004"},
    {"Kreis hat Absätze an den Quadranten", "lr_param.frict_comp"},
    {"Durchmesser passt nicht", "contour deviation"},
    {"Innenecke verrundet", "contour deviation"},
    {"Beschleunigung auf 50 Prozent", "G131"},
    {"machine hums", "vibration"},
    {"circles have flat spots", "contour deviation"},
    {"slower acceleration in program", "G131"},
    {"look ahead off", "G115"},
    {"hsc filter must be first", "AX4001"},
    {"Kreisform schlecht", "contour deviation"},
    {"Achse wird zu langsam beschleunigt", "getriebe[].slope_profil.a_beschl"},
    {"encoder resolution", "getriebe[].wegaufz"},
    {"Eilgang zu schnell", "getriebe[].vb_eilgang"},
    {"weniger Beschleunigung", "getriebe[].dynamik.a_max"},
    {"rapid too fast", "getriebe[].vb_eilgang"},
    {"less acceleration", "getriebe[].dynamik.a_max"},
    {"less jerk", "jerk"},
    {"machine must be restarted", "restart"},
    {"lead axis", "kenngr.multi_link[].lead_axis"},
    {"achskollision abstand", "kenngr.coll_offset"},
    {"Abstandsregelung Verstärkung", "kenngr.distc.kp"},
    {"exact stop not reached", "getriebe[].position_settling_time"},
    {"langsam referenzieren", "getriebe[].vb_reflow"},
    {"HSC nicht erster Filter", "AX4001"},
    {"notch bandwidth", "filter[].guete"},
});

}  // namespace

TEST_CASE("people's words lead to the right page first") {
  std::size_t right = 0;
  for (auto const& [typed, expected] : look_ups) {
    INFO(typed);
    auto const found = first_of(std::string(typed));
    CHECK(found == expected);
    if (found == expected) ++right;
  }
  CHECK(right >= 55);
  for (auto const& [typed, expected] : wrong_at_first) {
    INFO(typed);
    CHECK(first_of(std::string(typed)) == expected);
  }
}

TEST_CASE("texts are folded as people type them") {
  CHECK(folded("Höchst-Geschwindigkeit") == "hochstgeschwindigkeit");
  CHECK(folded("HOECHSTGESCHWINDIGKEIT") == folded("höchstgeschwindigkeit"));
  CHECK(folded("Übergroße") == "ubergrosse");
  CHECK(words_of("getriebe[0].vb_max") == std::vector<std::string>{"getriebe", "0", "vb", "max"});
  CHECK(words_of("  ") == std::vector<std::string>());
}

TEST_CASE("forms of a word have one stem, other words another") {
  for (auto const* const word : {"schwingt", "schwingen", "schwingung", "schwingungen", "schwingend"}) {
    INFO(word);
    CHECK(stem(word) == "schwing");
  }
  CHECK(stem("limits") == stem("limited"));
  CHECK(stem("stopping") == stem("stops"));
  CHECK(stem("filter") != stem("film"));
  CHECK(stem("kv") == "kv");
}

/// What a text means to the search, in the order of its words.
std::vector<Sense> senses_in(std::string_view text) {
  std::vector<Sense> senses;
  for (auto const& word : vocabulary().telling_words(text).words) senses.push_back(word.sense);
  return senses;
}

TEST_CASE("words of one meaning are one, whatever their language, their form and their spelling") {
  CHECK(senses_in("maximum velocity") == senses_in("Höchstgeschwindigkeit"));
  CHECK(senses_in("top speed of the axis") == senses_in("maximale Geschwindigkeiten"));
  CHECK(senses_in("jerk limit") == senses_in("Ruckbegrenzung"));
  CHECK(senses_in("Ruck-Begrenzung") == senses_in("Ruckbegrenzung"));
  CHECK(senses_in("following error") == senses_in("Schleppabstand"));
  // "Grenzfrequenz" is a word of its own, no frequency that is a limit.
  CHECK(senses_in("Grenzfrequenz") == senses_in("cut-off frequency"));
  CHECK(senses_in("Grenzfrequenz") != senses_in("maximum frequency"));
  CHECK(senses_in("Kerbfilter") == senses_in("notch filter"));
  CHECK(senses_in("filter") != senses_in("limit"));
}

TEST_CASE("fillers and figures say nothing, unless nothing else is there") {
  CHECK(vocabulary().is_filler("fehler"));
  CHECK_FALSE(vocabulary().is_filler("filter"));
  CHECK(senses_in("wie ist die Eigenfrequenz meiner Achse") == senses_in("Eigenfrequenz"));
  CHECK(senses_in("resonance frequency 48 Hz") == senses_in("resonance frequency"));
  CHECK(senses_in("resonance frequency 48Hz") == senses_in("resonance frequency"));
  CHECK_FALSE(senses_in("was ist das").empty());
  // At the end of a sentence "on" and "ein" say what to do.
  CHECK(senses_in("switch the filter on") == senses_in("Filter einschalten"));
  CHECK(senses_in("on the filter") == senses_in("filter"));
}

TEST_CASE("no word is in two groups, in whatever form") {
  auto const& words = schema::search_words();
  for (auto const groups : {words.faults, words.degrees, words.same}) {
    for (auto const& group : groups) {
      for (auto const word : group) {
        INFO(word << " of the group of " << group.front());
        CHECK(vocabulary().sense_of(folded(word)) == vocabulary().sense_of(folded(group.front())));
      }
    }
  }
}

TEST_CASE("faults are one word, however they are called") {
  CHECK(senses_in("Gantry slave: no master") == senses_in("Gantry-Slave ohne Master"));
  CHECK(senses_in("wrong type") == senses_in("falscher Typ"));
  CHECK(vocabulary().tells_fault(vocabulary().sense_of("ungultig")));
  CHECK_FALSE(vocabulary().tells_fault(vocabulary().sense_of("frequenz")));
  CHECK(vocabulary().telling_words("Alarm Filter").ask_for_message);
  // Here "error" is a part of the name.
  CHECK_FALSE(vocabulary().telling_words("following error").ask_for_message);
}

TEST_CASE("what has but some of the words, or pieces of one, is not passed off as found") {
  CHECK_THROWS_AS(explain_subject(catalogues(), "Kühlmittel"), Failure);
  auto const near = explain_subject(catalogues(), "spindle orientation tool change");
  REQUIRE_FALSE(near.is_found());
  CHECK(near.hits.front().likeness == Likeness::some_words);
  auto const title = [](std::string const& text) {
    auto const answer = explain_answer({.word = text, .of_axes = catalogues().front()});
    return presentation::wording_of(answer.title).in(Language::english);
  };
  CHECK(title("spindle orientation tool change") ==
        R"(No entry has all words of "spindle orientation tool change"; these have some of them)");
  CHECK(title("Endschalter") == R"(Found for "Endschalter")");
}

TEST_CASE("one good hit is the answer, several are ranked") {
  auto const good = search(catalogues(), "Kerbfilter");
  CHECK(is_answer(good));
  CHECK(good.front().likeness == Likeness::exact);
  auto const slip = search(catalogues(), "Kerbflter");
  CHECK(is_answer(slip));
  CHECK(slip.front().read_as == "Kerbfilter");
  auto const several = search(catalogues(), "Endschalter");
  CHECK_FALSE(is_answer(several));
  CHECK(several.size() > 2);
  CHECK(std::is_sorted(several.begin(), several.end(),
                       [](Hit const& a, Hit const& b) { return a.likeness < b.likeness; }));
  // A word that is spelled like this elsewhere is no typing error: "function" is another.
  auto const friction = search(catalogues(), "friction");
  CHECK(std::none_of(friction.begin(), friction.end(),
                     [](Hit const& hit) { return hit.likeness == Likeness::slip; }));
}

TEST_CASE("a number that no message has is not taken for another") {
  auto const failure = [](std::string const& text) {
    try {
      static_cast<void>(explain_subject(catalogues(), text));
    } catch (Failure const& caught) {
      return caught.sentence(Language::english);
    }
    return std::string("found");
  };
  CHECK(failure("Fehler 50999") == "nothing is found for \"Fehler 50999\"; did you mean 50989?");
  CHECK(failure("50999") == "nothing is found for \"50999\"; did you mean 50989?");
  CHECK_THAT(failure("xyzzy"), Catch::Matchers::StartsWith("nothing is found for \"xyzzy\": "));
  CHECK_THAT(failure("G999"), Catch::Matchers::StartsWith("nothing is found for \"G999\""));
  CHECK_THAT(failure("?"), Catch::Matchers::StartsWith("nothing is found for \"?\": "));
  // A path is not taken for what its words mean elsewhere.
  for (auto const* const path :
       {"getriebe[].new_limit", "getriebe[].qwertz", "filter[0].xyzzy", "antr.abc"}) {
    CHECK_THAT(failure(path),
               Catch::Matchers::StartsWith("nothing is found for \"" + std::string(path) + "\""));
  }
}

TEST_CASE("every topic and every synonym refers to something that exists") {
  auto const entries = search_entries(catalogues());
  for (auto const& topic : schema::topics()) {
    INFO(topic.name);
    CHECK(first_of(std::string(topic.name)) == topic.name);
    for (auto const name : topic.see) {
      INFO(name);
      CHECK(subject_named(catalogues(), name));
    }
    // A word of a topic alone, or one that it shares, has it among the hits.
    for (auto const word : topic.words) {
      INFO(word);
      auto const hits = search(entries, word);
      CHECK(std::any_of(hits.begin(), hits.end(),
                        [&](Hit const& hit) { return hit.subject == Subject(&topic); }));
    }
  }
  for (auto const& row : schema::synonyms()) {
    INFO(row.of);
    CHECK(subject_named(catalogues(), row.of));
  }
}

TEST_CASE("every number that a rule names has a page of its own") {
  for (auto const& rule : validator::rules()) {
    std::string_view rest = rule.control;
    while (!rest.empty()) {
      auto const number = std::string(rest.substr(0, rest.find('/')));
      rest.remove_prefix(std::min(rest.size(), number.size() + 1));
      INFO(code_text(rule.code) << " " << number);
      CHECK(schema::find_control_message(static_cast<std::uint32_t>(std::stoul(number))) != nullptr);
    }
  }
}

TEST_CASE("texts about messages are short enough for a line of a table") {
  constexpr std::size_t longest = 240;
  for (auto const& message : schema::control_messages()) {
    INFO(message.numbers.front());
    for (auto const& page : {message.meaning, message.reaction, message.remedy}) {
      CHECK(page.english.size() <= longest);
      CHECK(page.german.size() <= longest);
    }
    CHECK_FALSE(message.meaning.english.empty());
  }
}
