#include "configuration/machine_file_report.hpp"

#include "configuration/json_reading.hpp"
#include "configuration/sentences.hpp"
#include "diagnostics/terminal.hpp"

#include <array>

namespace axisc::configuration::says {

constexpr Sentence invisible_name{
    "\"{key}\" must not contain control characters, line breaks or other invisible characters",
    "\"{key}\" darf keine Steuerzeichen, Zeilenumbrüche oder andere unsichtbare Zeichen enthalten"};

}  // namespace axisc::configuration::says

namespace axisc::configuration {

constexpr JsonShape visible_name_shape{.accepts = [](std::string_view name) { return is_visible(name); },
                                       .pattern = R"(^[^\u0000-\u001F\u007F]+$)",
                                       .sentence = says::invisible_name};

namespace {

using enum JsonPresence;

constexpr JsonShape tolerance_shape{.kind = JsonShapeKind::number, .lowest = 0, .above_lowest = true};

void store_tolerance(JsonDocument const& /*document*/, JsonValue const& value, MachineFileReport& report) {
  report.tolerance_mm = value.number;
}

constexpr std::array report_keys = {
    JsonKey{"title", &visible_name_shape, optional, "Title instead of the machine's name.",
            into<&MachineFileReport::title>},
    JsonKey{"customer", &visible_name_shape, optional, "The customer.", into<&MachineFileReport::customer>},
    JsonKey{"author", &visible_name_shape, optional, "Who prepared the report.",
            into<&MachineFileReport::author>},
    JsonKey{"date", &visible_name_shape, optional, "Date as the cover shows it.",
            into<&MachineFileReport::date>},
    JsonKey{"tolerance_mm", &tolerance_shape, optional,
            "Allowed axis error in mm, as `axisc report --tolerance` takes it.", by<store_tolerance>}};

}  // namespace

constexpr JsonShape machine_file_report_shape{
    .kind = JsonShapeKind::object, .title = "Cover of a report", .keys = report_keys};

}  // namespace axisc::configuration
