// What a panel shows: the server's page with a policy that lets its own scripts run and nothing leave the editor.
export interface Page {
  title: string;
  html: string;
  /** Digests of the scripts that the server wrote, as a policy names them. Older servers name none. */
  scripts?: string[];
}

export function isPage(answer: unknown): answer is Page {
  const page = answer as Partial<Page> | null;
  return typeof page?.html === 'string' && typeof page.title === 'string' && (page.scripts === undefined || Array.isArray(page.scripts));
}

const digest = /^sha256-[A-Za-z0-9+/]{43}=$/;

/**
 * The page for a webview. Styles are inline, pictures are in the page; everything else is refused, also a script in the page that
 * the server does not name: it may have come out of a list.
 */
export function guarded({ html, scripts = [] }: Page): string {
  const named = scripts.filter((script) => digest.test(script)).map((script) => `'${script}'`);
  const policy = `default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src ${named.join(' ') || "'none'"}`;
  const meta = `<meta http-equiv="Content-Security-Policy" content="${policy}">`;
  const head = /<head[^>]*>/i.exec(html);
  if (head === null) return `<!doctype html><html><head>${meta}</head><body>${html}</body></html>`;
  const end = head.index + head[0].length;
  return html.slice(0, end) + meta + html.slice(end);
}
