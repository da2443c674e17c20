// The program as WebAssembly, run like the native one: on the files of this computer, from a folder, with its own streams.
import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";

/// Lets an instance see the files of this computer.
export function mountComputer(program) {
  for (const { name } of readdirSync("/", { withFileTypes: true }).filter((entry) => entry.isDirectory())) {
    if (["dev", "proc", "sys"].includes(name)) continue;
    try {
      program.FS.mkdir(`/${name}`);
    } catch {
      // It is there.
    }
    program.FS.mount(program.NODEFS ?? program.FS.filesystems.NODEFS, { root: `/${name}` }, `/${name}`);
  }
}

/// A function (words, {folder, input}) → {status, out, err}, with a new instance for every call.
export function load(script) {
  const create = createRequire(import.meta.url)(script);
  const wasmBinary = readFileSync(join(dirname(script), "axisc.wasm"));
  const compiled = new WebAssembly.Module(wasmBinary);
  return async function run(words, { folder = process.cwd(), input = Buffer.alloc(0) } = {}) {
    const out = [];
    const err = [];
    let read = 0;
    let status = 0;
    const program = await create({
      instantiateWasm(imports, done) {
        done(new WebAssembly.Instance(compiled, imports));
        return {};
      },
      preRun: [
        (module) => {
          module.FS.init(
            () => (read < input.length ? input[read++] : null),
            (byte) => byte !== null && out.push(byte & 255),
            (byte) => byte !== null && err.push(byte & 255),
          );
          for (const name of Object.keys(module.ENV)) delete module.ENV[name];
          Object.assign(module.ENV, { LANG: "C.UTF-8" });
        },
      ],
      onExit: (code) => (status = code),
      quit: (code) => (status = code),
    });
    mountComputer(program);
    program.FS.chdir(folder);
    status = program.callMain(words) ?? status;
    return { status, out: Buffer.from(out), err: Buffer.from(err) };
  };
}

if (process.argv[1] === new URL(import.meta.url).pathname) {
  const [script, ...words] = process.argv.slice(2);
  const { status, out, err } = await load(script)(words);
  process.stdout.write(out);
  process.stderr.write(err);
  process.exitCode = status;
}
