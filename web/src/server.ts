// The answers of the program's language server about the list in the editor.
import type { Program } from './program';

export interface Position {
  line: number;
  character: number;
}

export interface Range {
  start: Position;
  end: Position;
}

export interface TextEdit {
  range: Range;
  newText: string;
}

export interface Proposal {
  label: string;
  kind?: number;
  detail?: string;
  documentation?: string | { value: string };
  preselect?: boolean;
  textEdit?: TextEdit;
}

export interface Hint {
  position: Position;
  label: string;
}

/** The list that requests are about. */
export interface Asked {
  path: string;
  text: string;
}

export class Server {
  constructor(
    private readonly program: Program,
    private readonly asked: () => Asked | null,
  ) {}

  private async request<Result>(method: string, more: object): Promise<Result | null> {
    const asked = this.asked();
    if (!asked) return null;
    return (await this.program.ask({ ...asked, method, more })) as Result | null;
  }

  /** Markdown; empty where there is none. */
  async hover(position: Position): Promise<{ text: string; range: Range | null }> {
    const result = await this.request<{ contents: { value: string }; range?: Range }>('hover', { position });
    return { text: result?.contents.value ?? '', range: result?.range ?? null };
  }

  async complete(position: Position): Promise<Proposal[]> {
    const result = await this.request<Proposal[] | { items: Proposal[] }>('completion', { position });
    return Array.isArray(result) ? result : (result?.items ?? []);
  }

  /** What aligns the list. */
  async format(): Promise<TextEdit[]> {
    return (await this.request<TextEdit[]>('formatting', { options: { tabSize: 2, insertSpaces: true } })) ?? [];
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
