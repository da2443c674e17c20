#include "image/fmu/documentation.hpp"

#include "embedded.hpp"

namespace axisc::image {

namespace {

std::string escaped(std::string_view text) {
  std::string safe;
  for (char const c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string type_of(FmuModel const& model, FmuVariable const& variable) {
  if (variable.type == FmuType::boolean) return "0, 1";
  if (variable.type == FmuType::real) return escaped(variable.unit);
  std::string text;
  for (auto const& enumeration : model.enumerations) {
    if (enumeration.name != variable.enumeration) continue;
    for (auto const& [name, value] : enumeration.items) {
      text += (text.empty() ? "" : ", ") + std::to_string(value) + "&nbsp;" + escaped(name);
    }
  }
  return text;
}

std::string rows(FmuModel const& model) {
  std::string text;
  for (auto const& variable : model.variables) {
    text += "<tr><td>" + escaped(variable.name) + "<td>" + std::to_string(variable.reference) + "<td>" +
            (variable.causality == FmuCausality::input ? "in" : "out") + "<td>" + type_of(model, variable) +
            "<td>" + escaped(variable.description) + "\n";
  }
  return text;
}

void replace(std::string& text, std::string_view mark, std::string_view with) {
  text.replace(text.find(mark), mark.size(), with);
}

}  // namespace

std::string documentation(FmuModel const& model, ImageContents const& contents) {
  std::string page(embedded::fmu_documentation());
  replace(page, "@NAME@", model.identifier);
  replace(page, "@PERIOD@", model.period);
  replace(page, "@AXES@", std::to_string(contents.axes.size()));
  replace(page, "@ROWS@", rows(model));
  return page;
}

}  // namespace axisc::image
