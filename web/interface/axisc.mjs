// axisc.h for JavaScript: a workspace of an instance of the program.

const bytesOf = (program, address) => {
  const [data, size] = program.HEAPU32.subarray(address >> 2, (address >> 2) + 2);
  return program.HEAPU8.slice(data, data + size);
};
const safe = 0;  // AXISC_FIX_SAFE
const [noOptions, noFindings] = [0, 0];
const failed = 2;  // as exit status
/** What axisc_error() has no words for. */
const outOfMemory = 'axisc: out of memory';
const noMemory = -6;  // AXISC_NO_MEMORY
const textOf = (bytes) => new TextDecoder().decode(bytes);

function allocate(program, size) {
  const address = program._malloc(size);
  if (address === 0) throw new Error(outOfMemory);
  return address;
}

/** Calls `use` with the addresses of texts. Texts of any length: the stack of the program is small. */
function withTexts(program, texts, use) {
  const addresses = texts.map((text) => {
    const size = program.lengthBytesUTF8(text) + 1;
    const address = allocate(program, size);
    program.stringToUTF8(text, address, size);
    return address;
  });
  try {
    return use(...addresses);
  } finally {
    for (const address of addresses) program._free(address);
  }
}

/** Calls `use` with the address of a result, two words that the program fills; its status and bytes. */
function withResult(program, use) {
  const address = allocate(program, 8);
  program.HEAPU32.fill(0, address >> 2, (address >> 2) + 2);
  try {
    return { status: use(address), bytes: bytesOf(program, address) };
  } finally {
    program._axisc_free(address);
    program._free(address);
  }
}

export class Axisc {
  #program;
  #workspace = 0;

  constructor(program, options = {}) {
    this.#program = program;
    const opened = allocate(program, 4);
    const status = withTexts(program, [JSON.stringify(options)], (text) => program._axisc_open(text, 0, opened));
    this.#workspace = program.HEAPU32[opened >> 2];
    program._free(opened);
    this.error = this.#error(status);
    if (status !== 0) this.close();
  }

  close() {
    if (this.#workspace !== 0) this.#program._axisc_close(this.#workspace);
    this.#workspace = 0;
  }

  put(path, bytes) {
    const program = this.#program;
    const address = allocate(program, bytes.length + 1);
    program.HEAPU8.set(bytes, address);
    const status = withTexts(program, [path], (name) => program._axisc_put(this.#workspace, name, address, bytes.length));
    program._free(address);
    this.#require(status);
  }

  drop(path) {
    this.#require(withTexts(this.#program, [path], (name) => this.#program._axisc_drop(this.#workspace, name)));
  }

  read(path) {
    const { status, result, error } = this.#call('read', path, (bytes) => bytes);
    if (status !== 0) throw new Error(error);
    return result;
  }

  check(path) {
    return this.#call('check', path, textOf);
  }

  fix(path) {
    const nothing = { files: [], fixed: 0 };
    return this.#call('fix', path, (bytes) => (bytes.length === 0 ? nothing : JSON.parse(textOf(bytes))), [safe]);
  }

  compile(path) {
    return this.#call('compile', path, (bytes) => bytes, [noOptions], [noFindings]);
  }

  answer(question) {
    return this.#call('answer', JSON.stringify(question), textOf);
  }

  /** An answer that is not text. */
  file(question) {
    return this.#call('answer', JSON.stringify(question), (bytes) => bytes);
  }

  message(...messages) {
    if (this.#workspace === 0) return [];
    const { result, error } = this.#call('message', JSON.stringify(messages.map((message) => JSON.stringify(message))), textOf);
    if (error !== '') throw new Error(error);
    return JSON.parse(result);
  }

  /** `before` and `after`: what some functions take beside the text and the address of the result. */
  #call(name, text, take, before = [], after = []) {
    const program = this.#program;
    const { status, bytes } = withTexts(program, [text], (address) => withResult(program, (result) => program[`_axisc_${name}`](this.#workspace, address, ...before, result, ...after)));
    return { status: status < 0 ? failed : status, result: take(bytes), error: this.#error(status) };
  }

  #require(status) {
    if (status !== 0) throw new Error(this.#error(status));
  }

  /** Why the result is what it is: empty for 0 alone, and for errors in lists that are in the result. */
  #error(status) {
    if (status === 0) return '';
    const said = this.#program.UTF8ToString(this.#program._axisc_error(this.#workspace));
    if (said !== '' || status > 0) return said;
    return status === noMemory ? outOfMemory : `axisc: result ${status}`;
  }
}
