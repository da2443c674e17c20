// A sentence about XML that lists and projects share.
#pragma once

#include "diagnostics/sentence.hpp"

namespace axisc::configuration::says {

inline constexpr Sentence xml_spelling{
    "{written} is not read, because names in XML have one spelling, without a prefix; write {meant}",
    "{written} wird nicht gelesen, denn Namen in XML haben eine einzige Schreibweise, ohne Präfix; {meant} "
    "schreiben"};

}  // namespace axisc::configuration::says
