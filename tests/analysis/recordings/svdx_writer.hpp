// Writes a .svdx by the layout that spec and files show, without the reader's code.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace axisc::test {

inline void append_bytes(std::string& to, void const* from, std::size_t size) {
  to.append(static_cast<char const*>(from), size);  // little endian, as every host of the tests
}

template <class Number>
void append(std::string& to, Number value) {
  append_bytes(to, &value, sizeof(value));
}

struct SvdxChannel {
  std::string name = "x", type = "INT32";
  std::uint64_t port = 551, group = 0x121301, offset = 0x10061;
  double factor = 1, add = 0, unit_factor = 1, unit_add = 0;
  std::string unit = "(None)";
  std::vector<double> values = {};
  std::vector<std::uint64_t> times = {};  ///< 100 ns since `zero`; empty: every ms
  std::uint64_t first = 0, last = 0;      ///< of the window; 0: of the samples
};

inline constexpr std::uint64_t svdx_zero = 132959733843760000;

/// Members that tests spoil.
struct SvdxOptions {
  std::string version = "01.00.00.40", compression = "Uncompressed", mark = {};
  bool spoils_extremes = false;
};

inline std::size_t size_of_type(std::string const& type) {
  if (type == "BIT" || type == "INT8" || type == "UINT8") return 1;
  if (type == "INT16" || type == "UINT16") return 2;
  return type == "INT64" || type == "UINT64" || type == "REAL64" ? 8 : 4;
}

inline void append_value(std::string& to, std::string const& type, double value) {
  if (type == "REAL64") return append(to, value);
  if (type == "REAL32") return append(to, static_cast<float>(value));
  auto const whole = static_cast<std::int64_t>(value);
  append_bytes(to, &whole, size_of_type(type));
}

inline std::string svdx_block(SvdxChannel const& channel, SvdxOptions const& options) {
  struct Entry {
    std::uint64_t time;
    double first, second;
  };
  auto const count = channel.values.size();
  auto const time = [&](std::size_t i) {
    return svdx_zero + (channel.times.empty() ? 10'000 * i : channel.times[i]);
  };
  // The extremes of each sixteen, in the order of time.
  std::vector<std::vector<Entry>> levels(1);
  for (std::size_t i = 0; i < count; i += 16) {
    std::size_t low = i, high = i;
    for (std::size_t k = i; k < std::min(count, i + 16); ++k) {
      if (channel.values[k] < channel.values[low]) low = k;
      if (channel.values[k] > channel.values[high]) high = k;
    }
    levels[0].push_back({time(i), channel.values[std::min(low, high)], channel.values[std::max(low, high)]});
  }
  while (levels.back().size() >= 16) {
    auto const& below = levels.back();
    std::vector<Entry> level;
    for (std::size_t i = 0; i + 16 <= below.size(); i += 16) {
      std::vector<double> values;
      for (std::size_t k = i; k < i + 16; ++k) {
        values.push_back(below[k].first);
        values.push_back(below[k].second);
      }
      auto const low = std::min_element(values.begin(), values.end());
      auto const high = std::max_element(values.begin(), values.end());
      level.push_back({below[i].time, *std::min(low, high), *std::max(low, high)});
    }
    levels.push_back(std::move(level));
  }
  if (options.spoils_extremes) levels[0].front().second += 1;
  auto const size = size_of_type(channel.type);
  std::string block = options.version;
  append(block, time(0));
  append(block, std::uint64_t{7});
  append(block, channel.first != 0 ? svdx_zero + channel.first : time(0));
  append(block, channel.last != 0 ? svdx_zero + channel.last : time(count - 1));
  append(block, std::uint64_t{levels.size() + 1});
  append(block, std::uint64_t{16});
  append(block, std::uint64_t{time(1) - time(0)});
  std::size_t at = block.size() + 56 * (levels.size() + 1);
  for (std::size_t level = levels.size() + 1; level-- > 0;) {
    auto const entries = level > 0 ? levels[level - 1].size() : levels[0].size();
    append(block, std::uint64_t{entries});
    append(block, std::uint64_t{entries});
    append(block, static_cast<std::uint32_t>(level));
    append(block, static_cast<std::uint32_t>(at));
    block.append(32, '\0');
    if (level > 0) at += entries * (8 + 2 * size);
  }
  for (std::size_t level = levels.size(); level-- > 0;) {
    for (auto const& entry : levels[level]) {
      append(block, entry.time);
      append_value(block, channel.type, entry.first);
      append_value(block, channel.type, entry.second);
    }
  }
  for (std::size_t i = 0; i < count; i += 16) {
    auto const end = std::min(count, i + 16);
    append(block, time(i));
    append(block, static_cast<std::uint32_t>(end - i));
    for (std::size_t k = i; k < end; ++k) {
      append(block, static_cast<std::uint32_t>(time(k) - time(i)));
      append_value(block, channel.type, channel.values[k]);
    }
  }
  return block;
}

inline std::string svdx_file(std::vector<SvdxChannel> const& channels, SvdxOptions const& options = {}) {
  std::string pool, chart, blocks;
  std::vector<std::size_t> sizes;
  auto const text = [](double value) { return std::to_string(value); };
  for (std::size_t i = 0; i < channels.size(); ++i) {
    auto const& channel = channels[i];
    auto const guid = "guid-" + std::to_string(i);
    pool += "<AdsAcquisition><CompressionMode>" + options.compression + "</CompressionMode><DataType>" +
            channel.type + "</DataType><FileHandle>" + std::to_string(i + 1) + "</FileHandle><Guid>" + guid +
            "</Guid><IndexGroup>" + std::to_string(channel.group) + "</IndexGroup><IndexOffset>" +
            std::to_string(channel.offset) + "</IndexOffset><SymbolName></SymbolName><TargetPort>" +
            std::to_string(channel.port) + "</TargetPort><VariableSize>" +
            std::to_string(size_of_type(channel.type)) + "</VariableSize></AdsAcquisition>\r\n";
    chart += "<Channel><Name>" + channel.name +
             "</Name><SubMember><AcquisitionInterpreter><AcquisitionGUID>" + guid +
             "</AcquisitionGUID><BitMask>18446744073709551615</BitMask><Offset>" + text(channel.add) +
             "</Offset><ResultingUnit><Unit><ReturnText> " + channel.unit +
             " </ReturnText></Unit><UnitOffsetResult>" + text(channel.unit_add) +
             "</UnitOffsetResult><UnitScaleResult>" + text(channel.unit_factor) +
             "</UnitScaleResult></ResultingUnit><ScaleFactor>" + text(channel.factor) +
             "</ScaleFactor></AcquisitionInterpreter></SubMember></Channel>\r\n";
    if (channel.values.empty()) continue;
    auto const block = svdx_block(channel, options);
    blocks += block;
    sizes.push_back(block.size());
  }
  std::string const xml = options.mark +
                          "<?xml version=\"1.0\" encoding=\"utf-8\"?>\r\n<ScopeProject><SubMember><YTChart>" +
                          chart + "</YTChart><DataPool>" + pool + "</DataPool></SubMember></ScopeProject>";
  std::string file;
  std::size_t at = 20 + 20 * sizes.size();
  append(file, std::uint64_t{at + blocks.size()});
  append(file, std::uint64_t{xml.size()});
  append(file, static_cast<std::uint32_t>(sizes.size()));
  std::size_t next = 0;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (channels[i].values.empty()) continue;
    append(file, std::uint64_t{at});
    append(file, std::uint64_t{sizes[next]});
    append(file, static_cast<std::uint32_t>(i + 1));
    at += sizes[next++];
  }
  return file + blocks + xml;
}

}  // namespace axisc::test
