// The catalogues of all parameters: which ones there are, of which type, in which range.
//
// The facts about axis lists are in axis-parameters.json; a generator turns them at build time into constant
// tables with a perfect hash over all concrete names, so that nothing is parsed or allocated when the program
// starts. Schema files of the user add to them or replace them. The facts about the other kinds of lists are
// in other-lists.json; they become tables too, whose names are looked up in a map that is made when the first
// list of that kind is read: class Catalogue.
#pragma once

#include "schema/data_type.hpp"
#include "schema/list_kind.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::schema {

/// A word of an enumeration; some have no documented number.
struct Symbol {
  std::string_view word;
  std::optional<int> number;
};

/// One row of the catalogue: an index into parameters().
enum class ParameterId : std::uint16_t {};
/// One concrete parameter: a row with its indices, `filter[2].order`. Dense from 0 to slot_count() - 1.
enum class Slot : std::uint32_t {};
/// The indices of a concrete parameter, in the order of the brackets; zeros where there are fewer.
using Indices = std::array<std::uint32_t, 3>;
/// Entries per index, 0 for a missing index.
using ArraySizes = std::array<std::uint16_t, 3>;

struct Limit {
  enum class Kind : std::uint8_t { none, number, parameter };
  double number = 0;         ///< for Kind::number; limits of the data type are written out as numbers
  std::uint16_t p_axis = 0;  ///< for Kind::parameter: the number of the limiting parameter
  Kind kind = Kind::none;
  bool open = false;  ///< the limit itself is not allowed
};

/// The fields that judge a value come first, in one cache line.
struct alignas(64) Parameter {
  Limit minimum;
  Limit maximum;
  std::span<Symbol const>
      symbols;  ///< words of an enumeration; for booleans FALSE, TRUE and further words for 0 and 1
  DataType type{};
  bool has_default = false;
  std::uint16_t p_axis = 0;        ///< 140 for P-AXIS-00140; 0 where no number is documented
  std::uint16_t max_length = 0;    ///< of a string, in characters; 0 where none is documented
  bool is_flags = false;           ///< an enumeration of which a value joins several words by `|`
  ListKind kind = ListKind::axis;  ///< of the lists that it is in
  Slot first_slot{};
  std::uint32_t slots = 1;
  ArraySizes array{};
  std::string_view name;          ///< pattern: `filter[].order`
  std::string_view default_text;  ///< as documented: number, word, text (may be empty) or P-AXIS-nnnnn
  std::string_view
      unit_translatory;          ///< unit of the raw number ("0.1 um", "us", "Hz"); empty where it has none
  std::string_view unit_rotary;  ///< the same for rotary axes and spindles
  std::span<Symbol const>
      number_names;             ///< meanings of numbers, for messages ("SERCOS"); a list cannot write these
  std::string_view axis_types;  ///< "TR" where the parameter is not for every type; empty means all
  std::string_view
      former_name;         ///< name without brackets that the vendor once used; empty where there is none
  std::string_view since;  ///< build that introduced it; empty where it is as old as the catalogue
  /// The number in default_text, if it is a decimal number and was read already; otherwise not a number.
  double default_number = std::numeric_limits<double>::quiet_NaN();

  [[nodiscard]] std::size_t index_count() const {
    return array[2] != 0 ? 3U : array[1] != 0 ? 2U : array[0] != 0 ? 1U : 0U;
  }
  [[nodiscard]] constexpr bool is_enumeration() const {
    return !symbols.empty() && type != DataType::boolean;
  }
};

/// Another parameter gives one of the limits.
[[nodiscard]] constexpr bool is_limited_by_another(Parameter const& parameter) {
  return parameter.minimum.kind == Limit::Kind::parameter || parameter.maximum.kind == Limit::Kind::parameter;
}

/// The table of its numbers' meanings replaces a range.
[[nodiscard]] constexpr bool is_listed_only(Parameter const& parameter) {
  return !parameter.number_names.empty() && parameter.minimum.kind == Limit::Kind::none &&
         parameter.maximum.kind == Limit::Kind::none;
}

/// All slots of a row; returns the place after them.
template <typename Output>
constexpr Output write_slots(Parameter const& parameter, Output out) {
  for (std::uint32_t i = 0; i < parameter.slots; ++i) {
    *out++ = static_cast<Slot>(static_cast<std::uint32_t>(parameter.first_slot) + i);
  }
  return out;
}

[[nodiscard]] std::span<Parameter const> parameters();
[[nodiscard]] Parameter const& parameter(ParameterId id);
[[nodiscard]] std::size_t slot_count();

/// `filter[2].order` for one of the parameter's slots; its indices; and the slot of indices that are in
/// range.
[[nodiscard]] std::string slot_name(Parameter const& parameter, Slot slot);
[[nodiscard]] Indices indices_of(Parameter const& parameter, Slot slot);
[[nodiscard]] Slot slot_of(Parameter const& parameter, Indices const& indices);
[[nodiscard]] Slot slot_of(Parameter const& parameter, std::uint32_t first_index = 0,
                           std::uint32_t second_index = 0);

/// The meaning of a name in a list.
struct NameLookup {
  enum class Status : std::uint8_t {
    found,
    unknown,             ///< no such parameter
    index_out_of_range,  ///< at `index_position`; `array_size` is the number of entries
    index_missing,       ///< array parameter without (all of) its indices
    index_superfluous,   ///< index on a scalar
  };
  Status status = Status::unknown;
  bool case_folded = false;  ///< matches only after case folding
  ParameterId parameter{};
  Parameter const* row = nullptr;  ///< of `parameter`; null where it is unknown
  Slot slot{};
  Indices index{};
  std::uint8_t index_position =
      0;  ///< 0 to 2: of the offending index, counted in the row's name (superfluous: in `name`)
  std::uint16_t array_size = 0;  ///< of that index; 0 where it is superfluous
};

/// Cost: one hash and one comparison for a correct name; more only for names that miss. `name` is
/// syntactically right: identifiers joined by dots, each with at most one index.
[[nodiscard]] NameLookup find(std::string_view name);
/// find() without case folding.
[[nodiscard]] NameLookup find_as_written(std::string_view name);

/// All rows with that number (several names may share one); empty when there is none.
[[nodiscard]] std::span<ParameterId const> find_number(std::uint16_t p_axis);

[[nodiscard]] ParameterId parameter_of(Slot slot);
[[nodiscard]] Indices indices_of(Slot slot);
/// `filter[2].order`.
[[nodiscard]] std::string slot_name(Slot slot);
/// Slot of a row with these indices; the indices are in range.
[[nodiscard]] Slot slot_of(ParameterId id, std::uint32_t first_index = 0, std::uint32_t second_index = 0);

/// True for a word of any enumeration (LOWPASS, TRUE).
[[nodiscard]] bool is_symbol_of_any_parameter(std::string_view word);

/// Possible meanings of an unknown name: names in its own family, and names that differ from it by one slip
/// of the pen, one missing part, or two words that are swapped. Indices are kept.
struct NameSuggestions {
  std::vector<std::string> names;  ///< best first, at most three
  bool is_close = false;           ///< the best one differs by one slip
  bool is_certain = false;  ///< the best one is clearly better than all others, and may be written instead
  bool is_former_name = false;  ///< the best one once had this name
};
[[nodiscard]] NameSuggestions suggest_names(std::string_view name);
/// Words of one enumeration that a mistyped one may have meant, best first, at most three.
[[nodiscard]] std::vector<std::string_view> suggest_symbols(Parameter const& parameter,
                                                            std::string_view word);

/// A concrete parameter.
struct ConcreteParameter {
  Parameter const* row = nullptr;
  Slot slot{};

  explicit operator bool() const { return row != nullptr; }
};
/// The row of a name exactly as the catalogue spells it; no row for any other. Cost: one hash and one
/// comparison.
[[nodiscard]] ConcreteParameter find_exact(std::string_view name);

struct PlainValues;
/// A concrete parameter and those of its values that are beyond doubt; null for a name that does not belong
/// to a parameter.
struct PlainParameter {
  PlainValues const* values = nullptr;
  Slot slot{};
};
/// find_exact() for up to names_at_once names, in less time than one after the other; `found` has room for as
/// many. The names may have any form.
inline constexpr std::size_t names_at_once = 32;
void find_plain(std::span<std::string_view const> names, std::span<PlainParameter> found);

/// Parameters of which another one gives a limit.
[[nodiscard]] std::span<Slot const> slots_limited_by_others();

class OwnTables;
struct ParameterRow;

/// The catalogue that a check works with: the built-in one of axis parameters, which the functions above look
/// into, that with the rows of schema files, or that of another kind of list. Copies share one; rows live as
/// long as any of them.
class Catalogue {
 public:
  /// The built-in catalogue. Cost: none.
  Catalogue() = default;
  /// The catalogue of a kind of list. Cost: none; its first look-up takes the names apart, once in a process.
  [[nodiscard]] static Catalogue of(ListKind kind);
  /// This catalogue with `rows`, each of which replaces the row of its name. Their array sizes sum up to less
  /// than most_slots; limits and defaults name existing numbers. This catalogue is of axis parameters.
  [[nodiscard]] Catalogue with(std::vector<ParameterRow> rows) const;

  [[nodiscard]] std::span<Parameter const> parameters() const;
  [[nodiscard]] Parameter const& parameter(ParameterId id) const {
    return parameters()[static_cast<std::size_t>(id)];
  }
  [[nodiscard]] Parameter const& parameter_of(Slot slot) const;
  [[nodiscard]] std::size_t slot_count() const;
  /// Cost: as of the function; with schema files that of an ordered map in addition.
  [[nodiscard]] NameLookup find(std::string_view name) const;
  /// With schema files, also finds names with their indices in other places, at the cost of find(). `name` is
  /// syntactically right.
  [[nodiscard]] ConcreteParameter find_exact(std::string_view name) const;
  /// Up to names_at_once names of any form; finds only those whose indices are written as in the catalogue.
  void find_plain(std::span<std::string_view const> names, std::span<PlainParameter> found) const;
  [[nodiscard]] std::span<ParameterId const> find_number(std::uint16_t p_axis) const;
  [[nodiscard]] std::span<Slot const> slots_limited_by_others() const;
  [[nodiscard]] bool is_symbol_of_any_parameter(std::string_view word) const;
  [[nodiscard]] NameSuggestions suggest_names(std::string_view name) const;

  [[nodiscard]] ListKind kind() const;
  /// The catalogue of axis parameters without schema files.
  [[nodiscard]] bool is_built_in() const { return own_ == nullptr; }
  /// The schema file that a row comes from; empty where it was built in.
  [[nodiscard]] std::string_view file_of(Parameter const& parameter) const;

 private:
  std::shared_ptr<OwnTables const> own_;  ///< none: built in
};

/// The most slots of axis parameters: 16 bits count them.
inline constexpr std::size_t most_slots = 65535;

}  // namespace axisc::schema
