// The page: takes files in, and shows findings, fixes, machine, pictures and report.
import { Actions } from './actions';
import { Controls } from './controls';
import { byId } from './elements';
import { Page } from './page';
import type { Started } from './program';
import { say } from './texts';

function begin(): void {
  const started = (globalThis as { axisc?: Started }).axisc;
  if (started === undefined) {
    byId('subtitle').textContent = say('fromFile');
    return;
  }
  const page = new Page(started);
  new Controls(page).connect();
  new Actions(page).connect();
  void page.begin();
}

begin();
