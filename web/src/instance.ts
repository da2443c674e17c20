// An instance of the program's module: as a process, with streams and files of its own.
export interface Program {
  FS: {
    init(input: () => number | null, output: (byte: number | null) => void, error: (byte: number | null) => void): void;
    mkdirTree(path: string): void;
    writeFile(path: string, bytes: Uint8Array): void;
    readFile(path: string): Uint8Array;
    analyzePath(path: string): { exists: boolean };
    chdir(path: string): void;
  };
  ENV: Record<string, string>;
  callMain(words: string[]): number | undefined;
}

declare function createAxisc(options: object): Promise<Program>;

/** Bytes to read, or to be written. */
export class Stream {
  private position = 0;
  private size: number;

  constructor(private bytes: Uint8Array = new Uint8Array(4096)) {
    this.size = bytes.length;
  }

  static empty(): Stream {
    const stream = new Stream();
    stream.size = 0;
    return stream;
  }

  read(): number | null {
    return this.position < this.size ? (this.bytes[this.position++] as number) : null;
  }

  write(byte: number | null): void {
    if (byte === null) return;
    if (this.size === this.bytes.length) {
      const longer = new Uint8Array(2 * this.size);
      longer.set(this.bytes);
      this.bytes = longer;
    }
    this.bytes[this.size++] = byte;
  }

  written(): Uint8Array {
    return this.bytes.slice(0, this.size);
  }
}

export interface Instance {
  program: Program;
  streams: { in: Stream; out: Stream; err: Stream; status: number };
}

export async function create(compiled: WebAssembly.Module): Promise<Instance> {
  const streams = { in: Stream.empty(), out: Stream.empty(), err: Stream.empty(), status: 0 };
  const leave = (code: number): void => void (streams.status = code);
  const program = await createAxisc({
    instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) {
      void WebAssembly.instantiate(compiled, imports).then(done);
      return {};
    },
    preRun: [
      (module: Program) => {
        module.FS.init(() => streams.in.read(), (byte) => streams.out.write(byte), (byte) => streams.err.write(byte));
        for (const name of Object.keys(module.ENV)) delete module.ENV[name];
        Object.assign(module.ENV, { LANG: 'C.UTF-8', NO_COLOR: '1' });
      },
    ],
    onExit: leave,
    quit: leave,
  });
  return { program, streams };
}
