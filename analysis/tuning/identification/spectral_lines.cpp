#include "analysis/tuning/identification/spectral_lines.hpp"

#include "analysis/motion/spectrum.hpp"
#include "analysis/motion/statistics.hpp"
#include "analysis/tuning/identification/line_spectrum.hpp"
#include "analysis/tuning/identification/thresholds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace axisc::tuning {
namespace {

/// Errors of single pieces have causes in common: the standard error alone says too little. Of the frequency.
constexpr double least_uncertainty = 0.005;
/// Multiples of a proportional line that are looked for.
constexpr double most_multiples = 12;

struct PieceLines {
  double speed = 0;
  double step = 0;  ///< Hz between lines of the spectrum
  std::vector<Line> lines;
};

/// A line in some of the pieces.
struct Match {
  std::vector<double> values;  ///< frequency, or frequency divided by the speed
  std::vector<double> speeds;
  double amplitude = 0;  ///< mean

  [[nodiscard]] double mean() const { return motion::mean(values); }
};

std::vector<PieceLines> lines_in(std::span<SteadySignal const> pieces, double lowest, double highest) {
  std::vector<PieceLines> found;
  for (auto const& piece : pieces) {
    found.push_back({.speed = piece.speed,
                     .step = piece.sampling_rate / static_cast<double>(piece.values.size()),
                     .lines = lines_of(piece.values, piece.sampling_rate, lowest,
                                       std::min(highest, highest_share * piece.sampling_rate))});
  }
  return found;
}

class LineSearch {
 public:
  explicit LineSearch(std::vector<PieceLines> pieces) : pieces_(std::move(pieces)) {
    slowest_ = fastest_ = pieces_.front().speed;
    for (auto const& piece : pieces_) {
      slowest_ = std::min(slowest_, piece.speed);
      fastest_ = std::max(fastest_, piece.speed);
    }
  }

  [[nodiscard]] bool has_speeds() const { return fastest_ >= different_speeds * slowest_; }
  [[nodiscard]] double slowest() const { return slowest_; }

  /// Lines that enough of the pieces show, the one that most show first; `is_proportional`: at a frequency
  /// that is the speed times a number.
  [[nodiscard]] std::vector<Match> matches(bool is_proportional) const {
    std::vector<Match> found;
    for (auto const& piece : pieces_) {
      for (auto const& line : piece.lines) {
        auto match =
            matched(is_proportional ? line.frequency / piece.speed : line.frequency, is_proportional);
        if (!is_enough(match)) continue;
        match = matched(match.mean(), is_proportional);
        if (is_enough(match)) add(found, std::move(match));
      }
    }
    std::sort(found.begin(), found.end(), [](Match const& a, Match const& b) { return a.mean() < b.mean(); });
    return found;
  }

  /// At each speed the line is another multiple of a proportional one.
  [[nodiscard]] bool is_ambiguous(double frequency, std::vector<Match> const& proportional) const {
    return std::any_of(proportional.begin(), proportional.end(), [&](Match const& match) {
      return std::all_of(pieces_.begin(), pieces_.end(), [&](PieceLines const& piece) {
        double const base = match.mean() * piece.speed;
        double const multiple = std::round(frequency / base);
        return multiple >= 1 && multiple <= most_multiples &&
               std::abs(frequency - multiple * base) <= tolerance(piece, frequency);
      });
    });
  }

 private:
  /// How far a line may be from where it is expected, Hz.
  [[nodiscard]] double tolerance(PieceLines const& piece, double frequency) const {
    double const measured = std::max(line_movement * piece.step, line_movement_share * frequency);
    return std::min(measured, movement_with_speed * (fastest_ / slowest_ - 1) * frequency);
  }

  [[nodiscard]] Match matched(double value, bool is_proportional) const {
    Match match;
    for (auto const& piece : pieces_) {
      double const expected = is_proportional ? value * piece.speed : value;
      Line const* nearest = nullptr;
      for (auto const& line : piece.lines) {
        double const distance = std::abs(line.frequency - expected);
        if (distance > tolerance(piece, expected)) continue;
        if (nearest == nullptr || distance < std::abs(nearest->frequency - expected)) nearest = &line;
      }
      if (nearest == nullptr) continue;
      match.values.push_back(is_proportional ? nearest->frequency / piece.speed : nearest->frequency);
      match.speeds.push_back(piece.speed);
      match.amplitude += nearest->amplitude;
    }
    if (!match.values.empty()) match.amplitude /= static_cast<double>(match.values.size());
    return match;
  }

  /// Most pieces show it, and half of those at the lowest and of those at the highest speeds.
  [[nodiscard]] bool is_enough(Match const& match) const {
    auto const share = [&](auto belongs) {
      auto const all = std::count_if(pieces_.begin(), pieces_.end(),
                                     [&](PieceLines const& piece) { return belongs(piece.speed); });
      auto const shown = std::count_if(match.speeds.begin(), match.speeds.end(), belongs);
      return all == 0 ? 1 : static_cast<double>(shown) / static_cast<double>(all);
    };
    constexpr double half = 0.5;
    return match.values.size() >= fewest_pieces && share([](double) { return true; }) >= most_pieces_share &&
           share([&](double speed) { return speed * different_speeds <= fastest_; }) >= half &&
           share([&](double speed) { return speed >= different_speeds * slowest_; }) >= half;
  }

  /// Unless it is one that was found already.
  static void add(std::vector<Match>& found, Match match) {
    double const mean = match.mean();
    auto const same = std::find_if(found.begin(), found.end(), [mean](Match const& other) {
      return std::abs(other.mean() - mean) <= 2 * line_movement_share * mean;
    });
    if (same == found.end()) {
      found.push_back(std::move(match));
    } else if (match.values.size() > same->values.size()) {
      *same = std::move(match);
    }
  }

  std::vector<PieceLines> pieces_;
  double slowest_ = 0, fastest_ = 0;
};

bool is_of_mains(double frequency) {
  return std::any_of(mains_frequencies.begin(), mains_frequencies.end(), [frequency](double mains) {
    double const multiple = std::max(1.0, std::round(frequency / mains));
    return std::abs(frequency - multiple * mains) <= mains_distance;
  });
}

/// Both halves of the rest show lines.
bool is_long(SteadySignal const& rest) {
  std::size_t const half = rest.values.size() / 2;
  return static_cast<double>(half) >= shortest_piece * rest.sampling_rate;
}

/// Rests show the line too, and it does not die away there.
bool is_at_rest(Match const& match, std::span<SteadySignal const> rests) {
  std::vector<double> shares, remainders;
  for (auto const& rest : rests) {
    if (!is_long(rest)) continue;
    std::size_t const half = rest.values.size() / 2;
    auto const amplitude = [&](std::span<double const> part) {
      return motion::amplitude_at(part, 1 / rest.sampling_rate, match.mean());
    };
    double const late = amplitude(rest.values.last(half));
    shares.push_back(late / match.amplitude);
    remainders.push_back(late /
                         std::max(amplitude(rest.values.first(half)), std::numeric_limits<double>::min()));
  }
  return !shares.empty() && motion::median(shares) >= rest_share &&
         motion::median(remainders) >= rest_remainder;
}

}  // namespace

SpectralLines spectral_lines(std::span<SteadySignal const> pieces, std::span<SteadySignal const> rests,
                             double lowest, double highest) {
  SpectralLines found{.lines = {},
                      .doubt = LinesDoubt::few_pieces,
                      .were_rests_compared = std::any_of(rests.begin(), rests.end(), is_long)};
  if (pieces.size() < fewest_pieces) return found;
  LineSearch const search(lines_in(pieces, lowest, highest));
  if (!search.has_speeds()) {
    found.doubt = LinesDoubt::one_speed;
    return found;
  }
  found.doubt = LinesDoubt::no_lines;
  auto const proportional = search.matches(true);
  for (auto const& match : search.matches(false)) {
    double const frequency = match.mean();
    auto const kind = is_of_mains(frequency)                         ? LineKind::mains
                      : search.is_ambiguous(frequency, proportional) ? LineKind::ambiguous
                      : is_at_rest(match, rests)                     ? LineKind::at_rest
                                                                     : LineKind::constant;
    if (kind == LineKind::constant) found.doubt = std::nullopt;
    found.lines.push_back({.kind = kind,
                           .frequency = frequency,
                           .frequency_uncertainty =
                               std::max(motion::standard_error(match.values), least_uncertainty * frequency),
                           .amplitude = match.amplitude});
  }
  for (auto const& match : proportional) {
    found.lines.push_back({.kind = LineKind::proportional,
                           .frequency = match.mean() * search.slowest(),
                           .frequency_uncertainty = motion::standard_error(match.values) * search.slowest(),
                           .amplitude = match.amplitude,
                           .distance = 1 / match.mean()});
  }
  return found;
}

}  // namespace axisc::tuning
