#include "cli/options/contour_words.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"

namespace axisc::cli::says {

constexpr Sentence option_feed{"feed rates in mm/min (default: 1000)",
                               "Vorschübe in mm/min (Standardwert: 1000)"};
constexpr Sentence option_order{"orders instead of the lists'", "Ordnungen statt derer der Listen"};
constexpr Sentence option_angle{"change of direction at the corner in degrees, 0 to 180 (default: 90)",
                                "Richtungsänderung an der Ecke in Grad, 0 bis 180 (Standardwert: 90)"};
constexpr Sentence option_radius{"radius of the circle in mm (default: 10)",
                                 "Radius des Kreises in mm (Standardwert: 10)"};
constexpr Sentence option_tolerance{
    "allowed axis error in mm: which feed and which order keep it",
    "erlaubter Achsfehler in mm: welcher Vorschub, welche Ordnung hält ihn ein"};
constexpr Sentence bad_angle{"--angle needs a number from 0 to 180, not \"{value}\"",
                             "--angle braucht eine Zahl von 0 bis 180, nicht \"{value}\""};
constexpr Sentence bad_orders{"--order needs whole numbers from 0 to {limit}, not \"{value}\"",
                              "--order braucht ganze Zahlen von 0 bis {limit}, nicht \"{value}\""};

}  // namespace axisc::cli::says

namespace axisc::cli {

ContourRequest read_contour_words(ContourWords const& words) {
  ContourRequest wanted;
  if (words.feeds) {
    wanted.feeds.clear();
    for (auto const& word : split_list(*words.feeds)) {
      wanted.feeds.push_back(positive_number("--feed", word, "mm/min"));
    }
    if (wanted.feeds.empty()) wanted.feeds.push_back(positive_number("--feed", *words.feeds, "mm/min"));
  }
  if (words.orders) {
    wanted.orders.clear();
    for (auto const& word : split_list(*words.orders)) {
      auto const order = parse_count(word);
      if (!order || *order > design::longest_kernel_order) {
        throw Failure(
            {says::bad_orders, {{"limit", std::to_string(design::longest_kernel_order)}, {"value", word}}});
      }
      wanted.orders.emplace_back(static_cast<std::uint32_t>(*order));
    }
    if (wanted.orders.empty()) {
      throw Failure({says::bad_orders,
                     {{"limit", std::to_string(design::longest_kernel_order)}, {"value", *words.orders}}});
    }
  }
  if (words.angle) {
    auto const angle = parse_finite(*words.angle);
    if (!angle || *angle < 0 || *angle > 180) {
      throw Failure({says::bad_angle, {{"value", *words.angle}}});
    }
    wanted.angle_deg = *angle;
  }
  if (words.radius) wanted.radius_mm = positive_number("--radius", *words.radius, "mm");
  if (words.tolerance) wanted.tolerance_mm = positive_number("--tolerance", *words.tolerance, "mm");
  return wanted;
}

void declare_feeds(CommandLine& command_line, ContourWords& words) {
  command_line.value("--feed", "F[,F...]", words.feeds, says::option_feed);
}

void declare_orders(CommandLine& command_line, ContourWords& words) {
  command_line.value("--order", "N[,N...]", words.orders, says::option_order);
}

void declare_angle(CommandLine& command_line, ContourWords& words) {
  command_line.value("--angle", "DEGREES", words.angle, says::option_angle);
}

void declare_radius(CommandLine& command_line, ContourWords& words) {
  command_line.value("--radius", "MM", words.radius, says::option_radius);
}

void declare_tolerance(CommandLine& command_line, ContourWords& words) {
  command_line.value("--tolerance", "MM", words.tolerance, says::option_tolerance);
}

}  // namespace axisc::cli
