// The client, from the start of the editor to its end: begun again when another program is named. The server takes all other settings as they change.
import * as vscode from 'vscode';
import type { BaseLanguageClient } from 'vscode-languageclient';
import { offerCommands, registerCommands } from './commands';

/** A client that is not started; undefined where there can be none, which the user was told. */
export type Begin = () => Promise<BaseLanguageClient | undefined>;

let client: BaseLanguageClient | undefined;
/** One start after the other, however fast settings change. */
let starting: Promise<void> = Promise.resolve();

async function stop(): Promise<void> {
  const ending = client;
  client = undefined;
  await ending?.dispose();
}

export async function run(context: vscode.ExtensionContext, begin: Begin): Promise<void> {
  const start = async () => {
    await stop();
    client = await begin();
    if (client === undefined) return;
    await client.start();
    await offerCommands(client);
  };
  const restart = () => (starting = starting.then(start, start));
  context.subscriptions.push(
    registerCommands(() => client),
    vscode.commands.registerCommand('axisc.restart', restart),
    vscode.workspace.onDidChangeConfiguration(async (event) => {
      if (event.affectsConfiguration('axisc.path')) await restart();
    }),
  );
  await restart();
}

export async function end(): Promise<void> {
  await starting.catch(() => undefined);
  await stop();
}
