#include "axisc/answers/simulation/plant_formats.hpp"

#include "analysis/motion/point.hpp"
#include "axisc/answers/json_text.hpp"
#include "axisc/answers/text_table.hpp"
#include "axisc/files/csv.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

namespace axisc::says {

constexpr Sentence axis{"axis {axis}: {distance} mm there and back at {feed} mm/min, Kv {kv} 1/s",
                        "Achse {axis}: {distance} mm hin und zurück mit {feed} mm/min, Kv {kv} 1/s"};
constexpr Sentence frequency{"oscillation of the load", "Schwingung der Last"};
constexpr Sentence phase{"while", "während"};
constexpr Sentence travel{"travelling", "Verfahren"};
constexpr Sentence ramps{"at rest after braking", "Stillstand nach dem Bremsen"};
constexpr Sentence without{"without [m/s²]", "ohne [m/s²]"};
constexpr Sentence with{"with [m/s²]", "mit [m/s²]"};
constexpr Sentence v_add{"largest additive velocity {velocity} µm/s of {limit} µm/s",
                         "größte additive Geschwindigkeit {velocity} µm/s von {limit} µm/s"};
constexpr Sentence limit_hit{"the additive velocity is limited (P-AXIS-00757)",
                             "die additive Geschwindigkeit wird begrenzt (P-AXIS-00757)"};
constexpr Sentence no_function{"axis {axis} has no active Improved Position Control",
                               "Achse {axis} hat keine aktive optimierte Lageregelung"};

constexpr Sentence diverges{"the loop DIVERGES: the oscillation grows; lower kv_per_s",
                            "der Regelkreis schwingt AUF: die Schwingung wächst; kv_per_s verkleinern"};
constexpr Sentence diverges_with{
    "the loop DIVERGES with Improved Position Control: the oscillation grows; lower the weights "
    "(P-AXIS-00754/00755), or move fg_f0",
    "der Regelkreis schwingt AUF mit optimierter Lageregelung: die Schwingung wächst; Gewichte verkleinern "
    "(P-AXIS-00754/00755) oder fg_f0 verschieben"};
constexpr Sentence diverges_without{
    "the loop DIVERGES without Improved Position Control; with it the oscillation dies down",
    "der Regelkreis schwingt AUF ohne optimierte Lageregelung; mit ihr klingt die Schwingung ab"};
constexpr Sentence diverges_always{
    "the loop DIVERGES with and without Improved Position Control: the oscillation grows; lower kv_per_s",
    "der Regelkreis schwingt AUF mit und ohne optimierte Lageregelung: die Schwingung wächst; kv_per_s "
    "verkleinern"};
constexpr Sentence kv{
    "highest Kv without oscillation: {without} without, {with} with Improved Position Control",
    "höchstes Kv ohne Schwingung: {without} ohne, {with} mit optimierter Lageregelung"};
constexpr Sentence kv_alone{"highest Kv without oscillation: {kv}", "höchstes Kv ohne Schwingung: {kv}"};
constexpr Sentence kv_found{"{kv} 1/s", "{kv} 1/s"};
constexpr Sentence kv_above{"above {kv} 1/s", "über {kv} 1/s"};
constexpr Sentence kv_none{"below 1 1/s", "unter 1 1/s"};
constexpr Sentence kv_searched{"(searched up to {kv} 1/s)", "(gesucht bis {kv} 1/s)"};

}  // namespace axisc::says

namespace axisc {

namespace {

using motion::MovePhase;
using nlohmann::ordered_json;

std::string say(Language language, SentenceRef text, std::vector<Argument> arguments = {}) {
  return render({.sentence = text, .arguments = std::move(arguments)}, language);
}

std::string kv_text(std::optional<double> kv, Language language) {
  if (!kv) return say(language, says::kv_above, {{"kv", exact_number(motion::kv_search_end)}});
  if (*kv == 0) return say(language, says::kv_none);
  return say(language, says::kv_found, {{"kv", format_fixed(*kv, 1)}});
}

std::string oscillations_text(ClosedLoopFigures const& figures, Language language) {
  std::vector<std::vector<std::string>> rows = {{say(language, says::frequency), say(language, says::phase),
                                                 say(language, says::without), say(language, says::with)}};
  for (auto const& found : figures.oscillations) {
    rows.push_back({format_fixed(found.without.frequency, 1).in(language) + " Hz",
                    say(language, found.phase == MovePhase::travel ? says::travel : says::ramps),
                    format_fixed(found.without.amplitude, 3).in(language),
                    found.with ? format_fixed(*found.with, 3).in(language) : "-"});
  }
  return text_table(rows, 2);
}

std::string divergence_text(ClosedLoopFigures const& figures, Language language) {
  if (!figures.diverges_without && !figures.diverges_with) return {};
  SentenceRef which = says::diverges_with;
  if (!figures.has_function) {
    which = says::diverges;
  } else if (figures.diverges_without) {
    which = figures.diverges_with ? says::diverges_always : says::diverges_without;
  }
  return say(language, which) + "\n";
}

std::string highest_kv_text(ClosedLoopFigures const& figures, Language language) {
  auto const without = kv_text(figures.highest_kv_without, language);
  std::string text = figures.has_function
                         ? say(language, says::kv,
                               {{"without", without}, {"with", kv_text(figures.highest_kv_with, language)}})
                         : say(language, says::kv_alone, {{"kv", without}});
  if (!figures.highest_kv_without || !figures.highest_kv_with) {
    text += " " + say(language, says::kv_searched, {{"kv", exact_number(motion::kv_search_end)}});
  }
  return text + "\n";
}

}  // namespace

std::string plant_text(ClosedLoopFigures const& figures, Language language) {
  std::string text = say(language, says::axis,
                         {{"axis", figures.axis},
                          {"distance", exact_number(figures.distance_mm)},
                          {"feed", format_fixed(figures.feed_mm_per_min, 0)},
                          {"kv", exact_number(figures.kv)}}) +
                     "\n";
  if (!figures.oscillations.empty()) text += oscillations_text(figures, language);
  if (figures.has_function) {
    text += say(language, says::v_add,
                {{"velocity", format_fixed(figures.largest_additive, 0)},
                 {"limit", format_fixed(figures.limit, 0)}}) +
            "\n";
  } else {
    text += say(language, says::no_function, {{"axis", figures.axis}}) + "\n";
  }
  if (figures.limit_hit) text += say(language, says::limit_hit) + "\n";
  text += divergence_text(figures, language);
  text += highest_kv_text(figures, language);
  return text;
}

std::string plant_json(ClosedLoopFigures const& figures) {
  auto const optional = [](std::optional<double> const& value) {
    return value ? ordered_json(*value) : ordered_json(nullptr);
  };
  ordered_json json{{"version", 1},
                    {"axis", figures.axis},
                    {"distance_mm", figures.distance_mm},
                    {"feed_mm_per_min", figures.feed_mm_per_min},
                    {"kv_per_s", figures.kv},
                    {"improved_position_control", figures.has_function},
                    {"oscillations", ordered_json::array()}};
  for (auto const& found : figures.oscillations) {
    json["oscillations"].push_back({{"phase", found.phase == MovePhase::travel ? "travel" : "after_braking"},
                                    {"frequency_hz", found.without.frequency},
                                    {"amplitude_without_m_per_s2", found.without.amplitude},
                                    {"amplitude_with_m_per_s2", optional(found.with)}});
  }
  json["max_additive_velocity_um_per_s"] = figures.largest_additive;
  json["additive_velocity_limit_um_per_s"] = figures.limit;
  json["limit_hit"] = figures.limit_hit;
  json["diverges"] = figures.diverges_with;
  json["diverges_without"] = figures.diverges_without;
  json["highest_kv_without_per_s"] = optional(figures.highest_kv_without);
  json["highest_kv_with_per_s"] = optional(figures.highest_kv_with);
  json["kv_searched_to_per_s"] = motion::kv_search_end;
  return json_document(json);
}

std::string plant_csv(motion::LoopRecord const& without, motion::LoopRecord const& with,
                      double cycle_seconds) {
  std::string text =
      "time_s,setpoint_mm,load_without_mm,load_with_mm,load_acceleration_without_m_per_s2,"
      "load_acceleration_with_m_per_s2,additive_velocity_um_per_s\n";
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::size_t const count = std::max(without.cycles.size(), with.cycles.size());
  for (std::size_t n = 0; n < count; ++n) {
    bool const has_without = n < without.cycles.size();
    bool const has_with = n < with.cycles.size();
    auto const& a = has_without ? without.cycles[n] : with.cycles[n];
    auto const& b = has_with ? with.cycles[n] : without.cycles[n];
    append_csv_row(text,
                   std::array{static_cast<double>(n) * cycle_seconds, a.setpoint / motion::units_per_mm,
                              has_without ? a.load_position / motion::units_per_mm : nan,
                              has_with ? b.load_position / motion::units_per_mm : nan,
                              has_without ? a.load_acceleration : nan, has_with ? b.load_acceleration : nan,
                              has_with ? b.additive_velocity : nan});
  }
  return text;
}

}  // namespace axisc
