import { readdirSync, statSync } from "node:fs";
import { join } from "node:path";

/// The paths of all folders and files below a folder, sorted.
export function* below(folder) {
  for (const name of readdirSync(folder).sort()) {
    const path = join(folder, name);
    yield path;
    if (statSync(path).isDirectory()) yield* below(path);
  }
}
