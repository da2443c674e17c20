// What the page itself says; everything about lists is said by the program.
const texts = {
  title: ['Check axis parameter lists', 'Achsparameterlisten prüfen'],
  open: ['Open files', 'Dateien öffnen'],
  openFolder: ['Open folder', 'Ordner öffnen'],
  samples: ['Samples', 'Beispiele'],
  cycleTime: ['NC cycle time', 'NC-Zykluszeit'],
  language: ['Language', 'Sprache'],
  theme: ['Light or dark', 'Hell oder dunkel'],
  files: ['Files', 'Dateien'],
  editor: ['Text of the list', 'Text der Liste'],
  findings: ['Findings', 'Befunde'],
  machine: ['Machine', 'Maschine'],
  pictures: ['Pictures', 'Bilder'],
  report: ['Report', 'Bericht'],
  drop: [
    'Drop a list, or a controller’s whole folder. Nothing leaves this page.',
    'Eine Liste oder den ganzen Ordner einer Steuerung hier ablegen. Nichts verlässt diese Seite.',
  ],
  loading: ['The program is being loaded …', 'Das Programm wird geladen …'],
  checking: ['Checking …', 'Wird geprüft …'],
  nothing: ['Nothing is wrong.', 'Alles in Ordnung.'],
  counts: ['{errors} errors, {warnings} warnings', '{errors} Fehler, {warnings} Warnungen'],
  fix: ['Fix', 'Beheben'],
  fixAll: ['Fix all that is safe', 'Alles Sichere beheben'],
  fixed: ['Fixed in {files}.', 'Behoben in {files}.'],
  nothingToFix: ['There is nothing that can be fixed without a change of the machine.', 'Nichts lässt sich beheben, ohne die Maschine zu ändern.'],
  explain: ['What {code} means', 'Was {code} bedeutet'],
  download: ['Save {file}', '{file} speichern'],
  compile: ['Save the coefficient image', 'Koeffizientenabbild speichern'],
  share: ['Copy a link to this list', 'Link auf diese Liste kopieren'],
  shared: ['The link is on the clipboard; it contains the list.', 'Der Link ist in der Zwischenablage; er enthält die Liste.'],
  tooLong: ['The list is too long for a link.', 'Die Liste ist zu lang für einen Link.'],
  tooLarge: ['These files have {size} MB; the page takes 256.', 'Diese Dateien haben {size} MB; die Seite nimmt 256.'],
  notShown: ['{file} is not a text that can be shown here.', '{file} ist kein Text, der sich hier zeigen lässt.'],
  kind: ['Picture', 'Bild'],
  axis: ['Axis', 'Achse'],
  everyAxis: ['all', 'alle'],
  before: ['Beside the files as they were opened', 'Neben den Dateien, wie sie geöffnet wurden'],
  response: ['Frequency response', 'Frequenzgang'],
  step: ['Step', 'Sprung'],
  delay: ['Delays', 'Verzögerungen'],
  corner: ['Corner', 'Ecke'],
  circle: ['Circle', 'Kreis'],
  larger: ['Larger', 'Größer'],
  smaller: ['Smaller', 'Kleiner'],
  whole: ['Whole picture', 'Ganzes Bild'],
  savePicture: ['Save the picture', 'Bild speichern'],
  saveReport: ['Save the report', 'Bericht speichern'],
  close: ['Close', 'Schließen'],
  failed: ['The program could not be run: {reason}', 'Das Programm ließ sich nicht ausführen: {reason}'],
  fromFile: [
    'Browsers run no program for a page from the disk. Serve the folder, as docs/browser.md says.',
    'Für eine Seite von der Platte führen Browser kein Programm aus. Den Ordner von einem Server laden, wie docs/browser.md es beschreibt.',
  ],
} as const;

export type Language = 'en' | 'de';
export type Key = keyof typeof texts;

let language: Language = 'en';

export const currentLanguage = (): Language => language;
export function setLanguage(wanted: Language): void {
  language = wanted;
}

export function say(key: Key, values: Record<string, string | number> = {}): string {
  return texts[key][language === 'de' ? 1 : 0].replace(/\{(\w+)\}/g, (_, name: string) => String(values[name] ?? ''));
}
