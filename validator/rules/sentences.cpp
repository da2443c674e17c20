#include "validator/rules/sentences.hpp"

namespace axisc::validator::says {

constinit Sentence const parameter_values{"values: {values}", "Werte: {values}"};
constinit Sentence const parameter_fix{"write `{replacement}`", "`{replacement}` schreiben"};

constinit Sentence const filter_reaction_off{"the filter is switched off", "der Filter wird abgeschaltet"};
constinit Sentence const filter_reaction_refused{"no coefficients can be computed for the filter",
                                                 "für den Filter lassen sich keine Koeffizienten berechnen"};
constinit Sentence const filter_value_ignored{"the value is ignored", "der Wert wird nicht beachtet"};

constinit Sentence const kernel_reaction_not_active{"the filter is not active", "der Filter ist nicht aktiv"};

constinit Sentence const group_axis_delay{"axis \"{axis}\": {cycles}", "Achse „{axis}“: {cycles}"};
constinit Sentence const group_axis_shares{"axis \"{axis}\": {cycles} ({shares})",
                                           "Achse „{axis}“: {cycles} ({shares})"};
constinit Sentence const group_axis_after_filters{"axis \"{axis}\": {cycles} in addition to its filters",
                                                  "Achse „{axis}“: {cycles} zusätzlich zu ihren Filtern"};
constinit Sentence const group_help_same{"configure the filters of all axes of a channel alike",
                                         "die Filter aller Achsen eines Kanals gleich konfigurieren"};

constinit Sentence const fir_type_here{"the type of axis {axis} is set here",
                                       "hier wird der Typ der Achse {axis} gesetzt"};
constinit Sentence const undocumented_reaction{"what it continues with is not documented",
                                               "womit sie weiterarbeitet, ist nicht dokumentiert"};

}  // namespace axisc::validator::says
