export interface Program {
  lengthBytesUTF8(text: string): number;
  stringToUTF8(text: string, address: number, size: number): void;
  UTF8ToString(address: number): string;
  _malloc(size: number): number;
  _free(address: number): void;
  _axisc_server_begin(words: number): number;
  _axisc_server_take(message: number): number;
}
export function begin(program: Program, words: string[]): boolean;
export function take(program: Program, ...messages: unknown[]): unknown[];
