// The text of one file with its findings; unedited text keeps its line ends and encoding.
import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { lintGutter, lintKeymap, setDiagnostics, type Diagnostic } from '@codemirror/lint';
import { search, searchKeymap } from '@codemirror/search';
import { EditorState, Text, type ChangeSet } from '@codemirror/state';
import { EditorView, drawSelection, highlightActiveLine, keymap, lineNumbers } from '@codemirror/view';
import { assistance, refreshHints, spanOf } from './assistance';
import { range } from './edits';
import { joined, lines, usualEnd } from './encoding';
import type { Edit, Finding, Place } from './findings';
import { axisList } from './language';
import type { Server, TextEdit } from './server';
import { say } from './texts';

export interface EditorEvents {
  changed: (text: string) => void;
  fix: (finding: Finding) => void;
}

const pause = 250;  // ms without a change before the hints are asked for

interface Opened {
  state: EditorState;
  ends: string[];
}

export class Editor {
  private readonly view: EditorView;
  private ends: string[] = [];
  private isOpening = false;
  private hints = 0;
  private readonly left = new Map<string, Opened>();
  private path = '';

  constructor(
    parent: HTMLElement,
    private readonly events: EditorEvents,
    private readonly server: Server,
  ) {
    this.view = new EditorView({ parent, state: this.state('') });
  }

  private state(text: string): EditorState {
    return EditorState.create({
      doc: text,
      extensions: [
        // A carriage return within a line is a character of it.
        EditorState.lineSeparator.of('\n'),
        EditorView.clipboardInputFilter.of((pasted) => pasted.replace(/\r\n?/g, '\n')),
        lineNumbers(),
        history(),
        drawSelection(),
        highlightActiveLine(),
        search({ top: true }),
        lintGutter(),
        axisList,
        assistance(this.server),
        // Tab leaves the editor: the page is used by keyboard alone.
        keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap, ...lintKeymap]),
        EditorView.contentAttributes.of(() => ({ 'aria-label': say('editor'), spellcheck: 'false', tabindex: '0' })),
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

  /** Shows a file; one that was left comes back with its history, unless its text was changed elsewhere. */
  open(path: string, text: string): void {
    if (this.path !== '') this.left.set(this.path, { state: this.view.state, ends: this.ends });
    this.path = path;
    const before = this.left.get(path);
    const { texts, ends } = lines(text);
    const isSame = before !== undefined && joined([...before.state.doc.iterLines()], before.ends) === text;
    this.ends = isSame ? before.ends : ends;
    this.isOpening = true;
    this.view.setState(isSame ? before.state : this.state(texts.join('\n')));
    this.isOpening = false;
    this.askHints();
  }

  /** No file was opened before. */
  forget(): void {
    this.left.clear();
    this.path = '';
  }

  /** Takes text that changed elsewhere, as one change that can be undone. */
  replace(text: string): void {
    const { texts, ends } = lines(text);
    const [now, wanted] = [this.view.state.doc.toString(), texts.join('\n')];
    let from = 0;
    while (from < Math.min(now.length, wanted.length) && now[from] === wanted[from]) ++from;
    let same = 0;
    while (same < Math.min(now.length, wanted.length) - from && now[now.length - 1 - same] === wanted[wanted.length - 1 - same]) ++same;
    this.isOpening = true;
    this.view.dispatch({ changes: { from, to: now.length - same, insert: wanted.slice(from, wanted.length - same) } });
    this.isOpening = false;
    this.ends = ends;
  }

  text(): string {
    return joined([...this.view.state.doc.iterLines()], this.ends);
  }

  show(findings: readonly Finding[]): void {
    const document = this.view.state.doc;
    const shown = findings
      .filter((finding): finding is Finding & Place => Boolean(finding.line && finding.column))
      .map((finding): Diagnostic => ({
        ...range(document, finding),
        severity: finding.severity === 'note' ? 'info' : finding.severity,
        source: finding.code,
        message: finding.control?.reaction ? `${finding.message}\n${finding.control.reaction}` : finding.message,
        actions: finding.fix ? [{ name: finding.fix.title, apply: () => this.events.fix(finding) }] : [],
      }));
    this.view.dispatch(setDiagnostics(this.view.state, shown));
    this.askHints();
  }

  private askHints(): void {
    clearTimeout(this.hints);
    this.hints = window.setTimeout(() => void refreshHints(this.server, this.view).catch(() => undefined), pause);
  }

  /** The edits of one fix, as one change. */
  apply(edits: readonly Edit[]): void {
    const document = this.view.state.doc;
    this.view.dispatch({ changes: edits.map((edit) => ({ ...range(document, edit), insert: edit.text })) });
    this.view.focus();
  }

  /** Edits of the language server, as one change. */
  change(edits: readonly TextEdit[]): void {
    const document = this.view.state.doc;
    const insert = (text: string): Text => Text.of(text.split(/\r\n?|\n/));
    this.view.dispatch({ changes: edits.map(({ range, newText }) => ({ ...spanOf(document, range), insert: insert(newText) })) });
  }

  focus(): void {
    this.view.focus();
  }

  go(place: Place): void {
    const { from, to } = range(this.view.state.doc, place);
    this.view.dispatch({ selection: { anchor: from, head: to }, effects: EditorView.scrollIntoView(from, { y: 'center' }) });
    this.view.focus();
  }
}
