#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"

namespace axisc::validator::says {

constexpr Sentence startup{"this is a start-up list, not an axis list: it is not checked",
                           "das ist eine Hochlaufliste, keine Achsliste: sie wird nicht geprüft"};
constexpr Sentence channel{"this is a channel list, not an axis list: it is not checked",
                           "das ist eine Kanalliste, keine Achsliste: sie wird nicht geprüft"};
constexpr Sentence real_time{"this is a real-time list, not an axis list: it is not checked",
                             "das ist eine Echtzeitliste, keine Achsliste: sie wird nicht geprüft"};
constexpr Sentence manual{"this is a list of the manual mode, not an axis list: it is not checked",
                          "das ist eine Handbetriebsliste, keine Achsliste: sie wird nicht geprüft"};
constexpr Sentence tool{"this is a tool list, not an axis list: it is not checked",
                        "das ist eine Werkzeugliste, keine Achsliste: sie wird nicht geprüft"};
constexpr Sentence zero_offset{
    "this is a list of zero offsets, not an axis list: it is not checked",
    "das ist eine Liste der Nullpunktverschiebungen, keine Achsliste: sie wird nicht geprüft"};
constexpr Sentence clamp_offset{
    "this is a list of clamp position offsets, not an axis list: it is not checked",
    "das ist eine Liste der Platzversätze, keine Achsliste: sie wird nicht geprüft"};
constexpr Sentence compensation{"this is a compensation list, not an axis list: it is not checked",
                                "das ist eine Kompensationsliste, keine Achsliste: sie wird nicht geprüft"};
constexpr Sentence external_variables{
    "this is a list of external variables, not an axis list: it is not checked",
    "das ist eine Liste externer Variablen, keine Achsliste: sie wird nicht geprüft"};
constexpr Sentence hardware{
    "this is a hardware configuration list, not an axis list: it is not checked",
    "das ist eine Liste der Hardwarekonfiguration, keine Achsliste: sie wird nicht geprüft"};
constexpr Sentence setting_control{
    "this is a list of the collision monitoring, not an axis list: it is not checked",
    "das ist eine Liste der Kollisionsüberwachung, keine Achsliste: sie wird nicht geprüft"};
constexpr Sentence volumetric_compensation{
    "this is a list of the volumetric compensation, not an axis list: it is not checked",
    "das ist eine Liste der volumetrischen Kompensation, keine Achsliste: sie wird nicht geprüft"};
constexpr Sentence cycle_module{
    "this is a list of cycle modules, not an axis list: it is not checked",
    "das ist eine Liste der Zyklusmodule, keine Achsliste: sie wird nicht geprüft"};
constexpr Sentence help{"name the list of an axis in the machine file",
                        "in der Maschinendatei die Liste einer Achse nennen"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

SentenceRef headline(configuration::ListKind kind) {
  using Kind = configuration::ListKind;
  switch (kind) {
    case Kind::axis:
    case Kind::startup:
      break;
    case Kind::channel:
      return says::channel;
    case Kind::real_time:
      return says::real_time;
    case Kind::manual:
      return says::manual;
    case Kind::tool:
      return says::tool;
    case Kind::zero_offset:
      return says::zero_offset;
    case Kind::clamp_offset:
      return says::clamp_offset;
    case Kind::compensation:
      return says::compensation;
    case Kind::external_variables:
      return says::external_variables;
    case Kind::hardware:
      return says::hardware;
    case Kind::setting_control:
      return says::setting_control;
    case Kind::volumetric_compensation:
      return says::volumetric_compensation;
    case Kind::cycle_module:
      return says::cycle_module;
  }
  return says::startup;
}

void kind_not_checked(MachineContext const& context, Report& report) {
  // What a start-up list names is AX7009.
  if (context.machine.start_up) return;
  for (NamedList const& named : context.machine.lists) {
    if (named.list.kind == configuration::ListKind::axis) continue;
    std::uint32_t const begin = context.sources[named.list.source].text_begin();
    Finding& finding = report.add(Place{.source = named.list.source, .span = {.begin = begin, .end = begin}},
                                  message(headline(named.list.kind)));
    if (!context.machine.machine_file) continue;
    finding.severity = Severity::error;
    finding.help.push_back(message(says::help));
  }
}

}  // namespace

extern constinit Rule const ax7001{
    .code = Code{7001},
    .name = "kind-not-checked",
    .severity = Severity::note,
    .always = true,
    .check = kind_not_checked,
};

}  // namespace axisc::validator::checks
