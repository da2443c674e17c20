#include "support/sarif_schema.hpp"

#include "support/catch.hpp"
#include "support/file_contents.hpp"
#include "support/golden.hpp"

#include <cstdlib>
#include <map>

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace axisc::test {

namespace {

using json_type = nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

/// Read once for all documents.
valijson::Schema const& schema_of(std::string const& text) {
  static std::map<std::string, valijson::Schema> known;
  auto const [at, is_new] = known.try_emplace(text);
  if (is_new) {
    auto const document = json_type::parse(text);
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(document), at->second);
  }
  return at->second;
}

void validate(json_type const& document, std::string const& schema, std::vector<std::string>& complaints) {
  valijson::ValidationResults results;
  valijson::Validator(valijson::Validator::kStrongTypes)
      .validate(schema_of(schema), Adapter(document), &results);
  for (auto const& error : results) {
    std::string place;
    for (auto const& part : error.context) place += part;
    complaints.push_back(place + ": " + error.description);
  }
}

}  // namespace

std::vector<std::string> sarif_complaints(std::string const& text) {
  auto const document = json_type::parse(text, nullptr, false);
  if (document.is_discarded()) return {"no JSON"};
  std::vector<std::string> complaints;
  validate(document, read_source_file("tests/data/sarif/structure-2.1.0.schema.json"), complaints);
  if (char const* const published = std::getenv("AXISC_SARIF_SCHEMA")) {  // NOLINT(concurrency-mt-unsafe)
    validate(document, file_contents(published), complaints);
  }
  return complaints;
}

std::vector<std::string> schema_complaints(std::string const& text, std::string const& schema) {
  auto const document = json_type::parse(text, nullptr, false);
  if (document.is_discarded()) return {"not JSON"};
  std::vector<std::string> complaints;
  validate(document, schema, complaints);
  return complaints;
}

}  // namespace axisc::test
