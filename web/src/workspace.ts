// The files that a user brought, as they came and as they are now.
import { decode, encode, isBinary, type Decoded } from './encoding';

export interface WorkFile {
  path: string;
  original: Uint8Array;
  bytes: Uint8Array;
}

/** What commands are called with, and what the user dropped. */
export interface Inputs {
  /** For lint: a folder, or each file. */
  checked: string[];
  /** For commands about one machine or list. */
  machine: string;
}

export const largestShown = 4 * 1024 * 1024;
const folderOf = (path: string): string => path.slice(0, Math.max(0, path.indexOf('/')));

export class Workspace {
  readonly files = new Map<string, WorkFile>();

  constructor(files: Iterable<[string, Uint8Array]> = []) {
    for (const [path, bytes] of files) this.files.set(path, { path, original: bytes, bytes });
  }

  get paths(): string[] {
    return [...this.files.keys()].sort();
  }

  get inputs(): Inputs {
    const paths = this.paths;
    const folders = [...new Set(paths.map(folderOf))];
    if (folders.length === 1 && folders[0]) return { checked: [folders[0]], machine: folders[0] };
    const checked = paths.filter((path) => /\.(lis|nc|json|xml|tsproj|xti)$/i.test(path));
    const named = checked.length > 0 ? checked : paths;
    return { checked: named, machine: named.find((path) => /\.(json|tsproj|xti)$/i.test(path)) ?? named[0] ?? '.' };
  }

  get isChanged(): boolean {
    return [...this.files.values()].some((file) => file.bytes !== file.original);
  }

  /** Null where the file is no text, or too long for an editor. */
  text(path: string): Decoded | null {
    const file = this.files.get(path);
    if (!file || file.bytes.length > largestShown || isBinary(file.bytes)) return null;
    return decode(file.bytes);
  }

  /** The bytes of a changed file; those that came where they mean the same. */
  write(path: string, decoded: Decoded): Uint8Array {
    return this.put(path, encode(decoded));
  }

  put(path: string, bytes: Uint8Array): Uint8Array {
    const file = this.files.get(path);
    if (!file) throw new Error(path);
    const same = bytes.length === file.original.length && bytes.every((byte, i) => byte === file.original[i]);
    file.bytes = same ? file.original : bytes;
    return file.bytes;
  }
}
