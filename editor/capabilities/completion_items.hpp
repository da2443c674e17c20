// The items that a completion offers.
#pragma once

#include "editor/reading/open_list.hpp"
#include "editor/reading/requests.hpp"

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace axisc::editor {

enum class ItemKind : int { property = 10, module = 9, enumeration_member = 20, reference = 18 };

/// Collects the items of one completion.
class CompletionItems {
 public:
  /// The label replaces `range`. Clients that ask for the documentation of an item send back `uri`, that of
  /// the document; if it is empty, items carry their documentation.
  CompletionItems(Json range, Language language, std::string uri)
      : range_(std::move(range)), language_(language), uri_(std::move(uri)) {}

  [[nodiscard]] Json take() { return std::move(items_); }

  Json& add(std::string const& label, ItemKind kind);
  /// The segments that can follow `typed`.
  void add_names(OpenList const& list, std::string_view typed);
  /// Symbols, known numbers and the default of a parameter, with their meaning.
  void add_values(schema::Parameter const& row);
  /// `P-AXIS-00212`: the value of another parameter.
  void add_references(schema::Catalogue const& catalogue, std::string_view typed);

 private:
  void document(Json& item, schema::Parameter const& row) const;

  Json range_;
  Language language_;
  std::string uri_;
  Json items_ = Json::array();
};

}  // namespace axisc::editor
