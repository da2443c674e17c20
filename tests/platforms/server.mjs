// The language server in WebAssembly beside the native one: over every list of the samples, the same answers and the same diagnostics.
//   node server.mjs NATIVE AXISC.JS SAMPLES
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { pathToFileURL } from "node:url";
import { Axisc } from "../../web/interface/axisc.mjs";
import { below } from "./below.mjs";
import { mountComputer } from "./webassembly.mjs";

const [native, script, samples] = process.argv.slice(2);
const words = ["--lang", "de"];

/// What an editor says about one list: it asks at every fifth line, types a mistake, and closes the list.
function conversation(path) {
  const uri = pathToFileURL(path).href;
  const text = new TextDecoder("windows-1252").decode(readFileSync(path));
  const textDocument = { uri };
  const messages = [];
  const tell = (method, params) => messages.push({ jsonrpc: "2.0", method, params });
  const ask = (method, params) => messages.push({ jsonrpc: "2.0", id: messages.length, method, params });
  ask("initialize", { processId: null, rootUri: pathToFileURL(samples).href, capabilities: {} });
  tell("initialized", {});
  tell("textDocument/didOpen", { textDocument: { uri, languageId: "axis-list", version: 1, text } });
  const lines = text.split("\n");
  for (let line = 0; line < Math.min(lines.length, 200); line += 5) {
    const position = { line, character: Math.min(4, lines[line].length) };
    for (const method of ["hover", "completion", "definition"]) ask(`textDocument/${method}`, { textDocument, position });
  }
  for (const method of ["documentSymbol", "foldingRange", "codeLens", "semanticTokens/full", "documentLink", "diagnostic"]) {
    ask(`textDocument/${method}`, { textDocument });
  }
  ask("textDocument/formatting", { textDocument, options: { tabSize: 2, insertSpaces: true } });
  const range = { start: { line: 0, character: 0 }, end: { line: lines.length - 1, character: 0 } };
  ask("textDocument/inlayHint", { textDocument, range });
  ask("textDocument/codeAction", { textDocument, range, context: { diagnostics: [] } });
  tell("textDocument/didChange", {
    textDocument: { uri, version: 2 },
    contentChanges: [{ range: { start: range.start, end: range.start }, text: "filter[0].guete -3,5x\n" }],
  });
  ask("no/such", {});
  tell("textDocument/didClose", { textDocument });
  ask("shutdown");
  tell("exit");
  return messages;
}

/// What a server sends, in two sequences: whether diagnostics come before or after an answer depends on how messages arrive.
const sequences = (sent) => ({ answers: sent.filter(({ id }) => id !== undefined), told: sent.filter(({ id }) => id === undefined) });

/// Waits for the answer to each request before it goes on.
async function ofNative(messages) {
  const server = spawn(native, ["lsp", ...words], { stdio: ["pipe", "pipe", "inherit"] });
  const sent = [];
  let rest = Buffer.alloc(0);
  let arrived = () => {};
  server.stdout.on("data", (bytes) => {
    rest = Buffer.concat([rest, bytes]);
    for (let body; (body = rest.indexOf("\r\n\r\n") + 4) > 3; ) {
      const end = body + Number(/Content-Length: (\d+)/.exec(rest.toString("latin1", 0, body))[1]);
      if (rest.length < end) return;
      sent.push(JSON.parse(rest.toString("utf8", body, end)));
      rest = rest.subarray(end);
      arrived();
    }
  });
  for (const message of messages) {
    const text = JSON.stringify(message);
    server.stdin.write(`Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`);
    while (message.id !== undefined && sent.every(({ id }) => id !== message.id)) await new Promise((wake) => (arrived = wake));
  }
  const [status] = await once(server, "close");
  assert.equal(status, 0);
  return sequences(sent);
}

const wasmBinary = readFileSync(join(dirname(script), "axisc.wasm"));
const program = await createRequire(import.meta.url)(script)({ wasmBinary });
mountComputer(program);

function ofWebAssembly(messages) {
  const workspace = new Axisc(program, { language: "de" });
  const sent = messages.flatMap((message) => workspace.message(message));
  workspace.close();
  return sequences(sent);
}

const refused = new Axisc(program, { cycle_time: "soon" });
assert.match(refused.error, /^axisc: error.*soon/);
assert.deepEqual(refused.message({ jsonrpc: "2.0", id: 1, method: "initialize", params: {} }), [], "it is closed");

// Messages that arrived together.
const opened = new Axisc(program);
const take = (...messages) => opened.message(...messages);
take({ jsonrpc: "2.0", id: 1, method: "initialize", params: { capabilities: {} } });
const symbols = (id) => ({ jsonrpc: "2.0", id, method: "workspace/symbol", params: { query: "" } });
const together = take(symbols(2), symbols(3), { jsonrpc: "2.0", method: "$/cancelRequest", params: { id: 2 } });
assert.deepEqual(together.map(({ id, error }) => [id, error?.code]), [[2, -32800], [3, undefined]]);
assert.equal(take({ jsonrpc: "2.0", id: "\ud800", method: "no/such" })[0].error.code, -32700, "half a character");

const lists = [...below(samples)].filter((path) => /\.lis$/i.test(path));
let [answers, diagnostics] = [0, 0];
for (const list of lists) {
  const messages = conversation(list);
  const wanted = await ofNative(messages);
  assert.deepEqual(ofWebAssembly(messages), wanted, list);
  answers += wanted.answers.length;
  diagnostics += wanted.told.flatMap(({ params }) => params.diagnostics ?? []).length;
}
assert.ok(lists.length > 50 && diagnostics > 150, `${lists.length} lists, ${diagnostics} diagnostics`);
console.log(`the server: ${lists.length} lists, ${answers} answers and ${diagnostics} diagnostics are those of the native one`);
