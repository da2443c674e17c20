// The language server of an instance of the program, for JavaScript.

/** Calls `use` with the address of a text. Texts of any length: the stack of the program, which `ccall` takes, is small. */
function withText(program, text, use) {
  const size = program.lengthBytesUTF8(text) + 1;
  const address = program._malloc(size);
  try {
    program.stringToUTF8(text, address, size);
    return use(address);
  } finally {
    program._free(address);
  }
}

/** Begins a server with the arguments of `axisc lsp`; false where they are wrong, which `printErr` was told. */
export function begin(program, words) {
  return withText(program, JSON.stringify(words), (address) => program._axisc_server_begin(address)) === 0;
}

/** The messages that the server sends because of messages that arrived together: requests that later ones cancel are refused. */
export function take(program, ...messages) {
  return withText(program, JSON.stringify(messages.map((message) => JSON.stringify(message))), (address) => JSON.parse(program.UTF8ToString(program._axisc_server_take(address))));
}
