// The commands of the program: each reads its options, calls the library and prints.
#pragma once

#include "cli/options/exit_status.hpp"
#include "cli/options/invocation.hpp"

namespace axisc::cli {

[[nodiscard]] ExitStatus lint(Invocation const& invocation);
[[nodiscard]] ExitStatus lsp(Invocation const& invocation);
[[nodiscard]] ExitStatus fmt(Invocation const& invocation);
[[nodiscard]] ExitStatus compile(Invocation const& invocation);
[[nodiscard]] ExitStatus machine(Invocation const& invocation);
[[nodiscard]] ExitStatus get(Invocation const& invocation);
[[nodiscard]] ExitStatus set(Invocation const& invocation);
[[nodiscard]] ExitStatus inspect(Invocation const& invocation);
[[nodiscard]] ExitStatus certify(Invocation const& invocation);
[[nodiscard]] ExitStatus run(Invocation const& invocation);
[[nodiscard]] ExitStatus response(Invocation const& invocation);
[[nodiscard]] ExitStatus compare(Invocation const& invocation);
[[nodiscard]] ExitStatus plot(Invocation const& invocation);
[[nodiscard]] ExitStatus report(Invocation const& invocation);
[[nodiscard]] ExitStatus replay(Invocation const& invocation);
[[nodiscard]] ExitStatus diff(Invocation const& invocation);
[[nodiscard]] ExitStatus export_filters(Invocation const& invocation);
[[nodiscard]] ExitStatus keygen(Invocation const& invocation);
[[nodiscard]] ExitStatus sign(Invocation const& invocation);
[[nodiscard]] ExitStatus contour(Invocation const& invocation);
[[nodiscard]] ExitStatus circle(Invocation const& invocation);
[[nodiscard]] ExitStatus suggest(Invocation const& invocation);
[[nodiscard]] ExitStatus identify(Invocation const& invocation);
[[nodiscard]] ExitStatus simulate(Invocation const& invocation);
[[nodiscard]] ExitStatus schema(Invocation const& invocation);
[[nodiscard]] ExitStatus explain(Invocation const& invocation);

}  // namespace axisc::cli
