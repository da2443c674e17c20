// The program for another system beside the native one, on every sample: findings, fixes, texts and images byte by byte, figures of
// the mathematical functions, which libraries round differently, as numbers.
//   node compare.mjs NATIVE PROGRAM SAMPLES LEAST
// PROGRAM is axisc.js of the WebAssembly, or axisc.exe, which wine runs; fewer outputs than LEAST are a failure, for then samples were
// not found.
import { spawnSync } from "node:child_process";
import { readdirSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { below } from "./below.mjs";
import { load } from "./webassembly.mjs";
import { equalAsNumbers } from "./equal_as_numbers.mjs";

const [native, program, samples, least] = process.argv.slice(2);
const run = program.endsWith(".exe") ? underWine : load(program);

function underWine(words, { folder }) {
  const env = { ...process.env, LANG: "C.UTF-8", WINEDEBUG: "-all" };
  const { status, stdout, stderr } = spawnSync("wine64", [program, ...words], { cwd: folder, env, maxBuffer: 1 << 28 });
  return { status, out: stdout, err: stderr };
}

const paths = [...below(samples)];
const isFolder = (path) => statSync(path).isDirectory();
const isMachine = (path) =>
  path.endsWith("machine.json") || (isFolder(path) && readdirSync(path).some((name) => /^hochlauf|\.tsproj$/.test(name)));
const ofAxis = (path) => path.endsWith(".lis") && /kenngr\.|filter/.test(readFileSync(path, "latin1"));

const exact = [["--help"], ["explain", "AX3004"], ["explain", "filter[0].fg_f0", "--lang", "de"], ["schema", "machine"]];
const asNumbers = [];
for (const path of paths) {
  const cycle = path.endsWith(".lis") ? ["--cycle-time", "1ms"] : [];
  for (const format of ["text", "json", "sarif"]) exact.push(["lint", ...cycle, "--format", format, path]);
  exact.push(["lint", ...cycle, "--lang", "de", path]);
  if (path.endsWith(".lis")) exact.push(["fmt", "--diff", path]);
  if (isMachine(path) || ofAxis(path)) {
    exact.push(["compile", "--quiet", ...cycle, path, "-o", "-"]);
    asNumbers.push([1, ["plot", ...cycle, path, "-o", "-"]]);
  }
  if (isMachine(path)) {
    exact.push(["machine", path]);
    asNumbers.push([0, ["contour", "--format", "json", path]], [1, ["report", path, "-o", "-"]]);
  }
}

let failed = 0;
let figures = 0;
async function compare(words, rounding) {
  const wanted = spawnSync(native, words, { cwd: samples, env: { LANG: "C.UTF-8" }, maxBuffer: 1 << 28 });
  let got;
  const differs = async () => {
    got = await run(words, { folder: samples });
    const same =
      rounding === undefined ? wanted.stdout.equals(got.out) : equalAsNumbers(wanted.stdout.toString(), got.out.toString(), rounding);
    return !same || !wanted.stderr.equals(got.err) || wanted.status !== got.status;
  };
  // Wine fails to start or to end one program in some ten thousand, even one that only prints a line.
  if ((await differs()) && (run !== underWine || (await differs()))) {
    failed += 1;
    console.error(`differs: axisc ${words.join(" ")} (${wanted.status}, ${got.status})\n${got.err.toString().slice(0, 400)}`);
  } else {
    figures += rounding !== undefined && !wanted.stdout.equals(got.out);
  }
}

for (const words of exact) await compare(words);
for (const [rounding, words] of asNumbers) await compare(words, rounding);
console.log(`${exact.length} outputs compared byte by byte, ${asNumbers.length} as numbers (${figures} of them differ in digits), ${failed} differ`);
process.exitCode = failed === 0 && exact.length >= Number(least) ? 0 : 1;
