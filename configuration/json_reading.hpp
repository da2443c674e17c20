// Reads a JSON document into objects of the program, by the tables that it was checked against.
#pragma once

#include "configuration/json_shape.hpp"
#include "configuration/located_json.hpp"
#include "configuration/located_text.hpp"
#include "design/units.hpp"
#include "diagnostics/finding.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace axisc::configuration {

class JsonReading {
 public:
  /// `readable` comes from check_json(). Both arguments must outlive this object. `source` is for the places
  /// of located texts.
  JsonReading(JsonDocument const& document, std::vector<bool> const& readable, SourceId source = {})
      : document_(document), readable_(readable), source_(source) {}

  /// Stores the values of `object` in `target`, which is of the type that the keys' stores belong to. Missing
  /// and unreadable values leave their members unchanged.
  void fill(JsonShape const& shape, JsonValue const& object, void* target) const;

  /// Stores one value: a number of microseconds as a cycle time, a list in a vector (without its items that
  /// are not readable), an object by the keys of its shape.
  static void assign(JsonShape const& shape, JsonValue const& value, std::string& target);
  void assign(JsonShape const& shape, JsonValue const& value, LocatedText& target) const;
  static void assign(JsonShape const& shape, JsonValue const& value, bool& target);
  static void assign(JsonShape const& shape, JsonValue const& value, design::CycleTime& target);
  template <typename T>
  void assign(JsonShape const& shape, JsonValue const& value, std::optional<T>& target) const {
    assign(shape, value, target.emplace());
  }
  template <typename T>
  void assign(JsonShape const& shape, JsonValue const& value, std::vector<T>& target) const {
    for (std::size_t const item : value.items) {
      if (readable_[item]) assign(*shape.items, document_[item], target.emplace_back());
    }
  }
  /// The enumerator of the word's number in `shape.words`.
  template <typename T>
  requires std::is_enum_v<T>
  void assign(JsonShape const& shape, JsonValue const& value, T& target) const {
    auto const word = std::find(shape.words.begin(), shape.words.end(), value.string);
    if (word == shape.words.end()) return;  // as of a value that is not readable
    target = static_cast<T>(word - shape.words.begin());
  }
  template <typename T>
  requires std::is_class_v<T>
  void assign(JsonShape const& shape, JsonValue const& value, T& target) const {
    fill(shape, value, &target);
  }

  [[nodiscard]] JsonDocument const& document() const { return document_; }

 private:
  JsonDocument const& document_;
  std::vector<bool> const& readable_;
  SourceId source_;
};

namespace detail {

template <typename Member>
struct OwnerOf;
template <typename Owner, typename Member>
struct OwnerOf<Member Owner::*> {
  using Type = Owner;
};
template <typename Function>
struct TargetOf;
template <typename Target>
struct TargetOf<void (*)(JsonDocument const&, JsonValue const&, Target&)> {
  using Type = Target;
};

}  // namespace detail

/// The store of a member: into<&MachineFile::programs>.
template <auto member>
void into(JsonReading const& reading, JsonShape const& shape, JsonValue const& value, void* target) {
  using Owner = typename detail::OwnerOf<decltype(member)>::Type;
  reading.assign(shape, value, static_cast<Owner*>(target)->*member);
}

/// A store by a custom function of document, value and target.
template <auto function>
void by(JsonReading const& reading, JsonShape const& /*shape*/, JsonValue const& value, void* target) {
  using Target = typename detail::TargetOf<decltype(function)>::Type;
  function(reading.document(), value, *static_cast<Target*>(target));
}

}  // namespace axisc::configuration
