// An instance of the program's module, with the files of the page, and a workspace of the library in it.
import { Axisc, type Options, type Outcome, type Program as Module } from '../interface/axisc.mjs';
import type { Call, Repair } from './program';

interface Program extends Module {
  FS: {
    mkdirTree(path: string): void;
    readdir(path: string): string[];
    rmdir(path: string): void;
    writeFile(path: string, bytes: Uint8Array): void;
    unlink(path: string): void;
    analyzePath(path: string): { exists: boolean };
    chdir(path: string): void;
  };
}

declare function createAxisc(options: object): Promise<Program>;

export const folder = '/work';
/** Where a file of the page is. */
export const whole = (path: string): string => (path.startsWith('/') ? path : `${folder}/${path}`);
const above = (path: string): string => path.slice(0, path.lastIndexOf('/'));

export class Instance {
  private readonly files = new Map<string, Uint8Array>();
  private opened: { options: string; workspace: Axisc } | null = null;

  private constructor(
    readonly program: Program,
    private readonly memory: WebAssembly.Memory,
  ) {
    program.FS.mkdirTree(folder);
    program.FS.chdir(folder);
  }

  static async create(compiled: WebAssembly.Module): Promise<Instance> {
    let exported: unknown[] = [];
    const program = await createAxisc({
      instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) {
        void WebAssembly.instantiate(compiled, imports).then((instance) => {
          exported = Object.values(instance.exports);
          done(instance);
        });
        return {};
      },
    });
    const memory = exported.find((one): one is WebAssembly.Memory => one instanceof WebAssembly.Memory);
    if (memory === undefined) throw new Error('axisc.wasm');
    return new Instance(program, memory);
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

  /** Another language or cycle time is another workspace. */
  workspace(options: Options): Axisc {
    const wanted = JSON.stringify(options);
    if (this.opened?.options !== wanted) {
      this.opened?.workspace.close();
      this.opened = null;
      const workspace = new Axisc(this.program, options);
      if (workspace.error !== '') throw new Error(workspace.error.trim());
      this.opened = { options: wanted, workspace };
    }
    return this.opened.workspace;
  }

  call(options: Options, call: Call): Outcome<unknown> {
    const workspace = this.workspace(options);
    if (call.name === 'answer') return workspace.answer(call.question);
    if (call.name === 'file') return workspace.file(call.question);
    if (call.name === 'check') return workspace.check(call.path);
    if (call.name === 'compile') return workspace.compile(call.path);
    const { status, result: repaired, error } = workspace.fix(call.path);
    const result: Repair = { changed: repaired.files.map((path) => [path, workspace.read(path)]), fixed: repaired.fixed };
    for (const path of repaired.files) workspace.drop(path);
    return { status, result, error };
  }
}
