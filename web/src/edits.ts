// Places of findings in a text, and edits at them. Lines and columns count from 1, columns in code points.
import { Text } from '@codemirror/state';
import { joined, lines } from './encoding';
import type { Edit, Place } from './findings';

function offset(document: Text, line: number, column: number): number {
  if (line < 1 || line > document.lines) return line < 1 ? 0 : document.length;
  const found = document.line(line);
  const before = [...found.text].slice(0, Math.max(0, column - 1)).join('');
  return found.from + Math.min(before.length, found.length);
}

export function range(document: Text, place: Place): { from: number; to: number } {
  const from = offset(document, place.line, place.column);
  return { from, to: Math.max(from, offset(document, place.end_line, place.end_column)) };
}

/** The text of a file that no editor shows, with the edits. Edits of fixes keep their lines. */
export function edited(text: string, edits: readonly Edit[]): string {
  const { texts, ends } = lines(text);
  const document = Text.of(texts);
  const spans = edits.map((edit) => ({ ...range(document, edit), text: edit.text })).sort((a, b) => b.from - a.from);
  const changed = spans.reduce((now, { from, to, text: insert }) => now.replace(from, to, Text.of(insert.split('\n'))), document);
  if (changed.lines === document.lines) return joined([...changed.iterLines()], ends);
  return changed.toString();
}
