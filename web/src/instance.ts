// An instance of the program's module, with streams of its own and the files of the page. It runs one command
// after the other.
import type { Program as Module } from '../../cli/browser/server.mjs';
import { Stream } from './stream';

interface Program extends Module {
  FS: {
    init(input: () => number | null, output: (byte: number | null) => void, error: (byte: number | null) => void): void;
    mkdirTree(path: string): void;
    readdir(path: string): string[];
    rmdir(path: string): void;
    writeFile(path: string, bytes: Uint8Array): void;
    readFile(path: string): Uint8Array;
    unlink(path: string): void;
    analyzePath(path: string): { exists: boolean };
    chdir(path: string): void;
  };
  ENV: Record<string, string>;
  callMain(words: string[]): number | undefined;
  stackSave(): number;
  stackRestore(top: number): void;
}

declare function createAxisc(options: object): Promise<Program>;

interface Streams {
  out: Stream;
  err: Stream;
  status: number;
}

export const folder = '/work';
/** Where a file of the page is. */
export const whole = (path: string): string => (path.startsWith('/') ? path : `${folder}/${path}`);
const above = (path: string): string => path.slice(0, path.lastIndexOf('/'));

export class Instance {
  private readonly files = new Map<string, Uint8Array>();

  private constructor(
    readonly program: Program,
    private readonly streams: Streams,
    private readonly memory: WebAssembly.Memory,
  ) {
    program.FS.mkdirTree(folder);
    program.FS.chdir(folder);
  }

  static async create(compiled: WebAssembly.Module): Promise<Instance> {
    const streams = { out: new Stream(), err: new Stream(), status: 0 };
    const leave = (code: number): void => void (streams.status = code);
    let exported: unknown[] = [];
    const program = await createAxisc({
      instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) {
        void WebAssembly.instantiate(compiled, imports).then((instance) => {
          exported = Object.values(instance.exports);
          done(instance);
        });
        return {};
      },
      preRun: [
        (module: Program) => {
          module.FS.init(() => null, (byte) => streams.out.write(byte), (byte) => streams.err.write(byte));
          for (const name of Object.keys(module.ENV)) delete module.ENV[name];
          Object.assign(module.ENV, { LANG: 'C.UTF-8', NO_COLOR: '1' });
        },
      ],
      onExit: leave,
      quit: leave,
    });
    const memory = exported.find((one): one is WebAssembly.Memory => one instanceof WebAssembly.Memory);
    if (memory === undefined) throw new Error('axisc.wasm');
    return new Instance(program, streams, memory);
  }

  /** Bytes that it occupies; they never become fewer. */
  get size(): number {
    return this.memory.buffer.byteLength;
  }

  /** Replaces its files by those of the page; returns the paths of those that differed. */
  update(files: ReadonlyMap<string, Uint8Array>): string[] {
    const gone = [...this.files.keys()].filter((path) => !files.has(path));
    const changed = [...files].filter(([path, bytes]) => this.files.get(path) !== bytes);
    for (const path of gone) this.remove(path);
    for (const [path, bytes] of changed) {
      this.program.FS.mkdirTree(above(whole(path)));
      this.program.FS.writeFile(whole(path), bytes);
      this.files.set(path, bytes);
    }
    return [...gone, ...changed.map(([path]) => path)];
  }

  /** A file, and the folders that are empty without it. */
  private remove(path: string): void {
    const { FS } = this.program;
    this.files.delete(path);
    if (FS.analyzePath(whole(path)).exists) FS.unlink(whole(path));
    const isEmpty = (one: string): boolean => FS.readdir(one).every((name) => name === '.' || name === '..');
    for (let parent = above(whole(path)); parent !== '' && parent !== folder && isEmpty(parent); parent = above(parent)) FS.rmdir(parent);
  }

  /** Runs a command. Files that it writes to the `wanted` paths are taken out of the file system. */
  run(words: string[], wanted: string[]) {
    const { program, streams } = this;
    Object.assign(streams, { out: new Stream(), err: new Stream(), status: 0 });
    // callMain() leaves the arguments on the stack.
    const top = program.stackSave();
    const status = program.callMain(words) ?? streams.status;
    program.stackRestore(top);
    const written: [string, Uint8Array][] = [];
    for (const path of wanted) {
      if (!program.FS.analyzePath(whole(path)).exists) continue;
      written.push([path, program.FS.readFile(whole(path))]);
      this.remove(path);
    }
    return { status, out: streams.out.written(), err: streams.err.written(), written };
  }

  /** The output on standard error since the last run began. */
  get complaint(): string {
    return new TextDecoder().decode(this.streams.err.written());
  }
}
