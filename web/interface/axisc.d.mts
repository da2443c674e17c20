/** What of an instance of build/wasm/bin/axisc.js the interface uses. */
export interface Program {
  lengthBytesUTF8(text: string): number;
  stringToUTF8(text: string, address: number, size: number): void;
  UTF8ToString(address: number): string;
  HEAPU8: Uint8Array;
  HEAPU32: Uint32Array;
  _malloc(size: number): number;
  _free(address: number): void;
}
export interface Options {
  language?: 'en' | 'de';
  /** Where no file says one: "2ms". */
  cycle_time?: string;
  /** Whatever files say, as options of `axisc lint`. */
  override_cycle_time?: string;
  axis_type?: string;
  kind?: string;
  build?: string;
}
export interface Outcome<Result> {
  /** 0; 1 where lists have errors; 2 where the question cannot be answered. */
  status: number;
  result: Result;
  /** For people: why the status is not 0; never empty where it is 2. */
  error: string;
}
export class Axisc {
  constructor(program: Program, options?: Options);
  /** Why the workspace does not work: empty where it does. */
  readonly error: string;
  close(): void;
  put(path: string, bytes: Uint8Array): void;
  drop(path: string): void;
  read(path: string): Uint8Array;
  check(path: string): Outcome<string>;
  /** The paths of what changed, whose bytes are unsaved text, and how many findings were repaired. */
  fix(path: string): Outcome<{ files: string[]; fixed: number }>;
  compile(path: string): Outcome<Uint8Array>;
  answer(question: Record<string, string | undefined>): Outcome<string>;
  /** An answer that is not text: an FMU. */
  file(question: Record<string, string | undefined>): Outcome<Uint8Array>;
  /** The messages that the language server sends because of messages that arrived together. */
  message(...messages: unknown[]): unknown[];
}
