// The search of the site finds what people type: node search.mjs SITE SOURCES. The look-ups are those that `axisc explain`
// answers in tests/axisc/answers/look_up.test.cpp; here the right page is among the first five. The theme's own worker searches.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import vm from 'node:vm';

const [site, sources] = process.argv.slice(2);
const seen = 5;
// The site looks for words; some of these are sentences, which `axisc explain` understands.
const least = 0.85;

function lookUps() {
  const text = readFileSync(path.join(sources, 'tests/axisc/answers/look_up.test.cpp'), 'utf8');
  const table = text.slice(text.indexOf('to_array<LookUp>'), text.indexOf('static_assert(look_ups'));
  return [...table.matchAll(/\{"([^"]+)", "([^"]+)"\}/g)].map(([, typed, right]) => ({ typed, right }));
}

/** What the page of a language asks its worker, and gets. */
class Search {
  constructor(folder) {
    this.scripts = path.join(folder, 'assets/javascripts');
    this.settings = JSON.parse(/<script id="__config"[^>]*>(.*?)<\/script>/s.exec(readFileSync(path.join(folder, 'index.html'), 'utf8'))[1]);
    this.index = JSON.parse(readFileSync(path.join(folder, 'search/search_index.json'), 'utf8'));
  }

  async start() {
    const workers = path.join(this.scripts, 'workers');
    const failed = (text) => assert.fail(text);
    const global = { console: { ...console, warn: failed }, postMessage: (message) => this.answered(message), addEventListener: (_, listener) => (this.listener = listener) };
    const context = vm.createContext(Object.assign(global, { self: global, window: global }));
    global.importScripts = (...names) => {
      for (const name of names) vm.runInContext(readFileSync(path.resolve(workers, name), 'utf8'), context);
    };
    vm.runInContext(readFileSync(path.join(workers, readdirSync(workers).find((name) => name.endsWith('.js'))), 'utf8'), context);
    // As the theme fills in what the index leaves open.
    const { config, docs } = this.index;
    const { translations, features } = this.settings;
    if (config.lang.length === 1 && config.lang[0] === 'en') config.lang = [translations['search.config.lang']];
    if (config.separator === '[\\s\\-]+') config.separator = translations['search.config.separator'];
    const pipeline = translations['search.config.pipeline'].split(/\s*,\s*/).filter(Boolean);
    await this.ask(0, { config, docs, options: { pipeline, suggestions: features.includes('search.suggest') } });
  }

  ask(type, data) {
    const search = this;
    class Worker {
      postMessage(message) {
        search.listener({ data: message });
      }
    }
    vm.runInNewContext(readFileSync(path.join(this.scripts, '../../query.js'), 'utf8'), { Worker });
    return new Promise((resolve) => {
      this.answered = resolve;
      new Worker().postMessage({ type, data });
    });
  }

  async pages(typed) {
    const query = typed.replace(/"|(?:^|\s+)[*+\-:^~]+(?=\s+|$)/g, '').trim();
    const { data } = await this.ask(2, query);
    return data.items.map(([first]) => first.location.replace(/#.*/, ''));
  }
}

const slug = (name) => name.replace(/[^A-Za-z0-9]+/g, '-').replace(/^-|-$/g, '').toLowerCase();

for (const folder of ['', 'de']) {
  const search = new Search(path.join(site, folder));
  await search.start();
  const missed = [];
  const all = lookUps();
  assert.ok(all.length >= 60);
  for (const { typed, right } of all) {
    const page = new RegExp(`^(rules|messages|parameters|words|topics)/(\\d+-)*${slug(right)}(-\\d+)*\\.html$`);
    const found = (await search.pages(typed)).slice(0, seen);
    if (!found.some((one) => page.test(one))) missed.push(`  ${typed}: not ${right}, but ${found.join(', ') || 'nothing'}`);
  }
  console.log(`${folder || 'en'}: ${all.length - missed.length} of ${all.length} look-ups among the first ${seen}\n${missed.join('\n')}`);
  if (all.length - missed.length < least * all.length) process.exitCode = 1;
  // While somebody is typing, too, the search must not fail: the theme tells it with a warning.
  for (const typed of ['5', '50', '505', '50 Hz', '10 ms', '1000', 'x', '#', '"', '-', 'filter[0].', 'AX', ':50663']) await search.pages(typed);
}
