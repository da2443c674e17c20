// `--measured`.
#pragma once

#include "analysis/tuning/identification/modes.hpp"
#include "axisc/answers/suggestion/measured_signals.hpp"
#include "presentation/document.hpp"

#include <string>
#include <vector>

namespace axisc {

/// A column that was used, and for what: "in", or "run.csv: in" of one of several files.
struct NamedColumn {
  std::string signal;
  MappedColumn column;
};

struct MeasuredResonances {
  std::vector<NamedColumn> mapping;  ///< of signals
  tuning::ModeSearch found;          ///< with a mode at least
  bool has_spectrum = false;         ///< which does not say what made its peaks
  std::string unit;                  ///< of the setpoint; may be empty
};

/// Resonances in recordings of one axis (at least one), each two signals, a response or a spectrum. Failure
/// (AX9005) for a file that is not a measurement, and where the recordings show no resonance, or not one that
/// all of them bear out: it says what to record. AX9001 for a file that cannot be read.
[[nodiscard]] MeasuredResonances measured_resonances(std::vector<std::string> const& paths,
                                                     MeasuredAxis const& axis, SignalColumns const& columns);

/// The resonances, lines that are none, and the columns.
void add_measured(std::vector<presentation::Block>& blocks, MeasuredResonances const& measured);

}  // namespace axisc
