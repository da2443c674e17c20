#include "analysis/recordings/template/scope_template.hpp"

#include "diagnostics/fnv.hpp"

#include <array>
#include <cmath>
#include <pugixml.hpp>
#include <sstream>
#include <string_view>

namespace axisc::recordings {

namespace {

constexpr double ticks_per_ms = 1e4;
constexpr double ms_per_second = 1000;
constexpr std::uint64_t all_bits = ~std::uint64_t{0};

/// "9f20f55a-af67-8da8-a203-4d20c23202e8", of version 8: any bits.
std::string guid_of(std::string_view text) {
  constexpr std::array<std::uint64_t, 2> seeds{fnv_basis, 8675309867530919423U};
  std::string digits;
  for (auto const seed : seeds) {
    auto hash = fnv1a(text, seed);
    hash = fnv1a("axisc", hash ^ hash >> 29U);
    for (unsigned shift = 64; shift > 0; shift -= 4) digits += "0123456789abcdef"[hash >> (shift - 4) & 0xFU];
  }
  digits[12] = '8';
  digits[16] = 'a';
  for (std::size_t const dash : {8U, 13U, 18U, 23U}) digits.insert(dash, "-");
  return digits;
}

struct DataTypeRow {
  std::string_view name;
  int size;
};
constexpr std::array<DataTypeRow, 4> data_types{{{"UINT16", 2}, {"INT32", 4}, {"INT64", 8}, {"REAL64", 8}}};

int size_of(std::string_view type) {
  for (auto const& row : data_types) {
    if (row.name == type) return row.size;
  }
  return 0;
}

void set(pugi::xml_node& node, char const* name, std::string const& value) {
  node.append_child(name).text().set(value.c_str());
}

/// An element of the project, with an identifier of its own.
pugi::xml_node element(pugi::xml_node parent, char const* kind, std::string const& name,
                       std::string const& identity) {
  auto node = parent.append_child(kind);
  node.append_attribute("AssemblyName") = "TwinCAT.Measurement.Scope.API.Model";
  set(node, "Guid", guid_of(std::string(kind) + "/" + identity));
  set(node, "Name", name);
  return node;
}

class Writer {
 public:
  explicit Writer(TemplateOptions const& options) : options_(options) {}

  std::string write(std::vector<TemplateAxis> const& axes) {
    auto declaration = document_.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "utf-8";
    auto project = element(document_, "ScopeProject", "axisc", options_.net_id);
    set(project, "Comment", options_.comment);
    set(project, "MainServer", "127.0.0.1.1.1");
    set(project, "RecordTime", whole(options_.seconds * ms_per_second * ticks_per_ms));
    set(project, "StopMode", "ClientStop");
    auto members = project.append_child("SubMember");
    for (auto const& axis : axes) add_chart(members, axis);
    auto pool = element(members, "DataPool", "DataPool", "").append_child("SubMember");
    for (auto const& axis : axes) {
      for (auto const& signal : axis.signals) add_acquisition(pool, axis.name, signal);
    }
    element(members, "TriggerModule", "Trigger", "").append_child("SubMember");
    set(project, "Title", "axisc");
    set(project, "Version", "1.0.0.0");
    return text();
  }

 private:
  static std::string whole(double value) { return std::to_string(std::llround(value)); }

  void add_acquisition(pugi::xml_node pool, std::string const& axis, TemplateSignal const& signal) const {
    auto const& row = row_of(signal.object);
    auto const name = template_name(axis, signal.object);
    auto const type = std::string(row.data_type);
    constexpr std::uint32_t per_axis = 0x10000;
    auto node = element(pool, "AdsAcquisition", name, name);
    set(node, "AmsNetId", options_.net_id);
    set(node, "ArrayLength", "0");
    set(node, "BaseSampleTime", whole(options_.cycle_ms * ticks_per_ms));
    set(node, "CompressionMode", "Uncompressed");
    set(node, "DataType", type);
    set(node, "Enabled", "true");
    set(node, "FileHandle", "0");
    set(node, "ForceOversampling", "false");
    set(node, "IndexGroup", std::to_string(row.group + (row.is_of_channel ? signal.channel : 0)));
    set(node, "IndexOffset", std::to_string(row.offset + per_axis * signal.axis));
    set(node, "Oversample", "0");
    set(node, "SymbolBased", "false");
    set(node, "SymbolName", "");
    set(node, "TargetPort", std::to_string(row.port));
    set(node, "TimeOffset", "0");
    set(node, "UseLocalServer", "true");
    set(node, "UseTaskSampleTime", "true");
    set(node, "VariableSize", std::to_string(size_of(row.data_type)));
  }

  static void add_chart(pugi::xml_node members, TemplateAxis const& axis) {
    auto chart = element(members, "YTChart", axis.name, axis.name);
    set(chart, "AutoStart", "true");
    auto group = element(chart.append_child("SubMember"), "AxisGroup", axis.name, axis.name);
    set(group, "Enabled", "true");
    auto parts = group.append_child("SubMember");
    element(parts, "MarkerContainer", "Marker Container", axis.name).append_child("SubMember");
    set_orientation(element(parts, "TimeAxis", "Time Axis", axis.name), "X");
    set_orientation(element(parts, "ValueAxis", "Value Axis", axis.name), "Y");
    for (auto const& signal : axis.signals) add_channel(parts, axis.name, signal);
  }

  static void set_orientation(pugi::xml_node node, char const* orientation) {
    set(node, "Orientation", orientation);
    node.append_child("SubMember");
  }

  static void add_channel(pugi::xml_node parts, std::string const& axis, TemplateSignal const& signal) {
    auto const name = template_name(axis, signal.object);
    auto channel = element(parts, "Channel", name, name);
    set(channel, "Enabled", "true");
    auto members = channel.append_child("SubMember");
    auto interpreter = element(members, "AcquisitionInterpreter", "Y: " + name, name);
    set(interpreter, "AcquisitionGUID", guid_of("AdsAcquisition/" + name));
    set(interpreter, "BitMask", std::to_string(all_bits));
    set(interpreter, "Offset", "0");
    auto unit = interpreter.append_child("ResultingUnit");
    set(unit, "UnitOffsetResult", "0");
    set(unit, "UnitScaleResult", "1");
    set(interpreter, "ScaleFactor", "1");
    set(interpreter, "Usage", "Y");
    set_visible(element(members, "ChannelStyle", "Channel Style", name));
  }

  static void set_visible(pugi::xml_node style) { set(style, "Visible", "true"); }

  [[nodiscard]] std::string text() const {
    std::ostringstream out;
    document_.save(out, "  ", pugi::format_indent | pugi::format_write_bom, pugi::encoding_utf8);
    std::string lines;
    for (char const byte : out.str()) {
      if (byte == '\n') lines += '\r';
      lines += byte;
    }
    return lines;
  }

  TemplateOptions const& options_;
  pugi::xml_document document_;
};

}  // namespace

std::string scope_template(std::vector<TemplateAxis> const& axes, TemplateOptions const& options) {
  return Writer(options).write(axes);
}

}  // namespace axisc::recordings
