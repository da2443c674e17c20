// The page's own texts; all texts about lists come from the program.
const texts = {
  title: ['Check axis parameter lists', 'Achsparameterlisten prüfen'],
  open: ['Open files', 'Dateien öffnen'],
  new: ['New list', 'Neue Liste'],
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
    'Drop lists or a controller folder. Nothing leaves your browser.',
    'Listen oder einen Steuerungsordner hierher ziehen. Nichts verlässt den Browser.',
  ],
  loading: ['The program is being loaded …', 'Das Programm wird geladen …'],
  checking: ['Checking …', 'Wird geprüft …'],
  nothing: ['Nothing is wrong.', 'Alles in Ordnung.'],
  error: ['{count} error', '{count} Fehler'],
  errors: ['{count} errors', '{count} Fehler'],
  warning: ['{count} warning', '{count} Warnung'],
  warnings: ['{count} warnings', '{count} Warnungen'],
  note: ['{count} note', '{count} Hinweis'],
  notes: ['{count} notes', '{count} Hinweise'],
  control: ['Control', 'Steuerung'],
  fix: ['Fix', 'Beheben'],
  fixAll: ['Fix all safe', 'Alle sicheren beheben'],
  align: ['Align', 'Ausrichten'],
  aligned: ['{file} is aligned.', '{file} ist ausgerichtet.'],
  isAligned: ['The list was aligned already.', 'Die Liste war schon ausgerichtet.'],
  fixed: ['Fixed: {files}.', 'Behoben: {files}.'],
  nothingToFix: ['Nothing can be fixed without changing how the machine behaves.', 'Nichts lässt sich beheben, ohne dass sich die Maschine anders verhält.'],
  more: ['Show more ({count} left)', 'Weitere anzeigen ({count} übrig)'],
  explain: ['What {code} means', 'Was {code} bedeutet'],
  download: ['Save {file}', '{file} speichern'],
  downloadAll: ['Save {files} changed files', '{files} geänderte Dateien speichern'],
  compile: ['Compile image', 'Abbild kompilieren'],
  share: ['Copy link', 'Link kopieren'],
  shared: ['The link, which contains the list, is on the clipboard.', 'Der Link mit der Liste ist in der Zwischenablage.'],
  inAddress: ['The address of this page now contains the list.', 'Die Adresse dieser Seite enthält jetzt die Liste.'],
  tooLong: ['The list is too long for a link.', 'Die Liste ist zu lang für einen Link.'],
  tooLarge: ['These files have {size} MB; the limit is 256 MB.', 'Diese Dateien haben {size} MB; höchstens 256 MB sind möglich.'],
  notShown: ['{file} is not text, or too long to be shown here.', '{file} ist kein Text oder zu lang, um hier angezeigt zu werden.'],
  kind: ['Picture', 'Bild'],
  axis: ['Axis', 'Achse'],
  everyAxis: ['all', 'alle'],
  before: ['Compare with the files as opened', 'Mit dem Stand beim Öffnen vergleichen'],
  response: ['Frequency response', 'Frequenzgang'],
  step: ['Step', 'Sprung'],
  delay: ['Delays', 'Verzögerungen'],
  corner: ['Corner', 'Ecke'],
  circle: ['Circle', 'Kreis'],
  dynamics: ['Velocity and acceleration', 'Geschwindigkeit und Beschleunigung'],
  robustness: ['Robustness of Vibration Guard', 'Robustheit des Vibration Guard'],
  path: ['Path of a program', 'Bahn eines Programms'],
  program: ['Program', 'Programm'],
  plant: ['Position loop', 'Lageregelkreis'],
  plantFile: ['Drive and mechanics', 'Antrieb und Mechanik'],
  travel: ['Travel in mm', 'Verfahrweg in mm'],
  feed: ['Feed rate in mm/min', 'Vorschub in mm/min'],
  contour: ['Contour deviations', 'Konturabweichungen'],
  larger: ['Larger', 'Größer'],
  smaller: ['Smaller', 'Kleiner'],
  whole: ['Whole picture', 'Ganzes Bild'],
  savePicture: ['Save the picture', 'Bild speichern'],
  saveReport: ['Save the report', 'Bericht speichern'],
  close: ['Close', 'Schließen'],
  failed: ['The program could not be run: {reason}', 'Das Programm ließ sich nicht ausführen: {reason}'],
  fromFile: [
    'Browsers do not start WebAssembly workers for pages opened from a disk. Serve this folder with any web server, for example web/serve.',
    'Für Seiten, die direkt von der Festplatte geöffnet werden, starten Browser keine WebAssembly-Worker. Diesen Ordner über einen Webserver laden, zum Beispiel mit web/serve.',
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
