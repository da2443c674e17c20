// Files from a drop, a file dialog, or the samples that come with the page.
import { bytesOfPart } from './parts';

export type Incoming = [string, Uint8Array][];

const largest = 256 * 1024 * 1024;

async function bytesOf(file: File): Promise<Uint8Array> {
  return new Uint8Array(await file.arrayBuffer());
}

function entriesIn(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const found: FileSystemEntry[] = [];
  return new Promise((resolve, reject) => {
    const more = (): void =>
      reader.readEntries((entries) => {
        if (entries.length === 0) resolve(found);
        else {
          found.push(...entries);
          more();
        }
      }, reject);
    more();
  });
}

async function collect(entry: FileSystemEntry, into: Incoming): Promise<void> {
  if (entry.isDirectory) {
    for (const inner of await entriesIn(entry as FileSystemDirectoryEntry)) await collect(inner, into);
    return;
  }
  const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
  into.push([entry.fullPath.replace(/^\//, ''), await bytesOf(file)]);
}

function checked(files: Incoming): Incoming {
  const total = files.reduce((sum, [, bytes]) => sum + bytes.length, 0);
  if (total > largest) throw new RangeError(String(Math.round(total / 1024 / 1024)));
  return files;
}

export async function dropped(transfer: DataTransfer): Promise<Incoming> {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry()).filter((entry) => entry !== null);
  // Drags from anywhere but a disk have files without entries.
  if (entries.length === 0) return chosen(transfer.files);
  const files: Incoming = [];
  for (const entry of entries) await collect(entry, files);
  return checked(files);
}

/** The field may be emptied as soon as this returns. */
export async function chosen(list: FileList): Promise<Incoming> {
  const files: Incoming = [];
  for (const file of [...list]) files.push([file.webkitRelativePath || file.name, await bytesOf(file)]);
  return checked(files);
}

/** A sample's files are in one text: names, sizes, then the bytes. */
export async function sample(name: string): Promise<Incoming> {
  const bytes = await bytesOfPart(`samples/${name}.bin`);
  const size = new DataView(bytes.buffer).getUint32(0, true);
  const names = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + size))) as [string, number][];
  let at = 4 + size;
  return names.map(([path, length]) => {
    at += length;
    return [path, bytes.slice(at - length, at)];
  });
}

/** What a scope recorded; a text is one if a line begins with numbers, which no line of a list does. */
export function isRecording(path: string, bytes: Uint8Array): boolean {
  if (/\.(csv|tsv|svdx)$/i.test(path)) return true;
  const begin = new TextDecoder('windows-1252').decode(bytes.subarray(0, 8192)).replaceAll('\0', '');
  return /\.txt$/i.test(path) && /^\s*-?\d[\d.,]*(e[-+]?\d+)?\s*[\t;]\s*-?\d/im.test(begin);
}
