// Runs before the page's own script: the module is compiled meanwhile.
import { isOneFile, load, textOfPart, type Parts } from './parts';

declare global {
  var axisc: Promise<Parts>;
}

globalThis.axisc = load();
globalThis.axisc.catch(() => undefined);

// The policy has the digest of this script.
if (isOneFile) {
  void textOfPart('page.js').then((text) => {
    const script = document.createElement('script');
    script.textContent = text;
    document.body.append(script);
  });
}
