// Starts the worker before the page's own script is loaded; its messages are kept until then.
import type { Started } from './program';

if (location.protocol !== 'file:') {
  const started: Started = { worker: new Worker('worker.js'), early: [] };
  started.worker.onmessage = (event) => void started.early.push(event);
  (globalThis as { axisc?: Started }).axisc = started;
}
