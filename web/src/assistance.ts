// The language server in the editor: meaning under the pointer, completion, quantities after raw numbers.
import { autocompletion, completionKeymap, type Completion, type CompletionContext, type CompletionResult } from '@codemirror/autocomplete';
import { StateEffect, StateField, type Extension, type Text } from '@codemirror/state';
import { Decoration, EditorView, WidgetType, hoverTooltip, keymap, type DecorationSet } from '@codemirror/view';
import { element } from './elements';
import { markdown } from './markdown';
import type { Hint, Position, Proposal, Range, Server } from './server';

// Kinds of the protocol, as the editor's names.
const kinds: Record<number, string> = { 9: 'namespace', 10: 'property', 12: 'constant', 14: 'keyword', 18: 'variable', 20: 'enum' };

function positionAt(document: Text, offset: number): Position {
  const line = document.lineAt(offset);
  return { line: line.number - 1, character: offset - line.from };
}

function offsetOf(document: Text, { line, character }: Position): number {
  if (line >= document.lines) return document.length;
  const found = document.line(line + 1);
  return Math.min(found.to, found.from + character);
}

export function spanOf(document: Text, range: Range): { from: number; to: number } {
  return { from: offsetOf(document, range.start), to: offsetOf(document, range.end) };
}

function option(proposal: Proposal): Completion {
  const about = typeof proposal.documentation === 'string' ? proposal.documentation : proposal.documentation?.value;
  return {
    label: proposal.label,
    type: kinds[proposal.kind ?? 0] ?? 'text',
    apply: proposal.textEdit?.newText ?? proposal.label,
    ...(proposal.detail ? { detail: proposal.detail } : {}),
    ...(proposal.preselect ? { boost: 1 } : {}),
    ...(about ? { info: () => markdown(about) } : {}),
  };
}

async function proposals(server: Server, context: CompletionContext): Promise<CompletionResult | null> {
  const document = context.state.doc;
  const before = context.state.sliceDoc(document.lineAt(context.pos).from, context.pos);
  if (!context.explicit && !/[\w.[#-]$/.test(before)) return null;
  const items = await server.complete(positionAt(document, context.pos));
  const first = items.find((item) => item.textEdit)?.textEdit;
  if (context.aborted || !first) return null;
  return { from: offsetOf(document, first.range.start), options: items.map(option), validFor: /^\w*$/ };
}

async function meaning(server: Server, view: EditorView, at: number) {
  const document = view.state.doc;
  const { text, range } = await server.hover(positionAt(document, at));
  if (text === '' || view.state.doc !== document) return null;
  const { from, to } = range ? spanOf(document, range) : { from: at, to: at };
  return { pos: from, end: to, above: true, create: () => ({ dom: element('div', { class: 'meaning' }, markdown(text)) }) };
}

class Quantity extends WidgetType {
  constructor(private readonly label: string) {
    super();
  }

  override eq(other: Quantity): boolean {
    return other.label === this.label;
  }

  override toDOM(): HTMLElement {
    return element('span', { class: 'hint', 'aria-hidden': 'true' }, this.label);
  }
}

const setHints = StateEffect.define<readonly Hint[]>();

const hintField = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(hints, transaction) {
    const given = transaction.effects.find((effect) => effect.is(setHints))?.value as readonly Hint[] | undefined;
    if (!given) return hints.map(transaction.changes);
    const document = transaction.newDoc;
    const widgets = given.map(({ position, label }) => Decoration.widget({ widget: new Quantity(label), side: 1 }).range(offsetOf(document, position)));
    return Decoration.set(widgets, true);
  },
  provide: (field) => EditorView.decorations.from(field),
});

/**
 * Asks for the hints of the shown text; if it has changed by the reply, that change has asked for them again.
 */
export async function refreshHints(server: Server, view: EditorView): Promise<void> {
  const document = view.state.doc;
  const hints = await server.hints(document.lines);
  if (view.state.doc === document) view.dispatch({ effects: setHints.of(hints) });
}

export function assistance(server: Server): Extension {
  return [
    autocompletion({ override: [(context) => proposals(server, context).catch(() => null)], icons: false }),
    keymap.of(completionKeymap),
    hoverTooltip((view, at) => meaning(server, view, at).catch(() => null)),
    hintField,
  ];
}
