// AX4014: lists and machine file must agree on masters and slaves.
#include "validator/engine/rule.hpp"

#include "validator/rules/control_numbers.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/views/gantry.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax4014::says {

constexpr Sentence no_master{"the gantry slave \"{axis}\" does not name a master",
                             "die Gantry-Slaveachse „{axis}“ nennt keine Masterachse"};
constexpr Sentence number_names{"{p_axis}: the logical number of the master; 0 means none",
                                "{p_axis}: die logische Nummer der Masterachse; 0 bedeutet keine"};
constexpr Sentence no_such_axis{
    "the gantry slave \"{axis}\" names axis {number} as its master, which this machine does not have",
    "die Gantry-Slaveachse „{axis}“ nennt Achse {number} als Masterachse, die es in dieser Maschine nicht "
    "gibt"};
constexpr Sentence itself{
    "the gantry slave \"{axis}\" names itself, axis {number}, as its master",
    "die Gantry-Slaveachse „{axis}“ nennt sich selbst, Achse {number}, als Masterachse"};
constexpr Sentence no_master_bit{
    "axis \"{axis}\" is the master of a gantry, but its mode does not have the master bit",
    "Achse „{axis}“ ist Masterachse eines Gantryverbunds, aber ihrer Betriebsart fehlt das Masterbit"};
constexpr Sentence names_no_master{
    R"(the gantry slave "{axis}" names "{master}" as its master, whose mode does not have the master bit)",
    "die Gantry-Slaveachse „{axis}“ nennt „{master}“ als Masterachse, deren Betriebsart das Masterbit "
    "fehlt"};
constexpr Sentence named_here{"\"{axis}\" names it as its master", "„{axis}“ nennt sie als Masterachse"};
constexpr Sentence mode_here{"the mode of \"{axis}\"", "die Betriebsart von „{axis}“"};
constexpr Sentence bits{"{p_axis}: 0x10000 means gantry master, 0x20000 gantry slave",
                        "{p_axis}: 0x10000 bedeutet Gantry-Masterachse, 0x20000 Gantry-Slaveachse"};
constexpr Sentence reaction_no_number{"it reports that the slave does not name a master",
                                      "sie meldet, dass die Slaveachse keine Masterachse nennt"};
constexpr Sentence reaction_no_master{
    "it warns that the named axis is not configured as master",
    "sie warnt, dass die genannte Achse nicht als Masterachse konfiguriert ist"};
constexpr Sentence no_slave_bit{
    "the machine file calls \"{axis}\" a gantry slave, but its mode does not",
    "die Maschinendatei nennt „{axis}“ eine Gantry-Slaveachse, ihre Betriebsart aber nicht"};
constexpr Sentence other_master{
    "list and machine file give the gantry slave \"{axis}\" different masters",
    "Liste und Maschinendatei geben der Gantry-Slaveachse „{axis}“ verschiedene Masterachsen"};
constexpr Sentence claim_here{"the machine file says so here", "hier sagt es die Maschinendatei"};
constexpr Sentence lists_count{"the control knows only the lists; they apply",
                               "die Steuerung kennt nur die Listen, also gelten sie"};
constexpr Sentence help_number{"set `{parameter}` to the number of the master",
                               "`{parameter}` auf die Nummer der Masterachse setzen"};
constexpr Sentence help_bit{"add 0x10000 to `{parameter}` of the master",
                            "in `{parameter}` der Masterachse 0x10000 ergänzen"};
constexpr Sentence help_agree{"make the machine file agree with the lists, or correct the list",
                              "die Maschinendatei den Listen anpassen, oder die Liste berichtigen"};

}  // namespace axisc::validator::checks::ax4014::says

namespace axisc::validator::checks::ax4014 {
namespace {

// Message numbers of the control.
constexpr std::string_view no_master_number = "110244";
constexpr std::string_view no_master = "70124";

class GantryJudge {
 public:
  GantryJudge(LoadedMachine const& machine, Report& report) : machine_(machine), report_(report) {}

  void judge(std::size_t axis) {
    GantryView const view(values(axis));
    if (view.is_slave()) {
      judge_slave(axis, view);
    } else if (GantryClaim const* const claim = slave_claim(machine_, axis)) {
      judge_claimed_slave(axis, view, *claim);
    }
    judge_claimed_master(axis, view);
  }

 private:
  [[nodiscard]] EffectiveValues const& values(std::size_t axis) const {
    return machine_.axes[axis].merged.values;
  }
  [[nodiscard]] std::string const& name(std::size_t axis) const { return machine_.axes[axis].name; }

  Finding& add(std::size_t axis, EffectiveValue const& at, SentenceRef text,
               std::vector<Argument> arguments = {}) {
    report_.axis = name(axis);
    arguments.push_back({"axis", name(axis)});
    return report_.add(at, {text, std::move(arguments)});
  }

  /// Reports a contradiction between lists and machine file.
  void disagree(std::size_t axis, EffectiveValue const& at, SentenceRef text, GantryClaim const& claim) {
    Finding& finding = add(axis, at, text);
    finding.related.push_back({claim.place, {says::claim_here, {}}});
    finding.notes.push_back({says::lists_count, {}});
    finding.help.push_back({says::help_agree, {}});
    finding.control.reset();
  }

  void judge_slave(std::size_t axis, GantryView const& view) {
    GantryClaim const* const claim = slave_claim(machine_, axis);
    auto const number = view.named_master();
    if (!number) {
      if (claim == nullptr && !view.master_number.unusable) without_master(axis, view);
      return;
    }
    auto const master = axis_numbered(machine_, *number);
    if (!master || *master == axis) {
      if (!knows_other_axes() || !all_numbers_usable()) return;
      Finding& finding = add(axis, view.master_number, master ? says::itself : says::no_such_axis,
                             {{"number", checks::number(*number)}});
      finding.help.push_back({says::help_number, {{"parameter", parameter_name(view.master_number)}}});
      react(finding, no_master, {says::reaction_no_master, {}});
      return;
    }
    if (claim != nullptr && claim->master != master) {
      disagree(axis, view.master_number, says::other_master, *claim);
    }
    require_master_bit(axis, view, *master);
  }

  void without_master(std::size_t axis, GantryView const& view) {
    EffectiveValue const& at = view.master_number.set() ? view.master_number : view.mode;
    Finding& finding = add(axis, at, says::no_master);
    finding.notes.push_back({says::number_names, {{"p_axis", parameter_number(view.master_number)}}});
    finding.help.push_back({says::help_number, {{"parameter", parameter_name(view.master_number)}}});
    react(finding, no_master_number, {says::reaction_no_number, {}});
  }

  void require_master_bit(std::size_t slave, GantryView const& view, std::size_t master) {
    GantryView const other(values(master));
    bool const added = other.open() && master_claim(machine_, master) != nullptr;
    if (other.is_master() || added || other.mode.unusable) return;
    bool const at_master = other.mode.value_place() && view.master_number.value_place() &&
                           *view.master_number.value_place() < *other.mode.value_place();
    Finding& finding =
        at_master ? add(master, other.mode, says::no_master_bit)
                  : add(slave, view.master_number, says::names_no_master, {{"master", name(master)}});
    EffectiveValue const& rest = at_master ? view.master_number : other.mode;
    if (rest.value_place()) {
      finding.related.push_back(
          {*rest.value_place(),
           {at_master ? says::named_here : says::mode_here, {{"axis", name(at_master ? slave : master)}}}});
    }
    finding.notes.push_back({says::bits, {{"p_axis", parameter_number(other.mode)}}});
    finding.help.push_back({says::help_bit, {{"parameter", parameter_name(other.mode)}}});
    react(finding, no_master, {says::reaction_no_master, {}});
  }

  void judge_claimed_slave(std::size_t axis, GantryView const& view, GantryClaim const& claim) {
    if (!view.open()) {
      disagree(axis, view.mode, says::no_slave_bit, claim);
      return;
    }
    auto const number = view.named_master();
    if (number && axis_numbered(machine_, *number) != claim.master) {
      disagree(axis, view.master_number, says::other_master, claim);
    }
  }

  void judge_claimed_master(std::size_t axis, GantryView const& view) {
    GantryClaim const* const claim = master_claim(machine_, axis);
    if (claim == nullptr || view.open() || view.is_master()) return;
    disagree(axis, view.mode, says::no_master_bit, *claim);
  }

  /// Not for a list alone, for one axis exported from a project, and where the list of an axis is missing or
  /// does not say its number.
  [[nodiscard]] bool knows_other_axes() const {
    if (!machine_.start_up) return machine_.machine_file.has_value();
    bool const is_part = machine_.start_up->is_project && machine_.axes.size() == 1;
    return machine_.knows_all_axes && !is_part &&
           std::all_of(machine_.axes.begin(), machine_.axes.end(), has_own_number);
  }

  [[nodiscard]] bool all_numbers_usable() const {
    return std::none_of(machine_.axes.begin(), machine_.axes.end(), [](LoadedAxis const& axis) {
      return axis.merged.values.at("kopf.achs_nr").unusable;
    });
  }

  LoadedMachine const& machine_;
  Report& report_;
};

void gantry_broken(MachineContext const& context, Report& report) {
  GantryJudge judge(context.machine, report);
  for (std::size_t axis = 0; axis < context.machine.axes.size(); ++axis) judge.judge(axis);
}

}  // namespace

extern constinit Rule const rule{
    .control = control_numbers<no_master_number, no_master>,
    .parameters = "kenngr.gantry_ax_nr kenngr.achs_mode kopf.achs_nr",
    .check = gantry_broken,
};

}  // namespace axisc::validator::checks::ax4014
