#include "configuration/project_file.hpp"

#include "configuration/machine_file.hpp"
#include "configuration/sentences.hpp"
#include "configuration/xml/xml_document.hpp"
#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <variant>

namespace axisc::configuration::says {

constexpr Sentence project_no_list{
    "the project holds no list of a CNC axis or channel (AchsMds, SdaMds); name the project of a CNC",
    "das Projekt enthält keine Liste einer CNC-Achse oder eines Kanals (AchsMds, SdaMds); das Projekt einer "
    "CNC angeben"};
constexpr Sentence project_no_section{
    "the list in {element} is not a CDATA section, so it is not read; export the project again",
    "die Liste in {element} ist kein CDATA-Abschnitt und wird nicht gelesen; das Projekt neu exportieren"};
constexpr Sentence project_sections{
    "the list in {element} is split into several CDATA sections and is not read; put it into one",
    "die Liste in {element} ist auf mehrere CDATA-Abschnitte verteilt und wird nicht gelesen; sie in einen "
    "fassen"};
constexpr Sentence project_long{"{element} has more than {most} bytes and is not read; shorten it",
                                "{element} hat mehr als {most} Bytes und wird nicht gelesen; kürzen"};
constexpr Sentence project_cycle_time{
    "CycleTime of the NC must be 200 to 1000000 (20 µs to 100 ms in units of 100 ns), not {value}",
    "CycleTime der NC muss 200 bis 1000000 betragen (20 µs bis 100 ms in Einheiten von 100 ns), nicht "
    "{value}"};
constexpr Sentence project_no_cycle_time{
    "the task {task} states no {element}, the cycle time of the NC; add it in units of 100 ns, as in "
    "{element}=\"10000\" for 1 ms",
    "der Task {task} nennt kein {element}, die Zykluszeit der NC; es in Einheiten von 100 ns ergänzen, etwa "
    "{element}=\"10000\" für 1 ms"};
constexpr Sentence project_beside{
    "this is next to the CDATA section of {element} and not read; put the list into the section and remove "
    "the rest",
    "das steht neben dem CDATA-Abschnitt von {element} und wird nicht gelesen; die Liste in den Abschnitt "
    "schreiben und den Rest entfernen"};

}  // namespace axisc::configuration::says

namespace axisc::configuration {
namespace {

struct ListElement {
  std::string_view name;
  ListKind kind;
};
constexpr std::array list_elements = {ListElement{.name = "AchsMds", .kind = ListKind::axis},
                                      ListElement{.name = "SdaMds", .kind = ListKind::channel},
                                      ListElement{.name = "NullpD", .kind = ListKind::zero_offset},
                                      ListElement{.name = "WerkzD", .kind = ListKind::tool},
                                      ListElement{.name = "PzvD", .kind = ListKind::clamp_offset},
                                      ListElement{.name = "VeD", .kind = ListKind::external_variables}};

/// Only these make a machine.
bool is_of_machine(ListKind kind) {
  return kind == ListKind::axis || kind == ListKind::channel;
}
bool is_for_machine(std::string_view element) {
  return std::any_of(list_elements.begin(), list_elements.end(), [element](ListElement const& each) {
    return is_of_machine(each.kind) && each.name == element;
  });
}
constexpr std::uint64_t nanoseconds_per_unit = 100;
constexpr std::string_view part_of_interpolator_name = "GEO";
constexpr std::string_view cycle_time_name = "CycleTime";
constexpr std::uint32_t longest_text = 1000;  // of a name or a number, in bytes

class ProjectReader {
 public:
  ProjectReader(SourceText const& text, SourceId source, std::deque<Finding>& findings)
      : text_(text), source_(source), findings_(findings) {}

  Project read() && {
    auto parsed = parse_xml(text_.bytes());
    if (auto const* const mistake = std::get_if<XmlMistake>(&parsed)) {
      refuse(mistake->span, mistake->message);
      return {};
    }
    document_ = std::get<XmlDocument>(std::move(parsed));
    gather_fields();
    project_.encoding = xml_encoding(text_.bytes());
    for (std::size_t i = 0; i < document_.elements.size(); ++i) {
      for (ListElement const& each : list_elements) {
        if (document_.elements[i].name == each.name) read_list(i, each.kind);
        refuse_spelling(document_.elements[i], each);
      }
      if (document_.elements[i].name == "Task") read_task(i);
    }
    bool const has_machine = std::any_of(project_.lists.begin(), project_.lists.end(),
                                         [](ProjectList const& list) { return is_of_machine(list.kind); });
    if (has_machine) {
      decide_cycle_time();
    } else if (findings_.empty()) {
      project_.is_of_cnc =
          std::any_of(document_.elements.begin(), document_.elements.end(),
                      [](XmlElement const& element) { return is_for_machine(element.name); });
      refuse({.begin = text_.text_begin(), .end = text_.text_begin()}, {says::project_no_list});
    }
    return std::move(project_);
  }

 private:
  struct Field {
    std::size_t element;  ///< to which it belongs
    std::string_view name;
    Span value;  ///< not empty

    [[nodiscard]] std::pair<std::size_t, std::string_view> key() const { return {element, name}; }
  };

  struct Task {
    Span element;
    std::string name;  ///< of the task that interpolates; empty for others
    std::optional<LocatedText> written;
    std::string_view misspelled;             ///< CycleTime in another letter case, or with a prefix
    bool is_refused = false;                 ///< already
    std::optional<design::CycleTime> cycle;  ///< none where no control runs with what is written

    [[nodiscard]] bool interpolates() const { return !name.empty(); }
  };

  void refuse(Span span, Message message) {
    Finding& finding = findings_.emplace_back();
    finding.code = machine_file_code;
    finding.place = Place{.source = source_, .span = span};
    finding.message = std::move(message);
  }

  /// Attributes, and elements that hold nothing but text.
  void gather_fields() {
    for (XmlAttribute const& attribute : document_.attributes) {
      add_field({.element = attribute.element, .name = attribute.name, .value = attribute.value});
    }
    for (XmlElement const& element : document_.elements) {
      std::optional<Span> value = element.text;
      if (!value && element.cdata_sections.size() == 1) value = element.cdata_sections.front();
      if (value) add_field({.element = element.parent, .name = element.name, .value = *value});
    }
    std::stable_sort(fields_.begin(), fields_.end(),
                     [](Field const& a, Field const& b) { return a.key() < b.key(); });
  }

  void add_field(Field const& each) {
    if (!each.value.empty()) fields_.push_back(each);
  }

  [[nodiscard]] std::optional<LocatedText> field(std::size_t element, std::string_view name) {
    auto const wanted = std::pair(element, name);
    auto const at = std::lower_bound(fields_.begin(), fields_.end(), wanted,
                                     [](Field const& each, auto const& key) { return each.key() < key; });
    if (at == fields_.end() || at->key() != wanted) return std::nullopt;
    // Each list next to a name gets a copy.
    if (at->value.size() > longest_text) {
      if (too_long_.insert(at->value.begin).second) {
        refuse(
            {.begin = at->value.begin, .end = at->value.begin},
            {says::project_long, {{"element", std::string(name)}, {"most", std::to_string(longest_text)}}});
      }
      return std::nullopt;
    }
    return LocatedText{.text = text_.utf8(at->value), .place = {.source = source_, .span = at->value}};
  }

  /// Next to the list, or to the element that holds it.
  [[nodiscard]] std::optional<LocatedText> beside(std::size_t element, std::string_view name) {
    std::size_t const parent = document_.elements[element].parent;
    auto found = field(parent, name);
    return found ? found : field(document_.elements[parent].parent, name);
  }

  [[nodiscard]] std::optional<ListCount> count_beside(std::size_t element, std::string_view name) {
    auto const text = beside(element, name);
    auto const number = text ? as_number(*text) : std::nullopt;
    if (!number) return std::nullopt;
    return ListCount{.number = *number, .place = text->place};
  }

  void read_list(std::size_t index, ListKind kind) {
    XmlElement const& element = document_.elements[index];
    if (element.cdata_sections.size() != 1) {
      if (!is_of_machine(kind) || (!element.text && element.cdata_sections.empty())) return;
      bool const is_split = !element.cdata_sections.empty();
      refuse(element.name_span, {is_split ? says::project_sections : says::project_no_section,
                                 {{"element", std::string(element.name)}}});
      return;
    }
    refuse_beside(index);
    LocatedText const own{.text = std::string(element.name),
                          .place = {.source = source_, .span = element.name_span}};
    project_.lists.push_back({.kind = kind,
                              .span = element.cdata_sections.front(),
                              .name = beside(index, "ItemName").value_or(own),
                              .program_name = beside(index, "DefaultProgName"),
                              .default_channel = count_beside(index, "DefaultChannel"),
                              .default_index = count_beside(index, "DefaultIndex")});
  }

  /// The list is read nevertheless, for its own mistakes.
  void refuse_beside(std::size_t index) {
    XmlElement const& element = document_.elements[index];
    if (!is_for_machine(element.name)) return;
    bool const has_child =
        index + 1 < document_.elements.size() && document_.elements[index + 1].parent == index;
    if (!element.text && !has_child) return;
    refuse(element.text ? *element.text : document_.elements[index + 1].name_span,
           {says::project_beside, {{"element", std::string(element.name)}}});
  }

  /// An element of another letter case, or with a prefix, which holds something.
  void refuse_spelling(XmlElement const& element, ListElement const& meant) {
    bool const is_meant = is_of_machine(meant.kind) && element.name != meant.name &&
                          ascii::equal_ignoring_case(local_name(element.name), meant.name);
    if (!is_meant || (!element.text && element.cdata_sections.empty())) return;
    refuse(element.name_span, {says::xml_spelling,
                               {{"written", std::string(element.name)}, {"meant", std::string(meant.name)}}});
  }

  /// Empty where there is none.
  [[nodiscard]] std::string_view misspelled_field(std::size_t element, std::string_view meant) const {
    auto const first =
        std::lower_bound(fields_.begin(), fields_.end(), element,
                         [](Field const& each, std::size_t wanted) { return each.element < wanted; });
    auto const at = std::find_if(first, fields_.end(), [&](Field const& each) {
      return each.element != element || ascii::equal_ignoring_case(local_name(each.name), meant);
    });
    return at != fields_.end() && at->element == element ? at->name : std::string_view();
  }

  void read_task(std::size_t index) {
    Task task;
    task.element = document_.elements[index].name_span;
    auto const refused = findings_.size();
    task.written = field(index, cycle_time_name);
    task.is_refused = findings_.size() != refused;
    if (!task.written && !task.is_refused) task.misspelled = misspelled_field(index, cycle_time_name);
    auto const number = task.written ? as_number(*task.written) : std::nullopt;
    if (number) task.cycle = possible_cycle_time(*number * nanoseconds_per_unit);
    for (std::string_view const key : {"Name", "ItemName"}) {
      auto const name = field(index, key);
      bool const interpolates =
          name && ascii::upper_case(name->text).find(part_of_interpolator_name) != std::string::npos;
      if (interpolates) task.name = name->text;
    }
    bool const matters = task.written || !task.misspelled.empty() || task.interpolates();
    if (matters) tasks_.push_back(std::move(task));
  }

  void refuse_unstated(Task const& task) {
    if (task.is_refused) return;
    if (task.misspelled.empty()) {
      refuse(task.element,
             {says::project_no_cycle_time, {{"task", task.name}, {"element", std::string(cycle_time_name)}}});
      return;
    }
    auto const begin = static_cast<std::uint32_t>(task.misspelled.data() - text_.bytes().data());
    refuse({.begin = begin, .end = begin + static_cast<std::uint32_t>(task.misspelled.size())},
           {says::xml_spelling,
            {{"written", std::string(task.misspelled)}, {"meant", std::string(cycle_time_name)}}});
  }

  /// The cycle time of the task whose name fits; otherwise that of all tasks, where they agree.
  void decide_cycle_time() {
    auto const interpolates = [](Task const& task) { return task.interpolates(); };
    auto const is_stated = [](Task const& task) { return task.written.has_value(); };
    auto const is_possible = [](Task const& task) { return task.cycle.has_value(); };
    bool const is_named = std::any_of(tasks_.begin(), tasks_.end(), interpolates);
    if (is_named) std::erase_if(tasks_, std::not_fn(interpolates));
    if (!std::all_of(tasks_.begin(), tasks_.end(), is_stated)) {
      for (Task const& task : tasks_) {
        if (!task.written) refuse_unstated(task);
      }
      return;
    }
    if (!is_named && std::any_of(tasks_.begin(), tasks_.end(), is_possible)) {
      // A slow task of the PLC is not the one that interpolates.
      std::erase_if(tasks_, std::not_fn(is_possible));
    }
    bool const agree = std::all_of(tasks_.begin(), tasks_.end(),
                                   [this](Task const& task) { return task.cycle == tasks_.front().cycle; });
    if (tasks_.empty() || !agree) return;
    Task const& task = tasks_.front();
    if (task.cycle) {
      project_.real_time = {.cycle_time = task.cycle, .place = task.written->place};
    } else {
      refuse(task.written->place.span, {says::project_cycle_time, {{"value", task.written->text}}});
    }
  }

  SourceText const& text_;
  SourceId source_;
  std::deque<Finding>& findings_;
  XmlDocument document_;
  std::vector<Field> fields_;         ///< by key(), of equal ones in the order of the file
  std::set<std::uint32_t> too_long_;  ///< where texts begin that were refused
  std::vector<Task> tasks_;
  Project project_;
};

}  // namespace

Project read_project(SourceSet const& sources, SourceId source, std::deque<Finding>& findings) {
  return ProjectReader(sources[source], source, findings).read();
}

bool is_project_name(std::string_view path) {
  return ascii::has_extension(path, ".tsproj") || ascii::has_extension(path, ".xti");
}

}  // namespace axisc::configuration
