// Colours of lists: names, numbers, words, comments. Validation is left to axisc.
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from '@codemirror/language';
import { tags } from '@lezer/highlight';

interface State {
  begins: boolean;
  /** After a number the control ignores the rest of the line. */
  ends: boolean;
}

const list = StreamLanguage.define<State>({
  name: 'axis-list',
  startState: () => ({ begins: true, ends: false }),
  token(stream, state) {
    if (stream.sol()) [state.begins, state.ends] = [true, false];
    if (stream.eatSpace()) return null;
    const rest = stream.string.slice(stream.pos);
    if (state.ends || /^(#|\/\/|;)/.test(rest) || (rest.startsWith('(') && !state.begins)) {
      stream.skipToEnd();
      return 'comment';
    }
    if (state.begins) {
      state.begins = false;
      return stream.match(/^[\w.[\]$]+/) ? 'propertyName' : (stream.next(), null);
    }
    if (stream.match(/^[-+]?(0x[\da-f]+|\d+\.?\d*(e[-+]?\d+)?|\.\d+)(?=\s|$|[(#])/i)) {
      state.ends = true;
      return 'number';
    }
    if (stream.match(/^[\w.|"*/\\:-]+/)) return 'atom';
    stream.next();
    return null;
  },
});

const colours = HighlightStyle.define([
  { tag: tags.propertyName, class: 'list-name' },
  { tag: tags.number, class: 'list-number' },
  { tag: tags.atom, class: 'list-word' },
  { tag: tags.comment, class: 'list-comment' },
]);

export const axisList = [list, syntaxHighlighting(colours)];
