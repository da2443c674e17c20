#include "image/fmu/descriptions.hpp"

#include "image/fmu/xml_elements.hpp"

namespace axisc::image {

namespace {

using pugi::xml_node;

constexpr char const* logged = "logStatusError";

char const* or_none(std::string_view text) {
  return text.empty() ? nullptr : text.data();
}

char const* word(FmuCausality causality) {
  return causality == FmuCausality::input ? "input" : "output";
}

/// Outputs are computed from the inputs; inputs begin with 0.
char const* initial(FmuVariable const& variable) {
  return variable.causality == FmuCausality::output ? "calculated" : nullptr;
}

char const* start(FmuVariable const& variable, bool plain_integers) {
  if (variable.causality == FmuCausality::output) return nullptr;
  return variable.type == FmuType::boolean && !plain_integers ? "false" : "0";
}

bool is_integer(FmuVariable const& variable, bool plain_integers) {
  return plain_integers && variable.type != FmuType::real;
}

std::string_view shown_unit(FmuModel const& model, std::string_view unit) {
  for (auto const& candidate : model.units) {
    if (candidate.name == unit) return candidate.shown;
  }
  return {};
}

xml_node add_root(pugi::xml_document& document, char const* version, char const* token_attribute,
                  FmuModel const& model) {
  return add_element(document, "fmiModelDescription",
                     {{"fmiVersion", version},
                      {"modelName", model.identifier.c_str()},
                      {token_attribute, model.token.c_str()},
                      {"description", model.description.c_str()},
                      {"license", "MIT"},
                      {"generationTool", "axisc"},
                      {"variableNamingConvention", model.is_structured ? "structured" : "flat"}});
}

void add_units(xml_node root, FmuModel const& model, bool has_time) {
  if (model.units.empty() && !has_time) return;
  auto const definitions = add_element(root, "UnitDefinitions");
  for (auto const& unit : model.units) {
    auto const element = add_element(definitions, "Unit", {{"name", unit.name.data()}});
    add_element(element, "BaseUnit",
                {{"m", unit.length}, {"s", unit.time}, {"rad", unit.angle}, {"factor", unit.factor.data()}});
    add_element(element, "DisplayUnit", {{"name", unit.shown.data()}, {"factor", unit.shown_factor.data()}});
  }
  if (has_time) {
    add_element(add_element(definitions, "Unit", {{"name", "s"}}), "BaseUnit", {{"s", "1"}});
  }
}

void add_items(xml_node element, FmuEnumeration const& enumeration) {
  for (auto const& [name, value] : enumeration.items) {
    add_element(element, "Item", {{"name", name.c_str()}, {"value", std::to_string(value).c_str()}});
  }
}

void add_settings(xml_node root, FmuModel const& model) {
  add_element(add_element(root, "LogCategories"), "Category", {{"name", logged}});
  add_element(root, "DefaultExperiment", {{"startTime", "0"}, {"stepSize", model.period.c_str()}});
}

// ---- FMI 3.0

void add_variable_3(xml_node variables, FmuModel const& model, FmuVariable const& variable,
                    bool plain_integers) {
  char const* const type = is_integer(variable, plain_integers) ? "Int32"
                           : variable.type == FmuType::real     ? "Float64"
                           : variable.type == FmuType::boolean  ? "Boolean"
                                                                : "Enumeration";
  add_element(variables, type,
              {{"name", variable.name.c_str()},
               {"valueReference", std::to_string(variable.reference).c_str()},
               {"description", variable.description.c_str()},
               {"causality", word(variable.causality)},
               {"variability", "discrete"},
               {"initial", initial(variable)},
               {"declaredType", plain_integers ? nullptr : or_none(variable.enumeration)},
               {"unit", or_none(variable.unit)},
               {"displayUnit", or_none(shown_unit(model, variable.unit))},
               {"start", start(variable, plain_integers)}});
}

std::string description_3(FmuModel const& model, FmuOptions const& options) {
  pugi::xml_document document;
  auto const root = add_root(document, "3.0", "instantiationToken", model);
  add_element(root, "CoSimulation",
              {{"modelIdentifier", model.identifier.c_str()},
               {"canGetAndSetFMUState", "true"},
               {"canHandleVariableCommunicationStepSize", "false"},
               {"fixedInternalStepSize", model.period.c_str()}});
  add_units(root, model, true);
  if (!options.plain_integers) {
    auto const types = add_element(root, "TypeDefinitions");
    for (auto const& enumeration : model.enumerations) {
      add_items(add_element(types, "EnumerationType", {{"name", enumeration.name.c_str()}}), enumeration);
    }
  }
  add_settings(root, model);
  auto const variables = add_element(root, "ModelVariables");
  add_element(variables, "Float64",
              {{"name", "time"},
               {"valueReference", "0"},
               {"causality", "independent"},
               {"variability", "continuous"},
               {"unit", "s"}});
  for (auto const& variable : model.variables) {
    add_variable_3(variables, model, variable, options.plain_integers);
  }
  auto const structure = add_element(root, "ModelStructure");
  for (char const* const kind : {"Output", "InitialUnknown"}) {
    for (auto const& variable : model.variables) {
      if (variable.causality != FmuCausality::output) continue;
      // An output belongs to the inputs before the step, except while the FMU is initialized.
      auto element =
          add_element(structure, kind, {{"valueReference", std::to_string(variable.reference).c_str()}});
      if (kind == std::string_view("Output")) element.append_attribute("dependencies").set_value("");
    }
  }
  return text_of(document);
}

// ---- FMI 2.0

void add_variable_2(xml_node variables, FmuModel const& model, FmuVariable const& variable,
                    bool plain_integers) {
  auto const element = add_element(variables, "ScalarVariable",
                                   {{"name", variable.name.c_str()},
                                    {"valueReference", std::to_string(variable.reference).c_str()},
                                    {"description", variable.description.c_str()},
                                    {"causality", word(variable.causality)},
                                    {"variability", "discrete"},
                                    {"initial", initial(variable)}});
  char const* const type = is_integer(variable, plain_integers) ? "Integer"
                           : variable.type == FmuType::real     ? "Real"
                           : variable.type == FmuType::boolean  ? "Boolean"
                                                                : "Enumeration";
  add_element(element, type,
              {{"declaredType", plain_integers ? nullptr : or_none(variable.enumeration)},
               {"unit", or_none(variable.unit)},
               {"displayUnit", or_none(shown_unit(model, variable.unit))},
               {"start", start(variable, plain_integers)}});
}

std::string description_2(FmuModel const& model, FmuOptions const& options,
                          std::span<std::string_view const> sources) {
  pugi::xml_document document;
  auto const root = add_root(document, "2.0", "guid", model);
  auto const simulation = add_element(root, "CoSimulation",
                                      {{"modelIdentifier", model.identifier.c_str()},
                                       {"canHandleVariableCommunicationStepSize", "false"},
                                       {"canNotUseMemoryManagementFunctions", "true"},
                                       {"canGetAndSetFMUstate", "true"}});
  auto const files = add_element(simulation, "SourceFiles");
  for (auto const source : sources) add_element(files, "File", {{"name", source.data()}});
  add_units(root, model, false);
  if (!options.plain_integers) {
    auto const types = add_element(root, "TypeDefinitions");
    for (auto const& enumeration : model.enumerations) {
      auto const type = add_element(types, "SimpleType", {{"name", enumeration.name.c_str()}});
      add_items(add_element(type, "Enumeration"), enumeration);
    }
  }
  add_settings(root, model);
  auto const variables = add_element(root, "ModelVariables");
  for (auto const& variable : model.variables) {
    add_variable_2(variables, model, variable, options.plain_integers);
  }
  auto const structure = add_element(root, "ModelStructure");
  for (char const* const kind : {"Outputs", "InitialUnknowns"}) {
    auto const list = add_element(structure, kind);
    for (std::size_t i = 0; i < model.variables.size(); ++i) {
      if (model.variables[i].causality != FmuCausality::output) continue;
      auto element = add_element(list, "Unknown", {{"index", std::to_string(i + 1).c_str()}});
      if (kind == std::string_view("Outputs")) element.append_attribute("dependencies").set_value("");
    }
  }
  return text_of(document);
}

}  // namespace

std::string model_description(FmuModel const& model, FmuOptions const& options,
                              std::span<std::string_view const> sources) {
  return options.version == FmiVersion::three ? description_3(model, options)
                                              : description_2(model, options, sources);
}

std::string build_description(FmuModel const& model, std::span<std::string_view const> sources) {
  pugi::xml_document document;
  auto const root = add_element(document, "fmiBuildDescription", {{"fmiVersion", "3.0"}});
  auto const build = add_element(root, "BuildConfiguration", {{"modelIdentifier", model.identifier.c_str()}});
  auto const set = add_element(build, "SourceFileSet", {{"language", "C99"}});
  for (auto const source : sources) add_element(set, "SourceFile", {{"name", source.data()}});
  return text_of(document);
}

}  // namespace axisc::image
