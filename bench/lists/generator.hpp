// Lists of a fleet, made up: distinct, without findings, the same ones in every run.
//
// The mix is that of lists found on machines: about 800 parameters in 1,000 lines, nearly half of them plain
// integers, a quarter reals, the rest hexadecimal, boolean, words and texts; a comment behind every third,
// comment and blank lines in between, every second list with CR LF.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace axisc::bench {

/// What another format needs to know to write the value.
enum class EntryKind : std::uint8_t { integer, real, boolean, text };

struct Entry {
  std::string name;   ///< `filter[0].order`
  std::string value;  ///< as the list writes it: 20, 0x1F, TRUE, LOWPASS
  EntryKind kind{};
};

struct GeneratedList {
  std::vector<Entry> entries;
  std::string text;
};

/// Lists `0` to `count - 1`; a longer fleet begins with the shorter one.
[[nodiscard]] std::vector<GeneratedList> generate_lists(std::size_t count);
[[nodiscard]] GeneratedList generate_list(std::size_t number);

/// The same values elsewhere: one flat object with dotted keys; sections of one level, keys with dots; nested
/// nodes.
[[nodiscard]] std::string as_json(GeneratedList const& list);
[[nodiscard]] std::string as_ini(GeneratedList const& list);
[[nodiscard]] std::string as_device_tree(GeneratedList const& list);

/// The list with a mistake in every line: an unknown name, a value out of range, a wrong type, no value, in
/// turn.
[[nodiscard]] std::string with_mistakes(GeneratedList const& list);

}  // namespace axisc::bench
