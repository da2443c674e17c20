// Open documents, their machines and the client: the state that all capabilities share.
#pragma once

#include "axisc/workspace/buffers.hpp"
#include "axisc/workspace/machine_search.hpp"
#include "axisc/workspace/workspace.hpp"
#include "configuration/files.hpp"
#include "editor/reading/machine_reading.hpp"
#include "editor/reading/requests.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace axisc::editor {

/// How the client counts positions and shows text.
struct Client {
  Language language = Language::english;
  PositionEncoding encoding = PositionEncoding::utf16;
  bool markdown = true;  ///< in hovers
  bool markdown_in_completion = false;
  bool documents_lazily = false;  ///< it asks for the documentation of a selected completion
  std::string finding_page = {};  ///< URI of the page about a finding, with {code}; may be empty
};

class OpenMachines {
 public:
  using Uris = std::set<std::string>;

  /// `disk` outlives this object.
  OpenMachines(configuration::Files& disk, OptionsOf options, Language language)
      : disk_(disk), options_(std::move(options)), client_{.language = language} {}
  OpenMachines(OpenMachines const&) = delete;
  OpenMachines& operator=(OpenMachines const&) = delete;

  [[nodiscard]] Client& client() { return client_; }
  [[nodiscard]] Language language() const { return client_.language; }
  [[nodiscard]] PositionEncoding encoding() const { return client_.encoding; }
  [[nodiscard]] std::string say(SentenceRef sentence, std::vector<Argument> arguments = {}) const {
    return editor::say(sentence, client_.language, std::move(arguments));
  }

  [[nodiscard]] OpenDocuments const& documents() const { return documents_; }
  /// By its URI; throws std::out_of_range if it is not open.
  [[nodiscard]] OpenDocument const& document(Json const& uri) const;
  /// The document that a request names.
  [[nodiscard]] OpenDocument const& asked(Json const& params) const;
  /// The byte at the "position" of a request.
  [[nodiscard]] std::size_t offset(OpenDocument const& document, Json const& params) const;
  /// The range between two bytes of a document.
  [[nodiscard]] Json range(OpenDocument const& document, std::size_t begin, std::size_t end) const;

  /// Each returns the open documents whose findings may have changed.
  [[nodiscard]] Uris open(OpenDocument document);
  [[nodiscard]] Uris replace(OpenDocument const& document, std::string text,
                             std::optional<std::int64_t> version);
  [[nodiscard]] Uris close(std::string const& uri);
  /// For changes of files or settings.
  [[nodiscard]] Uris forget();
  /// Machines are read again on demand; the record of files that they looked for is kept.
  void forget_readings();

  [[nodiscard]] OptionsOf const& options() const { return options_; }
  [[nodiscard]] Buffers buffers();
  /// The disk with other documents over it, which outlive the result.
  [[nodiscard]] Buffers buffers(OpenDocuments const& documents) const { return {documents, disk_}; }
  /// The input of the machine that the document belongs to.
  [[nodiscard]] std::string const& machine_of(OpenDocument const& document);
  [[nodiscard]] MachineReading& reading_of(std::string const& machine);
  [[nodiscard]] MachineReading& reading_of(OpenDocument const& document) {
    return reading_of(machine_of(document));
  }
  [[nodiscard]] OpenList const& list_of(OpenDocument const& document) {
    return reading_of(document).list(document);
  }

 private:
  configuration::Files& disk_;
  OptionsOf options_;
  Client client_;
  OpenDocuments documents_;
  std::shared_ptr<OpenPaths const> open_paths_;  ///< null after a document was opened or closed
  MachineSearch search_;
  Readers readers_;  ///< of machines whose readings were dropped and that are not checked anyway
  std::map<std::string, std::string>
      machines_;  ///< inputs, by URI of the document; cleared if they may change
  /// By input. Changing a document drops those that depend on it; opening or closing one drops all.
  std::map<std::string, std::unique_ptr<MachineReading>> readings_;
};

}  // namespace axisc::editor
