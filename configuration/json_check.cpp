#include "configuration/json_check.hpp"

#include "configuration/sentences.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/joined.hpp"
#include "schema/closest_word.hpp"
#include "schema/value.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace axisc::configuration::says {

constexpr Sentence unknown_key{"unknown key \"{key}\"", "unbekannter Schlüssel \"{key}\""};
constexpr Sentence repeated_key{"the key \"{key}\" occurs here twice",
                                "der Schlüssel \"{key}\" steht hier zweimal"};
constexpr Sentence text{"\"{key}\" must be a text", "\"{key}\" muss ein Text sein"};
constexpr Sentence empty_text{"\"{key}\" must not be empty", "\"{key}\" darf nicht leer sein"};
constexpr Sentence number{"\"{key}\" must be a number", "\"{key}\" muss eine Zahl sein"};
constexpr Sentence flag{"\"{key}\" must be true or false", "\"{key}\" muss true oder false sein"};
constexpr Sentence list{"\"{key}\" must be a list in brackets",
                        "\"{key}\" muss eine Liste in eckigen Klammern sein"};
constexpr Sentence list_of_texts{"\"{key}\" must be a list of texts",
                                 "\"{key}\" muss eine Liste von Texten sein"};
constexpr Sentence list_of_objects{"\"{key}\" must be a list of objects in braces",
                                   "\"{key}\" muss eine Liste von Objekten in geschweiften Klammern sein"};
constexpr Sentence too_many{"\"{key}\" may have at most {limit} entries",
                            "\"{key}\" darf höchstens {limit} Einträge haben"};
constexpr Sentence object{"an object in braces is expected here",
                          "hier wird ein Objekt in geschweiften Klammern erwartet"};
constexpr Sentence one_of{"\"{key}\" must be one of {values}", "\"{key}\" muss eines von {values} sein"};
constexpr Sentence range{"\"{key}\" must be a number {range}", "\"{key}\" muss eine Zahl {range} sein"};
constexpr Sentence whole{"\"{key}\" must be a whole number {range}",
                         "\"{key}\" muss eine ganze Zahl {range} sein"};
constexpr Sentence excludes{R"("{key}" and "{other}" exclude each other; leave one out)",
                            R"("{key}" und "{other}" schließen einander aus; eines weglassen)"};

}  // namespace axisc::configuration::says

namespace axisc::configuration {
namespace {

using Kind = JsonShapeKind;
using Words = std::vector<std::string_view>;

Wording range_text(JsonShape const& shape) {
  if (shape.lowest == shape.highest) return "= " + exact_number(shape.lowest);
  Wording text;
  if (std::isfinite(shape.lowest)) text = (shape.above_lowest ? "> " : "≥ ") + exact_number(shape.lowest);
  if (std::isfinite(shape.highest)) text += (text.empty() ? "≤ " : ", ≤ ") + exact_number(shape.highest);
  return text;
}

bool is_in_range(JsonShape const& shape, double number) {
  bool const whole = shape.kind != Kind::whole_number || number == std::floor(number);
  bool const above = shape.above_lowest ? number > shape.lowest : number >= shape.lowest;
  return whole && above && number <= shape.highest;
}

bool is_of_kind(JsonShape const& shape, JsonValue const& value) {
  switch (shape.kind) {
    case Kind::null: return value.kind == JsonKind::null;
    case Kind::flag: return value.kind == JsonKind::boolean;
    case Kind::number:
    case Kind::whole_number: return value.kind == JsonKind::number;
    case Kind::text: return value.kind == JsonKind::string;
    case Kind::list: return value.kind == JsonKind::array;
    case Kind::object:
    case Kind::map: return value.kind == JsonKind::object;
    case Kind::anything:
    case Kind::either: break;
  }
  return true;
}

SentenceRef list_sentence(JsonShape const& items) {
  if (items.kind == Kind::text) return says::list_of_texts;
  return items.kind == Kind::object ? says::list_of_objects : says::list;
}

SentenceRef number_sentence(JsonShape const& shape) {
  if (shape.kind == Kind::whole_number) return says::whole;
  return range_text(shape).empty() || shape.sentence ? says::number : says::range;
}

/// The number that a text was meant to be, `1000` or, where the key is in µs, `1ms`; empty for other texts.
std::string number_meant(JsonShape const& shape, std::string_view key, std::string_view text) {
  struct Unit {
    std::string_view word;
    double microseconds;
  };
  constexpr std::array units{Unit{"us", 1}, Unit{"µs", 1}, Unit{"ms", 1e3}, Unit{"s", 1e6}};
  std::size_t size = text.size();
  while (size > 0 && !schema::is_complete_number(text.substr(0, size))) --size;
  if (size == 0) return {};
  double factor = 1;
  if (std::string_view const word = ascii::trimmed(text.substr(size)); !word.empty()) {
    auto const* const unit =
        std::find_if(units.begin(), units.end(), [word](Unit const& each) { return each.word == word; });
    if (unit == units.end() || !key.ends_with("_us")) return {};
    factor = unit->microseconds;
  }
  double const number = schema::read_real(text.substr(0, size)).number * factor;
  return is_in_range(shape, number) ? format_exact(number) : std::string();
}

class Checker {
 public:
  explicit Checker(JsonDocument const& document) : document_(document) {
    check_.readable.resize(document.values.size());
  }

  JsonCheck check(JsonShape const& shape) && {
    check_value(shape, 0, {});
    return std::move(check_);
  }

 private:
  JsonProblem& add(Span span, SentenceRef text, std::vector<Argument> arguments = {}) {
    return check_.problems.emplace_back(JsonProblem{span, {text, std::move(arguments)}, {}, {}, {}, {}});
  }

  /// The shape's own sentence, otherwise the general one.
  JsonProblem& refuse(JsonShape const& shape, Span span, std::string_view key, Wording value,
                      SentenceRef general) {
    std::vector<Argument> arguments{{"key", std::string(key)}, {"value", std::move(value)}};
    if (!shape.sentence) arguments.push_back({"range", range_text(shape)});
    return add(span, shape.sentence.value_or(general), std::move(arguments));
  }

  void refuse_kind(JsonShape const& shape, JsonValue const& value, std::string_view key) {
    Argument const name{"key", std::string(key)};
    Span const span = value.span;
    switch (shape.kind) {
      case Kind::flag: add(span, says::flag, {name}); break;
      case Kind::number:
      case Kind::whole_number: {
        JsonProblem& problem = add(span, number_sentence(shape), {name, {"range", range_text(shape)}});
        if (value.kind == JsonKind::string) problem.number = number_meant(shape, key, value.string);
        break;
      }
      case Kind::text: add(span, says::text, {name}); break;
      case Kind::list: add(span, list_sentence(*shape.items), {name}); break;
      default: add(span, says::object);
    }
  }

  void check_value(JsonShape const& shape, std::size_t index, std::string_view key) {
    JsonValue const& value = document_[index];
    if (!is_of_kind(shape, value)) return refuse_kind(shape, value, key);
    check_.readable[index] = true;
    switch (shape.kind) {
      case Kind::number:
      case Kind::whole_number:
        if (is_in_range(shape, value.number)) break;
        check_.readable[index] = false;
        refuse(shape, value.span, key, exact_number(value.number), number_sentence(shape));
        break;
      case Kind::text: check_.readable[index] = check_text(shape, value.string, value.span, key); break;
      case Kind::list: check_list(shape, value, key); break;
      case Kind::object: check_object(shape, value); break;
      case Kind::map: check_map(shape, value, key); break;
      case Kind::either: check_alternatives(shape, index, key); break;
      default: break;
    }
  }

  bool check_text(JsonShape const& shape, std::string const& text, Span span, std::string_view key) {
    if (!shape.words.empty()) {
      bool const known = std::any_of(shape.words.begin(), shape.words.end(), [&](std::string_view word) {
        return shape.ignores_case ? ascii::equal_ignoring_case(word, text) : word == text;
      });
      if (known) return true;
      Words const words(shape.words.begin(), shape.words.end());
      JsonProblem& problem = add(span, says::one_of, {{"key", std::string(key)}, {"values", joined(words)}});
      problem.suggestion = schema::closest_word(text, words);
      return false;
    }
    if (text.empty() && !shape.may_be_empty) {
      add(span, says::empty_text, {{"key", std::string(key)}});
      return false;
    }
    if (shape.accepts == nullptr || shape.accepts(text)) return true;
    refuse(shape, span, key, text, says::text);
    return false;
  }

  void check_list(JsonShape const& shape, JsonValue const& list, std::string_view key) {
    if (list.items.size() < shape.fewest) refuse(shape, list.span, key, {}, says::empty_text);
    if (list.items.size() > shape.most) {
      add(list.span, says::too_many, {{"key", std::string(key)}, {"limit", std::to_string(shape.most)}});
    }
    std::set<std::string_view> seen;
    for (std::size_t const item : list.items) {
      JsonValue const& value = document_[item];
      if (!is_of_kind(*shape.items, value)) {
        bool const has_sentence = list_sentence(*shape.items) != says::list;
        refuse_kind(has_sentence ? shape : *shape.items, value, key);
        continue;
      }
      check_value(*shape.items, item, key);
      if (shape.distinct && !seen.insert(value.string).second) {
        add(value.span, says::json_repeated_value, {{"key", std::string(key)}, {"value", value.string}});
      }
    }
  }

  void check_object(JsonShape const& shape, JsonValue const& object) {
    std::unordered_map<std::string_view, Span> seen;
    for (JsonMember const& member : object.members) {
      auto const key = std::find_if(shape.keys.begin(), shape.keys.end(),
                                    [&](JsonKey const& each) { return each.name == member.key; });
      if (key == shape.keys.end()) {
        refuse_unknown(shape, member);
      } else if (is_first(seen, member)) {
        check_value(*key->shape, member.value, member.key);
      }
    }
    for (JsonKey const& key : shape.keys) {
      auto const found = seen.find(key.name);
      if (found == seen.end()) {
        if (key.presence == JsonPresence::required) {
          add(object.span, says::json_missing_key, {{"key", std::string(key.name)}});
        }
      } else if (!key.excludes.empty() && seen.contains(key.excludes)) {
        add(found->second, says::excludes,
            {{"key", std::string(key.name)}, {"other", std::string(key.excludes)}});
      }
    }
  }

  void check_map(JsonShape const& shape, JsonValue const& map, std::string_view key) {
    if (map.members.size() < shape.fewest) refuse(shape, map.span, key, {}, says::empty_text);
    std::unordered_map<std::string_view, Span> seen;
    for (JsonMember const& member : map.members) {
      if (!is_first(seen, member)) continue;
      check_text(*shape.names, member.key, member.key_span, key);
      check_value(*shape.items, member.value, member.key);
    }
  }

  void check_alternatives(JsonShape const& shape, std::size_t index, std::string_view key) {
    std::size_t const before = check_.problems.size();
    for (JsonShape const* const alternative : shape.alternatives) {
      check_value(*alternative, index, key);
      if (check_.problems.size() == before) return;
      check_.problems.erase(check_.problems.begin() + static_cast<std::ptrdiff_t>(before),
                            check_.problems.end());
    }
    check_.readable[index] = false;
    refuse(shape, document_[index].span, key, document_[index].string, says::text);
  }

  /// A finding for a key that the object has already.
  bool is_first(std::unordered_map<std::string_view, Span>& seen, JsonMember const& member) {
    auto const [first, is_new] = seen.try_emplace(member.key, member.key_span);
    if (!is_new) add(member.key_span, says::repeated_key, {{"key", member.key}}).first = first->second;
    return is_new;
  }

  void refuse_unknown(JsonShape const& shape, JsonMember const& member) {
    Words names;
    for (JsonKey const& key : shape.keys) names.push_back(key.name);
    JsonProblem& problem = add(member.key_span, says::unknown_key, {{"key", member.key}});
    problem.suggestion = schema::closest_word(member.key, names);
    problem.known_keys = joined(names);
  }

  JsonDocument const& document_;
  JsonCheck check_;
};

}  // namespace

JsonCheck check_json(JsonDocument const& document, JsonShape const& shape) {
  return Checker(document).check(shape);
}

}  // namespace axisc::configuration
