// The page: takes files in, and shows findings, fixes, machine, pictures and report.
import { Actions } from './actions';
import { reasonOf } from './checks';
import { Controls } from './controls';
import { byId } from './elements';
import { Lookup } from './lookup';
import { Page } from './page';
import { say } from './texts';
import { begin } from './welcome';

async function run(): Promise<void> {
  const lookup = new Lookup();
  const page = new Page(await globalThis.axisc, (text) => lookup.open(text));
  lookup.connect((word) => void page.explain(word));
  new Controls(page, lookup).connect();
  new Actions(page).connect();
  await begin(page);
}

run().catch((failure: unknown) => {
  byId('told').textContent = say('failed', { reason: reasonOf(failure) });
  byId('told').hidden = false;
});
