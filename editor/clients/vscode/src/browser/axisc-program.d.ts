// build/wasm/bin/axisc.js, as docs/webassembly.md describes it.
import type { Program } from '../../../../../web/interface/axisc.mjs';

export interface Instance extends Program {
  FS: {
    mkdirTree(path: string): void;
    writeFile(path: string, bytes: Uint8Array): void;
    unlink(path: string): void;
    analyzePath(path: string): { exists: boolean };
  };
}
export default function createAxisc(options: { wasmBinary: Uint8Array }): Promise<Instance>;
