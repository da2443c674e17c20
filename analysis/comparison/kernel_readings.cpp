#include "analysis/comparison/kernel_readings.hpp"

#include <array>

namespace axisc::comparison::says {

constexpr Sentence taps_n{"order N means N taps", "Ordnung N heißt N Koeffizienten"};
constexpr Sentence taps_n_1{"order N means N + 1 taps", "Ordnung N heißt N + 1 Koeffizienten"};
constexpr Sentence half_width_down{"half the width is N/2, rounded down",
                                   "die halbe Breite ist N/2, abgerundet"};
constexpr Sentence half_width_n{"order N is half the width, 2N + 1 taps",
                                "Ordnung N ist die halbe Breite, 2N + 1 Koeffizienten"};
constexpr Sentence gauss_1{"Gaussian of standard deviation quality × half width",
                           "Gauß mit Standardabweichung Güte × halbe Breite"};
constexpr Sentence gauss_2{"Gaussian of standard deviation quality × half width / 2",
                           "Gauß mit Standardabweichung Güte × halbe Breite / 2"};
constexpr Sentence gauss_3{"Gaussian of standard deviation quality × half width / 3",
                           "Gauß mit Standardabweichung Güte × halbe Breite / 3"};
constexpr Sentence hann{"sinc in Hann's window", "Sinc im Hann-Fenster"};
constexpr Sentence blackman{"sinc in Blackman's window", "Sinc im Blackman-Fenster"};
constexpr Sentence no_window{"sinc without a window", "Sinc ohne Fenster"};
constexpr Sentence novib_box{"NoVib is one box of a period of fg_f0, not two",
                             "NoVib ist ein Rechteck einer Periode von fg_f0, nicht zwei"};
constexpr Sentence undelayed_share{"the unfiltered share passes undelayed",
                                   "der ungefilterte Anteil läuft unverzögert"};
constexpr Sentence documented_kernel{"the kernel as axisc computes it without settings",
                                     "der Kern, wie axisc ihn ohne Einstellungen rechnet"};
constexpr Sentence guard_rounded{"the guard's impulses are on the nearest cycles",
                                 "die Impulse des Vibration Guard liegen auf den nächsten Zyklen"};
constexpr Sentence guard_rounded_up{"the guard's impulses are on the cycles that follow",
                                    "die Impulse des Vibration Guard liegen auf den folgenden Zyklen"};
constexpr Sentence guard_zero_placed{"the guard has a zero exactly on its oscillation",
                                     "der Vibration Guard hat eine Nullstelle genau auf seiner Schwingung"};
constexpr Sentence guard_undamped{
    "the guard's impulses are half an undamped period apart",
    "die Impulse des Vibration Guard haben den Abstand einer halben ungedämpften "
    "Periode"};
constexpr Sentence guard_quarters{"mode 4 of the guard is 1/4, 1/2, 1/4",
                                  "Modus 4 des Vibration Guard ist 1/4, 1/2, 1/4"};
constexpr Sentence guard_uncentred{"mode 4 of the guard begins with an impulse at once",
                                   "Modus 4 des Vibration Guard beginnt sofort mit einem Impuls"};
constexpr Sentence no_share{"the share is ignored", "der Anteil wird nicht beachtet"};

}  // namespace axisc::comparison::says

namespace axisc::comparison {

namespace {

using WantedKernel = design::KernelReading;

template <WantedKernel reading>
std::vector<double> read_as(design::KernelSpecification const& listed, design::CycleTime cycle_time) {
  design::KernelSpecification wanted = listed;
  wanted.reading = reading;
  if (design::applied_reading(wanted) != reading) return {};
  return design::design_kernel(wanted, cycle_time).taps;
}

template <WantedKernel reading>
constexpr KernelReading row(SentenceRef meaning) {
  return {{word_of(reading), meaning}, read_as<reading>};
}

// The last one differs from the listed kernel where settings ask for another reading.
constexpr std::array<KernelReading, 20> kernel_rows{
    row<WantedKernel::taps_n>(says::taps_n),
    row<WantedKernel::taps_n_plus_1>(says::taps_n_1),
    row<WantedKernel::half_width_rounded_down>(says::half_width_down),
    row<WantedKernel::order_is_half_width>(says::half_width_n),
    row<WantedKernel::gaussian_width_1>(says::gauss_1),
    row<WantedKernel::gaussian_width_2>(says::gauss_2),
    row<WantedKernel::gaussian_width_3>(says::gauss_3),
    row<WantedKernel::sinc_hann>(says::hann),
    row<WantedKernel::sinc_blackman>(says::blackman),
    row<WantedKernel::sinc_no_window>(says::no_window),
    row<WantedKernel::novib_one_box>(says::novib_box),
    row<WantedKernel::share_undelayed>(says::undelayed_share),
    row<WantedKernel::share_ignored>(says::no_share),
    row<WantedKernel::guard_rounded>(says::guard_rounded),
    row<WantedKernel::guard_rounded_up>(says::guard_rounded_up),
    row<WantedKernel::guard_zero_placed>(says::guard_zero_placed),
    row<WantedKernel::guard_undamped_spacing>(says::guard_undamped),
    row<WantedKernel::guard_quarters>(says::guard_quarters),
    row<WantedKernel::guard_uncentred>(says::guard_uncentred),
    {{documented_kernels, says::documented_kernel}, read_as<WantedKernel::documented>}};

}  // namespace

std::span<KernelReading const> kernel_readings() {
  return kernel_rows;
}

}  // namespace axisc::comparison
