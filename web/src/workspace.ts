// The files that the user opened, as they came and as they are now.
import { edited } from './edits';
import { decode, encode, isBinary, type Decoded } from './encoding';
import type { Edit } from './findings';

export interface WorkFile {
  path: string;
  original: Uint8Array;
  bytes: Uint8Array;
}

export const largestShown = 4 * 1024 * 1024;
const description = /(^|\/)(hochlauf[^/]*\.(lis|xml)|(?!axisc\.json$)[^/]*\.json|[^/]*\.(tsproj|xti))$/i;

/** A name that the program takes neither for an option nor for a response file. */
const named = (path: string): string => (/^[-@]/.test(path) ? `./${path}` : path);

export class Workspace {
  readonly files = new Map<string, WorkFile>();

  constructor(files: Iterable<[string, Uint8Array]> = []) {
    for (const [path, bytes] of files) this.files.set(path, { path, original: bytes, bytes });
  }

  get paths(): string[] {
    return [...this.files.keys()].sort();
  }

  /** The one folder that everything is in; empty for single files. */
  private get root(): string {
    const folders = new Set(this.paths.map((path) => path.slice(0, Math.max(0, path.indexOf('/')))));
    return folders.size === 1 ? ([...folders][0] as string) : '';
  }

  /** Files that describe a machine, cycle time included. */
  get descriptions(): string[] {
    const plants = this.plants;
    return this.paths.filter((path) => description.test(path) && !plants.includes(path));
  }

  /** Files that describe drives and mechanics, whatever their names. */
  get plants(): string[] {
    return this.paths.filter((path) => /\.json$/i.test(path) && /"plants"\s*:/.test(this.text(path)?.text ?? ''));
  }

  /** The input of `lint`: the folder, or each file. */
  get checked(): string[] {
    if (this.root !== '') return [named(this.root)];
    // Plants and settings are read by the commands that need them.
    const others = [...this.plants, 'axisc.json'];
    const known = this.paths.filter((path) => /\.(lis|nc|json|xml|tsproj|xti)$/i.test(path) && !others.includes(path));
    return (known.length > 0 ? known : this.paths).map(named);
  }

  /** The input of commands about one machine, while `shown` is looked at: its machine, or the list alone. */
  machineOf(shown: string): string {
    const descriptions = this.descriptions;
    const above = descriptions.filter((path) => path === shown || shown.startsWith(path.slice(0, path.lastIndexOf('/') + 1)));
    if (descriptions.length === 0 || (above.length === 0 && /\.(lis|xml)$/i.test(shown))) return named(shown);
    if (descriptions.length === 1 && this.root !== '') return named(this.root);
    return named(above.sort((a, b) => b.length - a.length)[0] ?? (descriptions[0] as string));
  }

  get changed(): WorkFile[] {
    return [...this.files.values()].filter((file) => file.bytes !== file.original);
  }

  /** Null where the file is not text, or too long for an editor. */
  text(path: string): Decoded | null {
    const file = this.files.get(path);
    if (!file || file.bytes.length > largestShown || isBinary(file.bytes)) return null;
    return decode(file.bytes);
  }

  /** The bytes of a changed file; the original bytes where they mean the same. */
  write(path: string, decoded: Decoded): Uint8Array {
    return this.put(path, encode(decoded));
  }

  /** Files with the edits of a fix. */
  repaired(edits: readonly Edit[]): [string, Uint8Array][] {
    return [...new Set(edits.map((edit) => edit.file))].flatMap((path): [string, Uint8Array][] => {
      const decoded = this.text(path);
      if (!decoded) return [];
      const text = edited(decoded.text, edits.filter((edit) => edit.file === path));
      return [[path, this.write(path, { ...decoded, text })]];
    });
  }

  put(path: string, bytes: Uint8Array): Uint8Array {
    const file = this.files.get(path);
    if (!file) throw new Error(path);
    const same = bytes.length === file.original.length && bytes.every((byte, i) => byte === file.original[i]);
    file.bytes = same ? file.original : bytes;
    return file.bytes;
  }
}
