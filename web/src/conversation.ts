// The language server of an instance: one for all requests, which is informed of all changes since the last
// one.
import type { Axisc, Options } from '../interface/axisc.mjs';
import { folder, whole, type Instance } from './instance';
import type { Question } from './program';

interface Message {
  id?: number;
  result?: unknown;
  error?: { message: string };
}

const addressOf = (path: string): string => `file://${whole(path).split('/').map(encodeURIComponent).join('/')}`;
const capabilities = { textDocument: { hover: { contentFormat: ['markdown'] }, completion: { completionItem: {} } } };
const anyChange = 2;

export class Conversation {
  private workspace: Axisc | null = null;
  private open: { uri: string; text: string } | null = null;
  private version = 0;
  private last = 0;

  constructor(private readonly instance: Instance) {}

  /** `changed`: the files that have changed since the last request. */
  ask(options: Options, { path, text, method, more }: Question, changed: Iterable<string>): unknown {
    const workspace = this.instance.workspace(options);
    const messages = [...this.start(workspace), ...this.changes(changed), ...this.turn(addressOf(path), text)];
    const id = ++this.last;
    messages.push({ id, method: `textDocument/${method}`, params: { textDocument: { uri: addressOf(path) }, ...more } });
    const sent = workspace.message(...messages.map((message) => ({ jsonrpc: '2.0', ...message }))) as Message[];
    const reply = sent.find((message) => message.id === id);
    if (reply === undefined || reply.error) throw new Error(reply?.error?.message ?? method);
    return reply.result;
  }

  private start(workspace: Axisc): object[] {
    if (workspace === this.workspace) return [];
    this.workspace = workspace;
    this.open = null;
    const params = { capabilities, rootUri: `file://${folder}` };
    return [{ id: ++this.last, method: 'initialize', params }, { method: 'initialized', params: {} }];
  }

  private changes(changed: Iterable<string>): object[] {
    const changes = [...changed].map((path) => ({ uri: addressOf(path), type: anyChange }));
    return changes.length === 0 ? [] : [{ method: 'workspace/didChangeWatchedFiles', params: { changes } }];
  }

  /** Switches to a list: opens it, or sends its present text. */
  private turn(uri: string, text: string): object[] {
    const before = this.open;
    if (before?.uri === uri && before.text === text) return [];
    this.open = { uri, text };
    const version = ++this.version;
    if (before?.uri === uri) return [{ method: 'textDocument/didChange', params: { textDocument: { uri, version }, contentChanges: [{ text }] } }];
    const closed = before ? [{ method: 'textDocument/didClose', params: { textDocument: { uri: before.uri } } }] : [];
    return [...closed, { method: 'textDocument/didOpen', params: { textDocument: { uri, languageId: 'axis-list', version, text } } }];
  }
}
