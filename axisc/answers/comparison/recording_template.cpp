#include "axisc/answers/comparison/recording_template.hpp"

#include "analysis/recordings/template/scope_template.hpp"
#include "axisc/answers/execution/recorded_scale.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/recorded_choice.hpp"

#include <algorithm>
#include <array>

namespace axisc::says {

constexpr Sentence no_net_id{
    "--emit template needs the AMS NetId of the control: --netid 1.2.3.4.1.1 (TwinCAT shows it under Routes)",
    "--emit template braucht die AMS-NetId der Steuerung: --netid 1.2.3.4.1.1 (TwinCAT zeigt sie unter "
    "Routes)"};
constexpr Sentence bad_net_id{
    "--netid {value}: an AMS NetId has six numbers from 0 to 255, such as 1.2.3.4.1.1",
    "--netid {value}: eine AMS-NetId hat sechs Zahlen von 0 bis 255, wie 1.2.3.4.1.1"};
constexpr Sentence in_no_channel{
    "{machine}: axis {axis} is in no channel, so the objects of its position are not known; give a machine "
    "file with \"groups\", a start-up list or a project",
    "{machine}: Achse {axis} ist in keinem Kanal, die Objekte ihrer Position sind daher nicht bekannt; eine "
    "Maschinendatei mit \"groups\", eine Hochlaufliste oder ein Projekt angeben"};
constexpr Sentence use_template{
    "add the .tcscopex to a Measurement project in TwinCAT, record, and export with TC3ScopeExportTool, or "
    "save the .svdx",
    "die .tcscopex in TwinCAT einem Measurement-Projekt hinzufügen, aufzeichnen und mit TC3ScopeExportTool "
    "exportieren oder die .svdx speichern"};
constexpr Sentence add_torque{
    "add the torque of the drive by hand (dig_drv.act_torque): its index is not documented",
    "das Drehmoment des Antriebs von Hand ergänzen (dig_drv.act_torque): Sein Index ist nicht dokumentiert"};

}  // namespace axisc::says

namespace axisc {

namespace {

using recordings::Object;

std::vector<Object> objects_for(RecordingPurpose purpose) {
  switch (purpose) {
    case RecordingPurpose::compare: return {Object::position_unfiltered, Object::position_filtered};
    case RecordingPurpose::circle:
      return {Object::position_unfiltered, Object::command_position, Object::actual_position};
    case RecordingPurpose::identify: break;
  }
  return {Object::command_position, Object::actual_position, Object::velocity};
}

std::string checked_net_id(std::optional<std::string> const& net_id) {
  if (!net_id) throw Failure({says::no_net_id});
  auto const numbers = split_list(*net_id, '.');
  constexpr std::size_t count = 6;
  constexpr std::uint64_t largest = 255;
  bool const is_sound =
      numbers.size() == count && std::all_of(numbers.begin(), numbers.end(), [](std::string const& number) {
        auto const parsed = parse_count(number);
        return parsed && *parsed <= largest;
      });
  if (!is_sound) throw Failure({says::bad_net_id, {{"value", *net_id}}});
  return *net_id;
}

std::vector<std::size_t> axes_of(TemplateQuestion const& question, machine::Machine const& machine) {
  std::vector<std::size_t> axes;
  if (question.axes) {
    for (auto const& name : split_list(*question.axes)) axes.push_back(axis_named(machine, name));
    std::sort(axes.begin(), axes.end());
    axes.erase(std::unique(axes.begin(), axes.end()), axes.end());
    return axes;
  }
  for (auto const& group : machine.groups) axes.insert(axes.end(), group.axes.begin(), group.axes.end());
  if (axes.empty() && !machine.axes.empty()) axes.push_back(0);
  return axes;
}

}  // namespace

RecordingTemplate recording_template(TemplateQuestion const& question, machine::Machine const& machine,
                                     Language language) {
  constexpr double microseconds = 1000;
  recordings::TemplateOptions const options{.net_id = checked_net_id(question.net_id),
                                            .cycle_ms = machine.cycle_time.microseconds() / microseconds,
                                            .comment = render({says::use_template}, language)};
  std::vector<recordings::TemplateAxis> axes;
  bool const in_machine = machine.axes.size() > 1 || names_machine(question.machine);
  for (auto const axis : axes_of(question, machine)) {
    auto const place = axis_place(machine, axis, in_machine);
    if (place.channel == 0) {
      throw Failure({says::in_no_channel, {{"machine", question.machine}, {"axis", place.name}}});
    }
    auto& made = axes.emplace_back(recordings::TemplateAxis{.name = place.name, .signals = {}});
    for (auto const object : objects_for(question.purpose)) {
      bool const is_of_channel = recordings::row_of(object).is_of_channel;
      made.signals.push_back(
          {.object = object, .channel = place.channel, .axis = is_of_channel ? place.index : place.number});
    }
  }
  RecordingTemplate result{.text = recordings::scope_template(axes, options),
                           .notes = {{says::use_template}}};
  if (question.purpose == RecordingPurpose::identify) result.notes.push_back({says::add_torque});
  return result;
}

}  // namespace axisc
