#include "axisc/answers/simulation/plant_answer.hpp"

#include "axisc/answers/execution/path_dynamics.hpp"

namespace axisc::says {

constexpr Sentence plant_title{"axis {axis}: {distance} there and back at {feed}, Kv {kv} 1/s",
                               "Achse {axis}: {distance} hin und zurück mit {feed}, Kv {kv} 1/s"};
constexpr Sentence frequency{"load at", "Last bei"};
constexpr Sentence phase{"while", "während"};
constexpr Sentence travel{"travelling", "Verfahren"};
constexpr Sentence ramps{"at rest after braking", "Stillstand nach dem Bremsen"};
constexpr Sentence without{"without", "ohne"};
constexpr Sentence with{"with", "mit"};
constexpr Sentence v_add{"largest additive velocity {velocity} of {limit}",
                         "größte additive Geschwindigkeit {velocity} von {limit}"};
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
constexpr Sentence kv_alone{"highest Kv without oscillation: {without}",
                            "höchstes Kv ohne Schwingung: {without}"};
constexpr Sentence kv_found{"{kv} 1/s", "{kv} 1/s"};
constexpr Sentence kv_above{"above {kv} 1/s", "über {kv} 1/s"};
constexpr Sentence kv_none{"below 1 1/s", "unter 1 1/s"};

}  // namespace axisc::says

namespace axisc {

namespace {

using motion::MovePhase;
using namespace presentation;

Words kv_words(std::optional<double> kv) {
  if (!kv) return {says::kv_above, {{"kv", exact(motion::kv_search_end)}}};
  if (*kv == 0) return says::kv_none;
  return {says::kv_found, {{"kv", fixed(*kv, Unit::none, 1)}}};
}

Table oscillations(ClosedLoopFigures const& figures) {
  constexpr auto acceleration = Unit::metre_per_second_squared;
  return table_of(
      "oscillations",
      {head_column("frequency_hz", says::frequency, Unit::hertz), head_column("phase", says::phase),
       column("amplitude_without_m_per_s2", says::without, acceleration),
       column("amplitude_with_m_per_s2", says::with, acceleration)},
      figures.oscillations, [](PhaseOscillation const& found) {
        bool const travels = found.phase == MovePhase::travel;
        return Row{fixed(found.without.frequency, Unit::hertz, 1),
                   travels ? Symbol{"travel", says::travel} : Symbol{"after_braking", says::ramps},
                   fixed(found.without.amplitude, acceleration, 3),
                   quantity_or({}, found.with, acceleration, Digits::decimals(3))};
      });
}

std::optional<Words> divergence(ClosedLoopFigures const& figures) {
  if (!figures.diverges_without && !figures.diverges_with) return std::nullopt;
  if (!figures.has_function) return says::diverges;
  if (!figures.diverges_without) return says::diverges_with;
  return figures.diverges_with ? says::diverges_always : says::diverges_without;
}

}  // namespace

presentation::Document plant_answer(ClosedLoopFigures const& figures) {
  auto const distance = exact(figures.distance_mm, Unit::millimetre);
  auto const feed = fixed(figures.feed_mm_per_min, Unit::millimetre_per_minute, 0);
  auto const gain = exact(figures.kv);
  auto const additive = fixed(figures.largest_additive, Unit::micrometre_per_second, 0);
  auto const limit = fixed(figures.limit, Unit::micrometre_per_second, 0);
  presentation::Document answer{
      .title = Words(says::plant_title,
                     {{"axis", figures.axis}, {"distance", distance}, {"feed", feed}, {"kv", gain}}),
      .blocks = {
          Facts{{data("axis", figures.axis), data("slope", slope_name(figures.channel.slope)),
                 data("channel_list", figures.channel.is_from_list), data("distance_mm", distance),
                 data("feed_mm_per_min", feed), data("kv_per_s", gain),
                 data("improved_position_control", figures.has_function),
                 data("max_additive_velocity_um_per_s", additive),
                 data("additive_velocity_limit_um_per_s", limit), data("limit_hit", figures.limit_hit),
                 data("diverges", figures.diverges_with), data("diverges_without", figures.diverges_without),
                 data("highest_kv_without_per_s", figures.highest_kv_without),
                 data("highest_kv_with_per_s", figures.highest_kv_with),
                 data("kv_searched_to_per_s", motion::kv_search_end)}},
          Paragraph{slope_words(figures.channel)}, oscillations(figures)}};
  auto const tell = [&answer](Words words) { answer.blocks.emplace_back(Paragraph{std::move(words)}); };
  tell(figures.has_function ? Words(says::v_add, {{"velocity", additive}, {"limit", limit}})
                            : Words(says::no_function, {{"axis", figures.axis}}));
  if (figures.limit_hit) tell(says::limit_hit);
  if (auto words = divergence(figures)) tell(*std::move(words));
  tell(Words(
      figures.has_function ? SentenceRef(says::kv) : says::kv_alone,
      {{"without", kv_words(figures.highest_kv_without)}, {"with", kv_words(figures.highest_kv_with)}}));
  return answer;
}

}  // namespace axisc
