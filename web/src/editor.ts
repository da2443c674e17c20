// The text of one file with its findings; line ends and encoding of what is not edited stay.
import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { lintGutter, lintKeymap, setDiagnostics, type Diagnostic } from '@codemirror/lint';
import { search, searchKeymap } from '@codemirror/search';
import { EditorState, type ChangeSet, type Text } from '@codemirror/state';
import { EditorView, drawSelection, highlightActiveLine, hoverTooltip, keymap, lineNumbers } from '@codemirror/view';
import { element } from './elements';
import { joined, lines, usualEnd } from './encoding';
import type { Edit, Finding, Place } from './findings';
import { axisList } from './language';
import { say } from './texts';

export interface EditorEvents {
  changed: (text: string) => void;
  fix: (finding: Finding) => void;
  meaning: (parameter: string) => Promise<string>;
}

/** Columns of findings count code points from 1. */
function offset(document: Text, line: number, column: number): number {
  if (line < 1 || line > document.lines) return line < 1 ? 0 : document.length;
  const found = document.line(line);
  const before = [...found.text].slice(0, Math.max(0, column - 1)).join('');
  return found.from + Math.min(before.length, found.length);
}

function range(document: Text, place: Place): { from: number; to: number } {
  const from = offset(document, place.line, place.column);
  return { from, to: Math.max(from, offset(document, place.end_line, place.end_column)) };
}

export class Editor {
  private readonly view: EditorView;
  private ends: string[] = [];
  private isOpening = false;

  constructor(
    parent: HTMLElement,
    private readonly events: EditorEvents,
  ) {
    this.view = new EditorView({ parent, state: this.state('') });
  }

  private state(text: string): EditorState {
    return EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(),
        history(),
        drawSelection(),
        highlightActiveLine(),
        search({ top: true }),
        lintGutter(),
        axisList,
        // Tab leaves the editor: the page is used by keyboard alone.
        keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap, ...lintKeymap]),
        hoverTooltip((view, at) => this.hover(view, at)),
        EditorView.contentAttributes.of({ 'aria-label': say('editor'), spellcheck: 'false' }),
        EditorView.updateListener.of((update) => {
          if (!update.docChanged || this.isOpening) return;
          this.follow(update.startState.doc, update.changes);
          this.events.changed(this.text());
        }),
      ],
    });
  }

  private follow(old: Text, changes: ChangeSet): void {
    const end = usualEnd(this.ends);
    const spans: [number, number, number][] = [];
    changes.iterChanges((fromA, toA, _fromB, _toB, inserted) => {
      const first = old.lineAt(fromA).number;
      spans.push([first - 1, old.lineAt(toA).number - first, inserted.lines - 1]);
    });
    for (const [at, removed, added] of spans.reverse()) this.ends.splice(at, removed, ...Array<string>(added).fill(end));
  }

  private async hover(view: EditorView, at: number) {
    const line = view.state.doc.lineAt(at);
    const name = /^\s*([A-Za-z_][\w.[\]]*)/.exec(line.text);
    if (!name?.[1]) return null;
    const from = line.from + name[0].length - name[1].length;
    if (at < from || at > from + name[1].length) return null;
    const text = await this.events.meaning(name[1]);
    if (text === '') return null;
    return { pos: from, end: from + name[1].length, above: true, create: () => ({ dom: element('pre', { class: 'meaning' }, text) }) };
  }

  open(text: string): void {
    const { texts, ends } = lines(text);
    this.ends = ends;
    this.isOpening = true;
    this.view.setState(this.state(texts.join('\n')));
    this.isOpening = false;
  }

  /** Takes text that changed elsewhere, as one change that can be undone. */
  replace(text: string): void {
    const { texts, ends } = lines(text);
    this.isOpening = true;
    this.view.dispatch({ changes: { from: 0, to: this.view.state.doc.length, insert: texts.join('\n') } });
    this.isOpening = false;
    this.ends = ends;
  }

  text(): string {
    return joined([...this.view.state.doc.iterLines()], this.ends);
  }

  show(findings: readonly Finding[]): void {
    const document = this.view.state.doc;
    const shown = findings
      .filter((finding): finding is Finding & Place => (finding.line ?? 0) > 0)
      .map((finding): Diagnostic => ({
        ...range(document, finding),
        severity: finding.severity === 'note' ? 'info' : finding.severity,
        source: finding.code,
        message: finding.control?.reaction ? `${finding.message}\n${finding.control.reaction}` : finding.message,
        actions: finding.fix ? [{ name: finding.fix.title, apply: () => this.events.fix(finding) }] : [],
      }));
    this.view.dispatch(setDiagnostics(this.view.state, shown));
  }

  /** The edits of one fix, as one change. */
  apply(edits: readonly Edit[]): void {
    const document = this.view.state.doc;
    this.view.dispatch({ changes: edits.map((edit) => ({ ...range(document, edit), insert: edit.text })) });
    this.view.focus();
  }

  go(place: Place): void {
    const { from, to } = range(this.view.state.doc, place);
    this.view.dispatch({ selection: { anchor: from, head: to }, effects: EditorView.scrollIntoView(from, { y: 'center' }) });
    this.view.focus();
  }
}
