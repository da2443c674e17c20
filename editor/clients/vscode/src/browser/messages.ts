// What the worker is told besides messages of the protocol.

/** The first message. */
export interface Beginning {
  kind: 'begin';
  program: Uint8Array;
  language: 'de' | 'en';
}

/** A file as it is now; without bytes, it is gone. */
export interface FileState {
  kind: 'file';
  path: string;
  bytes?: Uint8Array;
}

export type Told = Beginning | FileState;

export function isTold(message: unknown): message is Told {
  return typeof (message as Partial<Told> | null)?.kind === 'string';
}
