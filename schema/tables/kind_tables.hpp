// The catalogues of all kinds of lists but axis lists.
#pragma once

#include "schema/tables/own_tables.hpp"

#include <memory>
#include <optional>

namespace axisc::schema {

/// The tables of a kind, which is not `axis`. Cost: the first call for a kind takes its names apart, well
/// below a millisecond; any thread may call.
[[nodiscard]] std::shared_ptr<OwnTables const> kind_tables(ListKind kind);

/// The one kind of which names begin like this one, with the text before the first `.` or `[`: channel for
/// `gruppe[0].bezeichnung`. None where no kind or several have such names.
[[nodiscard]] std::optional<ListKind> kind_named_by(std::string_view name);

}  // namespace axisc::schema
