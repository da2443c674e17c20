// The interface to axisc.h without the program: what it makes of results that have no words.
import assert from 'node:assert/strict';
import test from 'node:test';
import { Axisc } from '../../web/interface/axisc.mjs';

/** A program whose functions return `result` and say nothing. */
function silent(result, { memory = 1 << 16, opens = 0 } = {}) {
  const bytes = new ArrayBuffer(1 << 16);
  let next = 8;
  const workspace = 4;
  const words = new Uint32Array(bytes);
  return {
    HEAPU8: new Uint8Array(bytes),
    HEAPU32: words,
    lengthBytesUTF8: (text) => text.length,
    stringToUTF8: () => undefined,
    UTF8ToString: () => '',
    _malloc: (size) => (next + size > memory ? 0 : (next += size + 8) & ~7),
    _free: () => undefined,
    _axisc_open: (_options, _files, opened) => ((words[opened >> 2] = opens === 0 ? workspace : 0), opens),
    _axisc_close: () => undefined,
    _axisc_free: () => undefined,
    _axisc_error: () => 0,
    _axisc_check: () => result,
    _axisc_fix: () => result,
    _axisc_put: () => result,
    _axisc_read: () => result,
  };
}

test('a result below 0 always has a reason', () => {
  for (const result of [-1, -5, -6, -7]) {
    const workspace = new Axisc(silent(result));
    for (const { status, error } of [workspace.check('x.lis'), workspace.fix('x.lis')]) {
      assert.equal(status, 2);
      assert.notEqual(error, '');
    }
    assert.throws(() => workspace.put('x.lis', new Uint8Array(3)), /axisc/);
    assert.throws(() => workspace.read('x.lis'), /axisc/);
  }
  assert.match(new Axisc(silent(-6)).check('x.lis').error, /memory/);
});

test('a workspace that could not be opened says so', () => {
  assert.match(new Axisc(silent(0, { opens: -6 })).error, /memory/);
  assert.equal(new Axisc(silent(0)).error, '');
});

test('without memory nothing is written to address 0', () => {
  assert.throws(() => new Axisc(silent(0, { memory: 0 })), /memory/);
});
