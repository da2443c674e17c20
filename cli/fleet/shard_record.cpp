#include "cli/fleet/shard_record.hpp"

#include <nlohmann/json.hpp>

namespace axisc::cli {

namespace {

using Json = nlohmann::ordered_json;

ShardRecord record_of(Json const& json) {
  ShardRecord record;
  record.shard = {.index = json.at("index").get<std::uint32_t>(),
                  .count = json.at("count").get<std::uint32_t>()};
  record.version = json.at("version").get<std::string>();
  record.run = json.at("run").get<std::string>();
  record.status = json.at("status").get<int>();
  record.werror = json.at("werror").get<bool>();
  record.unjudged = json.at("unjudged").get<std::vector<unsigned>>();
  for (auto const& input : json.at("inputs")) {
    record.inputs.push_back({.number = input.at(0).get<std::size_t>(),
                             .findings = input.at(1).get<std::size_t>(),
                             .artifacts = input.at(2).get<std::vector<std::size_t>>()});
  }
  record.files = json.at("files").get<std::vector<std::string>>();
  record.identity_paths = json.at("identity_paths").get<std::map<std::string, std::string>>();
  for (auto const& failure : json.at("failures")) {
    record.failures.push_back({.order = failure.at(0).get<std::size_t>(),
                               .line = failure.at(1).get<std::string>(),
                               .sentence = failure.at(2).get<std::string>()});
  }
  return record;
}

}  // namespace

std::string as_json(ShardRecord const& record) {
  Json failures = Json::array();
  for (auto const& failure : record.failures) {
    failures.push_back({failure.order, failure.line, failure.sentence});
  }
  Json inputs = Json::array();
  for (auto const& input : record.inputs) inputs.push_back({input.number, input.findings, input.artifacts});
  Json const json = {{"index", record.shard.index},    {"count", record.shard.count},
                     {"version", record.version},      {"run", record.run},
                     {"status", record.status},        {"werror", record.werror},
                     {"unjudged", record.unjudged},    {"inputs", std::move(inputs)},
                     {"files", record.files},          {"identity_paths", record.identity_paths},
                     {"failures", std::move(failures)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<ShardRecord> read_shard_record(std::string_view json) {
  try {
    auto record = record_of(Json::parse(json));
    bool const sound = record.shard.index >= 1 && record.shard.index <= record.shard.count;
    return sound ? std::optional(std::move(record)) : std::nullopt;
  } catch (Json::exception const&) {
    return std::nullopt;
  }
}

}  // namespace axisc::cli
