#include "configuration/start_up_list.hpp"

#include "configuration/listed_values.hpp"
#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace axisc::configuration {
namespace {

struct EntryArray {
  std::string_view pattern;
  std::vector<ListEntry> StartUpList::*entries;
};
constexpr std::array entry_arrays = {EntryArray{"achs_mds[]", &StartUpList::axes},
                                     EntryArray{"sda_mds[]", &StartUpList::channels}};

struct Count {
  std::string_view name;
  std::optional<ListCount> StartUpList::*count;
};
constexpr std::array counts = {Count{"zahl_mds", &StartUpList::axis_count},
                               Count{"kanal_anzahl", &StartUpList::channel_count},
                               Count{"zahl_kw", &StartUpList::compensation_count}};

struct Single {
  std::string_view name;
  std::optional<LocatedText> StartUpList::*text;
};
constexpr std::array singles = {Single{"default_achs_mds", &StartUpList::default_axis_list},
                                Single{"default_sda_mds", &StartUpList::default_channel},
                                Single{"rtconf_lis", &StartUpList::real_time},
                                Single{"scheduling_position_controller", &StartUpList::position_control}};

struct OtherName {
  std::string_view pattern;
  std::optional<ListKind> kind;
};
constexpr std::array other_names = {
    OtherName{"werkz_data[]", ListKind::tool},       OtherName{"nullp_data[]", ListKind::zero_offset},
    OtherName{"pzv_data[]", ListKind::clamp_offset}, OtherName{"ve_var[]", ListKind::external_variables},
    OtherName{"hand_mds", ListKind::manual},         OtherName{"hw_configuration_list", ListKind::hardware},
    OtherName{"scene_mds[]", std::nullopt},          OtherName{"techno_mds", std::nullopt}};

/// The entry of that index, which is new where there was none.
template <typename Entry, typename IndexOf>
Entry& entry_at(std::vector<Entry>& entries, std::uint32_t index, IndexOf index_of) {
  auto const at =
      std::lower_bound(entries.begin(), entries.end(), index,
                       [&](Entry& each, std::uint32_t wanted) { return index_of(each) < wanted; });
  if (at != entries.end() && index_of(*at) == index) return *at;
  auto const added = entries.insert(at, Entry{});
  index_of(*added) = index;
  return *added;
}

std::uint32_t& index_of_list(ListEntry& entry) {
  return entry.index;
}
std::uint32_t& index_of_compensation(CompensationEntry& entry) {
  return entry.list.index;
}

void read_line(ListedValue& listed, StartUpList& list) {
  for (EntryArray const& array : entry_arrays) {
    if (auto const indices = match_name(listed.name, array.pattern)) {
      entry_at(list.*array.entries, (*indices)[0], index_of_list).file = std::move(listed.value);
      return;
    }
  }
  for (Count const& count : counts) {
    if (match_name(listed.name, count.name)) list.*count.count = as_count(listed);
  }
  for (Single const& single : singles) {
    if (match_name(listed.name, single.name) && !listed.value.text.empty()) list.*single.text = listed.value;
  }
  if (auto const indices = match_name(listed.name, "achs_kw[]")) {
    entry_at(list.compensations, (*indices)[0], index_of_compensation).list.file = listed.value;
  }
  if (auto const indices = match_name(listed.name, "achs_kw_log_ax_nr[]")) {
    entry_at(list.compensations, (*indices)[0], index_of_compensation).axis = as_count(listed);
  }
  for (OtherName const& other : other_names) {
    bool const is_it = match_name(listed.name, other.pattern).has_value();
    if (is_it && !listed.value.text.empty()) {
      list.others.push_back({.file = listed.value, .kind = other.kind});
    }
  }
}

constexpr std::array<std::string_view, 6> own_names = {"achs_mds[",  "sda_mds[",         "zahl_mds",
                                                       "rtconf_lis", "default_achs_mds", "kanal_anzahl"};

bool is_initial(char byte) {
  return std::any_of(own_names.begin(), own_names.end(),
                     [byte](std::string_view name) { return name.front() == byte; });
}

bool begins_with_own_name(std::string_view line) {
  while (!line.empty() && ascii::is_blank(line.front())) line.remove_prefix(1);
  // As in most lines.
  if (line.empty() || !is_initial(line.front())) return false;
  return std::any_of(own_names.begin(), own_names.end(),
                     [line](std::string_view name) { return line.substr(0, name.size()) == name; });
}

}  // namespace

bool is_read(ListEntry const& entry, std::optional<ListCount> const& count) {
  return entry.index < (count ? count->number : 0);
}

StartUpList read_start_up_list(SourceText const& text, SourceId source) {
  StartUpList list;
  for (ListedValue& listed : listed_values(text, source)) read_line(listed, list);
  std::erase_if(list.compensations,
                [](CompensationEntry const& entry) { return entry.list.file.text.empty(); });
  return list;
}

std::vector<LocatedText const*> named_lists(StartUpList const& list) {
  std::vector<LocatedText const*> named;
  for (ListEntry const& entry : list.axes) named.push_back(&entry.file);
  for (ListEntry const& entry : list.channels) named.push_back(&entry.file);
  for (CompensationEntry const& entry : list.compensations) named.push_back(&entry.list.file);
  for (auto const* const single : {&list.default_axis_list, &list.default_channel, &list.real_time}) {
    if (*single) named.push_back(&**single);
  }
  for (OtherList const& other : list.others) named.push_back(&other.file);
  return named;
}

bool looks_like_start_up_list(std::string_view bytes) {
  // A carriage return alone ends a line too; each is looked for once, since most lists have either none or
  // one a line.
  auto feed = bytes.find('\n');
  auto carriage_return = bytes.find('\r');
  for (std::size_t begin = 0; begin < bytes.size();) {
    if (begins_with_own_name(bytes.substr(begin))) return true;
    if (feed < begin) feed = bytes.find('\n', begin);
    if (carriage_return < begin) carriage_return = bytes.find('\r', begin);
    auto const end = std::min(feed, carriage_return);
    if (end == std::string_view::npos) return false;
    begin = end + 1;
  }
  return false;
}

}  // namespace axisc::configuration
