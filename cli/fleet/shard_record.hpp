// The record of a shard in its JSON or SARIF result, from which `axisc merge` combines several results.
//
//   "shard": {"index": 2, "count": 8, "version": "0.1.0", "run": "0f…", "status": 1, "werror": false, "unjudged": [],
//             "inputs": [[17, 3, [0]], [40, 1, [0, 1]]], "files": ["a.lis"], "identity_paths": {"a.lis": "axes/a.lis"},
//             "failures": [[3, "axisc: error[AX9001]: …", "cannot read …"]]}
#pragma once

#include "cli/fleet/shard.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::cli {

struct ShardFailure {
  std::size_t order = 0;  ///< among the failures of the whole run
  std::string line;       ///< for standard error
  std::string sentence;   ///< for the report
};

struct ShardInput {
  std::size_t number = 0;              ///< among all inputs of the run
  std::size_t findings = 0;            ///< so many of the next ones are its own
  std::vector<std::size_t> artifacts;  ///< SARIF: those that they point into, in the order of the sources
};

struct ShardRecord {
  Shard shard;
  std::string version;             ///< of the program
  std::string run;                 ///< a digest: equal for the shards of one run
  int status = 0;                  ///< exit status
  bool werror = false;             ///< warnings lead to exit status 1
  std::vector<unsigned> unjudged;  ///< codes that the run does not look for
  std::vector<ShardInput> inputs;  ///< with findings
  std::vector<std::string> files;  ///< that were read
  /// Files of findings, by the names that the report gives them, where the identities name them otherwise.
  std::map<std::string, std::string> identity_paths;
  std::vector<ShardFailure> failures;
};

/// One line of JSON.
[[nodiscard]] std::string as_json(ShardRecord const& record);
/// None for a text that as_json() does not write.
[[nodiscard]] std::optional<ShardRecord> read_shard_record(std::string_view json);

}  // namespace axisc::cli
