// The files that the user opened, as they came and as they are now.
import { edited } from './edits';
import { decode, encode, isBinary, type Decoded } from './encoding';
import { isRecording } from './incoming';
import type { Edit } from './findings';

export interface WorkFile {
  path: string;
  original: Uint8Array;
  bytes: Uint8Array;
  /** What was saved last. */
  saved: Uint8Array;
}

export const largestShown = 4 * 1024 * 1024;
export class Workspace {
  readonly files = new Map<string, WorkFile>();

  constructor(files: Iterable<[string, Uint8Array]> = []) {
    this.add(files);
  }

  add(files: Iterable<[string, Uint8Array]>): void {
    for (const [path, bytes] of files) this.files.set(path, { path, original: bytes, bytes, saved: bytes });
  }

  get recordings(): string[] {
    return this.paths.filter((path) => isRecording(path, this.files.get(path)?.original ?? new Uint8Array()));
  }

  get paths(): string[] {
    return [...this.files.keys()].sort();
  }

  /** What is checked: the only file, or everything. */
  get whole(): string {
    const paths = this.paths;
    return paths.length === 1 ? (paths[0] as string) : '.';
  }

  get changed(): WorkFile[] {
    return [...this.files.values()].filter((file) => file.bytes !== file.original);
  }

  isChanged(path: string): boolean {
    return this.changed.some((file) => file.path === path);
  }

  /** Files whose changes would be lost. */
  get unsaved(): WorkFile[] {
    return [...this.files.values()].filter((file) => file.bytes !== file.saved);
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
