#include "lists/readers.hpp"

#include <simdjson.h>

namespace axisc::bench {

struct Simdjson::Parsers {
  simdjson::dom::parser document;
  simdjson::ondemand::parser on_demand;
};

Simdjson::Simdjson() : parsers_(std::make_unique<Parsers>()) {}
Simdjson::~Simdjson() = default;

void Simdjson::read_document(std::string const& json, EntryTable& table) {
  table.clear();
  // The capacity of a string is its padding; the text is padded by who made it.
  simdjson::dom::object const object = parsers_->document.parse(json.data(), json.size(), false).get_object();
  for (auto const& [name, value] : object) {
    schema::Parameter const* const parameter = table.open(name, 0);
    if (parameter == nullptr) continue;
    if (value.is_bool()) {
      table.truth(*parameter, value.get_bool());
    } else if (value.is_string()) {
      table.word(*parameter, value.get_string().value());
    } else {
      table.number(*parameter, value.is_double() ? value.get_double().value()
                                                 : static_cast<double>(value.get_int64().value()));
    }
  }
}

void Simdjson::read_on_demand(std::string const& json, EntryTable& table) {
  table.clear();
  simdjson::ondemand::document document =
      parsers_->on_demand.iterate(json.data(), json.size(), json.size() + simdjson::SIMDJSON_PADDING);
  for (auto field : document.get_object()) {
    std::string_view const name = field.unescaped_key();
    auto const position = static_cast<std::uint32_t>(name.size());
    schema::Parameter const* const parameter = table.open(name, position);
    simdjson::ondemand::value value = field.value();
    if (parameter == nullptr) continue;
    switch (value.type()) {
      case simdjson::ondemand::json_type::boolean: table.truth(*parameter, value.get_bool()); break;
      case simdjson::ondemand::json_type::string: table.word(*parameter, value.get_string().value()); break;
      default: table.number(*parameter, value.get_double());
    }
  }
}

}  // namespace axisc::bench
