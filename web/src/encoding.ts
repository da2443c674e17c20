// Lists are UTF-8 or windows-1252; unedited text keeps its bytes, its line ends included.
export type Encoding = 'utf-8' | 'windows-1252';

export interface Decoded {
  text: string;
  encoding: Encoding;
  mark: boolean;
}

const mark = [0xef, 0xbb, 0xbf];
const table = new Map(
  [...new TextDecoder('windows-1252').decode(Uint8Array.from({ length: 256 }, (_, byte) => byte))].map((character, byte) => [character, byte]),
);

export function decode(bytes: Uint8Array): Decoded {
  const marked = mark.every((byte, i) => bytes[i] === byte);
  const content = marked ? bytes.subarray(3) : bytes;
  try {
    const text = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(content);
    return { text, encoding: 'utf-8', mark: marked };
  } catch {
    return { text: new TextDecoder('windows-1252').decode(content), encoding: 'windows-1252', mark: marked };
  }
}

/** In windows-1252 unless it lacks one of the characters: then the whole text becomes UTF-8. */
export function encode({ text, encoding, mark: marked }: Decoded): Uint8Array {
  const single = encoding === 'windows-1252' ? [...text].map((character) => table.get(character)) : [undefined];
  const bytes = single.includes(undefined) ? new TextEncoder().encode(text) : Uint8Array.from(single as number[]);
  return marked ? Uint8Array.from([...mark, ...bytes]) : bytes;
}

/**
 * Lines without their ends (LF or CRLF, as the program counts them), and the ends; the last line has none.
 */
export function lines(text: string): { texts: string[]; ends: string[] } {
  const parts = text.split(/(\r?\n)/);
  return { texts: parts.filter((_, i) => i % 2 === 0), ends: parts.filter((_, i) => i % 2 === 1) };
}

export function joined(texts: readonly string[], ends: readonly string[]): string {
  return texts.map((text, i) => text + (ends[i] ?? '')).join('');
}

/** The end that most lines have. */
export function usualEnd(ends: readonly string[]): string {
  const windows = ends.filter((end) => end === '\r\n').length;
  return windows * 2 > ends.length ? '\r\n' : '\n';
}

/** Binary files are shown as such. */
export function isBinary(bytes: Uint8Array): boolean {
  return bytes.subarray(0, 8192).includes(0);
}
