#include "configuration/list_kind.hpp"

#include "diagnostics/ascii.hpp"
#include "grammar/axis_list.hpp"
#include "schema/catalogue.hpp"
#include "schema/tables/kind_tables.hpp"

#include <algorithm>

namespace axisc::configuration {

std::string number_prefix(ListKind kind) {
  return "P-" + std::string(schema::row_of(kind).family);
}

std::optional<ListKind> kind_numbered_in(std::string_view comment) {
  constexpr std::string_view prefix = "P-";
  constexpr std::size_t family_size = 4;
  for (std::size_t at = comment.find(prefix); at != std::string_view::npos;
       at = comment.find(prefix, at + 1)) {
    std::string_view const family = comment.substr(at + prefix.size(), family_size);
    std::string_view const number =
        comment.substr(std::min(at + prefix.size() + family_size, comment.size()));
    if (number.size() < 2 || number[0] != '-' || !ascii::is_digit(number[1])) continue;
    if (auto const kind = schema::find_list_kind(&schema::ListKindRow::family, family)) return kind;
  }
  return std::nullopt;
}

void KindVote::known(std::string_view name) {
  if (name.starts_with("kopf.")) {
    ++heads_;
  } else if (schema::kind_named_by(name)) {
    ++votes_.front();
  }
}

void KindVote::unknown(std::string_view name, std::string_view comment) {
  auto kind = kind_numbered_in(comment);
  if (!kind) kind = schema::kind_named_by(name);
  if (!kind) return;
  ++votes_.at(static_cast<std::size_t>(*kind));
  foreign_ += *kind == ListKind::axis ? 0 : 1;
}

bool KindVote::is_open() const {
  return heads_ == 0 &&
         std::all_of(votes_.begin(), votes_.end(), [](std::size_t votes) { return votes == 0; });
}

ListKind KindVote::winner() const {
  auto const* const most = std::max_element(votes_.begin(), votes_.end());
  auto const kind = static_cast<ListKind>(most - votes_.begin());
  bool const has_heads = kind == ListKind::compensation;
  return *most > votes_.front() + (has_heads ? 0 : heads_) ? kind : ListKind::axis;
}

std::optional<ListKind> decided_kind(SourceText const& list) {
  KindVote vote;
  for (grammar::Assignment const& line : grammar::parse_axis_list(list).assignments) {
    std::string_view const name = list.slice(line.name);
    if (schema::find_exact(name)) {
      vote.known(name);
    } else {
      vote.unknown(name, list.slice(line.trailer));
    }
  }
  if (vote.is_open()) return std::nullopt;
  return vote.winner();
}

}  // namespace axisc::configuration
