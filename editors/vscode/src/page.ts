// What a panel shows: the server's page with a policy that lets its own scripts run and nothing leave the editor.
export interface Page {
  title: string;
  html: string;
}

export function isPage(answer: unknown): answer is Page {
  const page = answer as Partial<Page> | null;
  return typeof page?.html === 'string' && typeof page.title === 'string';
}

/** The digests of the page's inline scripts, as a policy names them. */
async function scripts(html: string): Promise<string[]> {
  const found = [...html.matchAll(/<script>([\s\S]*?)<\/script>/g)].map(async ([, script]) => {
    const bytes = new TextEncoder().encode(script.replace(/\r\n?/g, '\n'));
    const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
    return `'sha256-${btoa(String.fromCharCode(...digest))}'`;
  });
  return Promise.all(found);
}

/** The page for a webview. Styles are inline, pictures are in the page; everything else is refused. */
export async function guarded(html: string): Promise<string> {
  const allowed = (await scripts(html)).join(' ') || "'none'";
  const policy = `default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src ${allowed}`;
  const meta = `<meta http-equiv="Content-Security-Policy" content="${policy}">`;
  const head = /<head[^>]*>/i.exec(html);
  if (head === null) return `<!doctype html><html><head>${meta}</head><body>${html}</body></html>`;
  const end = head.index + head[0].length;
  return html.slice(0, end) + meta + html.slice(end);
}
