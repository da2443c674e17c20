// The language server of the program. A request is a run of its own: the list as it is in the editor, the request, the end.
import type { Program } from './program';

export interface Position {
  line: number;
  character: number;
}

export interface Range {
  start: Position;
  end: Position;
}

export interface Proposal {
  label: string;
  kind?: number;
  detail?: string;
  documentation?: string | { value: string };
  preselect?: boolean;
  textEdit?: { range: Range; newText: string };
}

export interface Hint {
  position: Position;
  label: string;
}

/** The list that is asked about. */
export interface Asked {
  path: string;
  text: string;
  /** Options of the server: language and cycle time. */
  words: string[];
}

interface Message {
  id?: number;
  result?: unknown;
  error?: { message: string };
}

const folder = 'file:///work';
const addressOf = (path: string): string => `${folder}/${path.split('/').map(encodeURIComponent).join('/')}`;

function framed(message: object): string {
  const text = JSON.stringify({ jsonrpc: '2.0', ...message });
  return `Content-Length: ${new TextEncoder().encode(text).length}\r\n\r\n${text}`;
}

/** Line ends of JSON are escaped: a header is what has some. */
function messagesIn(output: string): Message[] {
  return output
    .split(/Content-Length: \d+\r\n\r\n/)
    .filter((text) => text !== '')
    .map((text) => JSON.parse(text) as Message);
}

export class Server {
  constructor(
    private readonly program: Program,
    private readonly asked: () => Asked | null,
  ) {}

  private async request<Result>(method: string, more: object): Promise<Result | null> {
    const asked = this.asked();
    if (!asked) return null;
    const uri = addressOf(asked.path);
    const capabilities = { textDocument: { hover: { contentFormat: ['markdown'] }, completion: { completionItem: {} } } };
    const input = [
      { id: 1, method: 'initialize', params: { capabilities, rootUri: folder } },
      { method: 'initialized', params: {} },
      { method: 'textDocument/didOpen', params: { textDocument: { uri, languageId: 'axis-list', version: 1, text: asked.text } } },
      { id: 2, method: `textDocument/${method}`, params: { textDocument: { uri }, ...more } },
      { id: 3, method: 'shutdown' },
      { method: 'exit' },
    ];
    const outcome = await this.program.run({ words: ['lsp', ...asked.words], input: input.map(framed).join('') });
    const reply = messagesIn(outcome.out).find((message) => message.id === 2);
    if (reply === undefined || reply.error) throw new Error(reply?.error?.message ?? outcome.err);
    return reply.result as Result | null;
  }

  /** Markdown; empty where there is nothing to say. */
  async hover(position: Position): Promise<{ text: string; range: Range | null }> {
    const result = await this.request<{ contents: { value: string }; range?: Range }>('hover', { position });
    return { text: result?.contents.value ?? '', range: result?.range ?? null };
  }

  async complete(position: Position): Promise<Proposal[]> {
    const result = await this.request<Proposal[] | { items: Proposal[] }>('completion', { position });
    return Array.isArray(result) ? result : (result?.items ?? []);
  }

  async hints(lines: number): Promise<Hint[]> {
    const range: Range = { start: { line: 0, character: 0 }, end: { line: lines, character: 0 } };
    const result = await this.request<{ position: Position; label: string | { value: string }[] }[]>('inlayHint', { range });
    return (result ?? []).map(({ position, label }) => ({
      position,
      label: typeof label === 'string' ? label : label.map((part) => part.value).join(''),
    }));
  }
}
