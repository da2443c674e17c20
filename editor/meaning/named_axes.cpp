#include "editor/meaning/named_axes.hpp"

#include "configuration/channel_list.hpp"
#include "configuration/list_kind.hpp"
#include "configuration/machine_file.hpp"

#include <algorithm>
#include <deque>

namespace axisc::editor {

namespace {

class NamedAxes {
 public:
  NamedAxes(MachineReading const& reading, validator::LoadedMachine const& machine, std::size_t offset)
      : reading_(reading), machine_(machine), offset_(offset) {}

  [[nodiscard]] std::optional<std::string> in_channel(Document const& document) const {
    auto const channel =
        configuration::read_channel_list(SourceText(document.path, document.text), SourceId{});
    for (auto const* const axes : {&channel.axes, &channel.spindles}) {
      for (auto const& axis : *axes) {
        bool const is_asked =
            axis.number && (is_at(axis.number->place) || (axis.name && is_at(axis.name->place)));
        if (is_asked) return list_of(validator::axis_numbered(machine_, axis.number->number));
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] std::optional<std::string> in_machine_file(Document const& document) const {
    SourceSet sources;
    std::deque<Finding> mistakes;
    auto const source = sources.add(SourceText(document.path, document.text));
    auto const file = configuration::read_machine_file(sources, source, mistakes);
    for (auto const& group : file.groups) {
      for (auto const& axis : group.axes) {
        if (is_at(axis.place)) return list_of(axis_called(axis.text));
      }
    }
    for (auto const& gantry : file.gantries) {
      if (is_at(gantry.master.place)) return list_of(axis_called(gantry.master.text));
      for (auto const& slave : gantry.slaves) {
        if (is_at(slave.place)) return list_of(axis_called(slave.text));
      }
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] bool is_at(Place const& place) const {
    return place.span.begin <= offset_ && offset_ <= place.span.end;
  }
  [[nodiscard]] std::optional<std::size_t> axis_called(std::string const& name) const {
    auto const& axes = machine_.axes;
    auto const found =
        std::find_if(axes.begin(), axes.end(), [&name](auto const& axis) { return axis.name == name; });
    if (found == axes.end()) return std::nullopt;
    return static_cast<std::size_t>(found - axes.begin());
  }
  [[nodiscard]] std::optional<std::string> list_of(std::optional<std::size_t> axis) const {
    if (!axis) return std::nullopt;
    return reading_.sources()[machine_.lists[machine_.axes[*axis].list].list.source].name();
  }

  MachineReading const& reading_;
  validator::LoadedMachine const& machine_;
  std::size_t offset_;
};

}  // namespace

std::optional<std::string> list_of_named_axis(MachineReading const& reading, Document const& document,
                                              std::size_t offset) {
  if (reading.machine() == nullptr) return std::nullopt;
  NamedAxes const axes(reading, *reading.machine(), offset);
  if (document.path.ends_with(".json")) {
    bool const is_machine = configuration::looks_like_machine_file(document.text);
    return is_machine ? axes.in_machine_file(document) : std::nullopt;
  }
  auto const kind = configuration::decided_kind(SourceText(document.path, document.text));
  return kind == configuration::ListKind::channel ? axes.in_channel(document) : std::nullopt;
}

}  // namespace axisc::editor
