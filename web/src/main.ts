// The page: files in, findings, fixes, machine, pictures and report out.
import { Controls } from './controls';
import { byId } from './elements';
import { Page } from './page';
import { say } from './texts';

function begin(): void {
  if (location.protocol === 'file:') {
    byId('subtitle').textContent = say('fromFile');
    return;
  }
  const page = new Page();
  new Controls(page).connect();
  void page.begin();
}

begin();
