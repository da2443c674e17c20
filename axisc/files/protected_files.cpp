#include "axisc/files/protected_files.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/key_file.hpp"
#include "axisc/files/path_identity.hpp"
#include "system/file.hpp"

#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace axisc::says {

constexpr Sentence is_input{
    "{file} is one of the inputs and would be overwritten; choose another name",
    "{file} ist eine der Eingaben und würde überschrieben; einen anderen Namen wählen"};
constexpr Sentence is_output_too{"{file} and {other} are the same file; choose two names",
                                 "{file} und {other} sind dieselbe Datei; zwei Namen wählen"};
constexpr Sentence is_key{
    "{file} is a secret key and would be overwritten; choose another name",
    "{file} ist ein geheimer Schlüssel und würde überschrieben; einen anderen Namen wählen"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// A key that all names of one file share; none for anything but a file.
class FileIdentities {
 public:
  [[nodiscard]] std::optional<std::string> of(std::string const& path) {
    if (path == "-") return std::nullopt;
    auto const status = system::status_of(path);
    auto const* const facts = std::get_if<system::FileStatus>(&status);
    if (facts == nullptr) return paths_.of(behind_links(path));
    if (facts->kind != system::FileKind::regular) return std::nullopt;
    return std::to_string(facts->device) + ":" + std::to_string(facts->inode);
  }

 private:
  PathIdentities paths_;
};

[[noreturn]] void refuse(SentenceRef text, std::string const& file, std::string const& other = {}) {
  throw Failure({text, {{"file", file}, {"other", other}}}, cannot_write);
}

}  // namespace

void refuse_overwriting(std::vector<std::string> const& outputs, std::vector<std::string> const& inputs) {
  FileIdentities identities;
  std::unordered_map<std::string, std::string const*> known;
  for (auto const& output : outputs) {
    auto identity = identities.of(output);
    if (!identity) continue;
    auto const [first, is_new] = known.try_emplace(*std::move(identity), &output);
    if (!is_new) refuse(says::is_output_too, *first->second, output);
    if (is_secret_key(output)) refuse(says::is_key, output);
  }
  if (known.empty()) return;
  for (auto const& input : inputs) {
    auto const identity = identities.of(input);
    auto const found = identity ? known.find(*identity) : known.end();
    if (found != known.end()) refuse(says::is_input, *found->second);
  }
}

}  // namespace axisc
