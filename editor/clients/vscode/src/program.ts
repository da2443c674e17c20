// Where the program is: no more than the search that a shell makes.
import * as fs from 'node:fs';
import * as path from 'node:path';

export interface Surroundings {
  /** The folders of PATH, in its spelling. */
  path: string;
  /** Endings of programs on Windows (PATHEXT), in its spelling; empty elsewhere. */
  endings: string;
}

function isProgram(file: string): boolean {
  try {
    fs.accessSync(file, fs.constants.X_OK);
    return fs.statSync(file).isFile();
  } catch {
    return false;
  }
}

/**
 * The program that `setting` names: a file, or a name on the PATH. An empty setting is `axisc`. Undefined where there is
 * none. A relative path is refused: it would depend on the folder that the editor was started in.
 */
export function findProgram(setting: string, surroundings: Surroundings): string | undefined {
  const name = setting.trim() || 'axisc';
  const endings = ['', ...surroundings.endings.split(';').filter((ending) => ending !== '')];
  const candidates = (file: string) => endings.map((ending) => file + ending);
  if (path.isAbsolute(name)) return candidates(name).find(isProgram);
  if (name.includes('/') || name.includes(path.sep)) return undefined;
  return surroundings.path
    .split(path.delimiter)
    .filter((folder) => path.isAbsolute(folder))
    .flatMap((folder) => candidates(path.join(folder, name)))
    .find(isProgram);
}
