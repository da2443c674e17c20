#include "axisc/settings/finding_shape.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace axisc::says {

constexpr Sentence or_null{"{key} has another value or null", "{key} hat einen anderen Wert oder null"};
constexpr Sentence finding_code{"{key} must be a code such as AX3005, not {value}",
                                "{key} muss ein Code wie AX3005 sein, nicht {value}"};

}  // namespace axisc::says

namespace axisc {

namespace {

using configuration::json_null;
using configuration::JsonKey;
using configuration::JsonShape;
using Kind = configuration::JsonShapeKind;
using enum configuration::JsonPresence;

bool is_code(std::string_view text) {
  return text.size() == 6 && text.starts_with("AX") &&
         std::all_of(text.begin() + 2, text.end(), [](char letter) { return ascii::is_digit(letter); });
}

constexpr JsonShape code{.accepts = is_code, .pattern = "^AX[0-9]{4}$", .sentence = says::finding_code};
constexpr std::array<std::string_view, 3> severities = {"error", "warning", "note"};
constexpr JsonShape severity{.words = severities};
constexpr JsonShape text{.may_be_empty = true};
constexpr JsonShape texts{.kind = Kind::list, .items = &text};
constexpr JsonShape count{.kind = Kind::whole_number, .lowest = 1};

constexpr std::array<JsonShape const*, 2> text_or_null{&text, &json_null};
constexpr JsonShape optional_text{
    .kind = Kind::either, .alternatives = text_or_null, .sentence = says::or_null};
constexpr std::array<JsonShape const*, 2> count_or_null{&count, &json_null};
constexpr JsonShape optional_count{
    .kind = Kind::either, .alternatives = count_or_null, .sentence = says::or_null};

constexpr std::array<JsonKey, 3> control_keys{{
    {"message", &optional_text, required, "the numbers of its messages, \"50663/60311\""},
    {"reaction", &optional_text, required, "what it does"},
    {"value", &optional_text, required, "the value that it runs with"},
}};
constexpr JsonShape control{.kind = Kind::object, .keys = control_keys};
constexpr std::array<JsonShape const*, 2> control_or_null{&control, &json_null};
constexpr JsonShape optional_control{
    .kind = Kind::either, .alternatives = control_or_null, .sentence = says::or_null};

constexpr std::array<JsonKey, 4> related_keys{{
    {"file", &text, required, "the file"},
    {"line", &count, required, "from 1"},
    {"column", &count, required, "from 1, in code points"},
    {"message", &text, required, "what is there"},
}};
constexpr JsonShape related{.kind = Kind::object, .keys = related_keys};
constexpr JsonShape all_related{.kind = Kind::list, .items = &related};

constexpr std::array<JsonKey, 6> edit_keys{{
    {"file", &text, required, "the file"},
    {"line", &count, required, "where the replaced text begins"},
    {"column", &count, required, "of its first character"},
    {"end_line", &count, required, "where it ends"},
    {"end_column", &count, required, "the column after its last character"},
    {"text", &text, required, "what replaces it"},
}};
constexpr JsonShape edit{.kind = Kind::object, .keys = edit_keys};
constexpr JsonShape edits{.kind = Kind::list, .items = &edit};
constexpr std::array<JsonKey, 2> fix_keys{{
    {"title", &text, required, "what is changed"},
    {"edits", &edits, required, "all of them belong together"},
}};
constexpr JsonShape fix{.kind = Kind::object, .keys = fix_keys};
constexpr std::array<JsonShape const*, 2> fix_or_null{&fix, &json_null};
constexpr JsonShape optional_fix{
    .kind = Kind::either, .alternatives = fix_or_null, .sentence = says::or_null};

constexpr std::array<JsonKey, 16> finding_keys{{
    {"code", &code, required, "`axisc explain` has a page for each"},
    {"name", &text, required, "the same in words, `delay-too-long`"},
    {"severity", &severity, required, "settings may change it"},
    {"message", &text, required, "what is wrong, in the language of the run"},
    {"file", &optional_text, required, "as the command line or the machine names it"},
    {"line", &optional_count, required, "from 1; null where the file as a whole is meant"},
    {"column", &optional_count, required, "from 1, in code points"},
    {"end_line", &optional_count, required, "of the last character"},
    {"end_column", &optional_count, required, "the column after the last character"},
    {"parameter", &optional_text, required, "`filter[0].order`"},
    {"p_axis", &optional_text, required, "`P-AXIS-00140`"},
    {"axis", &optional_text, required, "name of the axis"},
    {"control", &optional_control, required, "what the control does: `message`, `reaction`, `value`"},
    {"notes", &texts, required, "reasons and advice, in order"},
    {"related", &all_related, required, "further places"},
    {"fix", &optional_fix, required,
     "`title`, and `edits` with `file`, `line`, `column`, `end_line`, `end_column`, `text`"},
}};

}  // namespace

constexpr JsonShape finding_shape{.kind = Kind::object, .title = "Finding of axisc", .keys = finding_keys};

}  // namespace axisc
