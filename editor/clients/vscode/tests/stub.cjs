// As much of the module `vscode` as starting the client touches: every name is there, every event can be listened to. What
// the extension decides by is given by the test, what it does is recorded.
'use strict';

const disposable = { dispose() {} };

function anything(name) {
  const target = class {
    dispose() {}
  };
  return new Proxy(target, {
    get(self, key) {
      if (key === 'prototype') return self.prototype;
      if (typeof key === 'symbol' || key === 'then') return undefined;
      if (!(key in self) || key === 'name' || key === 'length') self[key] = anything(`${name}.${key}`);
      return self[key];
    },
    set(self, key, value) {
      self[key] = value;
      return true;
    },
    apply: () => disposable,
  });
}

const settings = {};
const recorded = { errors: [], commands: new Map(), diagnostics: new Map(), executed: [] };
const listeners = [];

const vscode = anything('vscode');
vscode.version = '1.91.1';
Object.assign(vscode.Uri, {
  parse: (text) => ({ scheme: text.split(':')[0], path: new URL(text).pathname, fsPath: new URL(text).pathname, toString: () => text }),
  file: (path) => vscode.Uri.parse(`file://${path}`),
});
vscode.env = { language: 'en', appName: 'stub' };
vscode.l10n = { t: (text, ...words) => text.replace(/\{(\d)\}/g, (_, index) => words[index]) };
const kind = (value) => ({ value, append: (more) => kind(`${value}.${more}`) });
vscode.CodeActionKind = new Proxy({}, { get: (_, name) => kind(name === 'Empty' ? '' : String(name)) });
vscode.Disposable = class {
  constructor(dispose) {
    this.dispose = dispose;
  }
  static from(...all) {
    return { dispose: () => all.forEach((one) => one.dispose()) };
  }
};
vscode.EventEmitter = class {
  event = () => disposable;
  fire() {}
  dispose() {}
};
vscode.workspace = Object.assign(anything('workspace'), {
  workspaceFolders: undefined,
  textDocuments: [],
  notebookDocuments: [],
  createFileSystemWatcher: () => ({ ...disposable, onDidCreate() {}, onDidChange() {}, onDidDelete() {} }),
  getConfiguration: (section) => ({ get: (name, usual) => (section === undefined ? settings : settings[name]) ?? usual }),
  onDidChangeConfiguration(listener) {
    listeners.push(listener);
    return disposable;
  },
});
vscode.window = Object.assign(anything('window'), {
  activeTextEditor: undefined,
  visibleTextEditors: [],
  tabGroups: { all: [], onDidChangeTabs: () => disposable },
  createOutputChannel: () => ({ append() {}, appendLine() {}, show() {}, dispose() {}, info() {}, error() {}, warn() {}, onDidChangeLogLevel: () => disposable }),
  async showErrorMessage(text) {
    recorded.errors.push(text);
  },
});
vscode.commands = {
  registerCommand(name, run) {
    recorded.commands.set(name, run);
    return { dispose: () => recorded.commands.delete(name) };
  },
  async executeCommand(...words) {
    recorded.executed.push(words);
  },
};
vscode.languages = Object.assign(anything('languages'), {
  match: () => 0,
  createDiagnosticCollection: () => ({ set() {}, delete() {}, clear() {}, dispose() {} }),
});

/** Some setting below `axisc` has changed. */
const change = (name) => {
  const changed = `axisc.${name}`;
  const affectsConfiguration = (section) => changed === section || changed.startsWith(`${section}.`);
  return Promise.all(listeners.map((listener) => listener({ affectsConfiguration })));
};
vscode.test = { settings, recorded, change };
module.exports = vscode;
