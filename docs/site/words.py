"""What the site says in its own words, and in which order it has the guides."""

WORDS = {
    "en": {"language": "English", "start": "Start", "about": "Checks axis parameter lists before the machine does",
           "also": "Also called: {}.",
           "no_checker": "<!doctype html><title>axisc</title><p>This copy of the site was built without the checker."},
    "de": {"language": "Deutsch", "start": "Start", "about": "Prüft Achsparameterlisten, bevor es die Maschine tut",
           "also": "Auch genannt: {}."},
}

KINDS = {
    "rules": {"en": {"title": "Rules", "about": "What axisc reports, by its code."},
              "de": {"title": "Regeln", "about": "Was axisc meldet, nach dem Code."}},
    "messages": {"en": {"title": "Messages of the control", "about": "Numbers on the panel: meaning, reaction, remedy, and which findings foretell them."},
                 "de": {"title": "Meldungen der Steuerung", "about": "Nummern am Bedienfeld: Bedeutung, Reaktion, Abhilfe und welche Befunde sie ankündigen."}},
    "parameters": {"en": {"title": "Parameters", "about": "Parameters of axis lists, with type, range, unit and default."},
                   "de": {"title": "Parameter", "about": "Parameter der Achslisten mit Typ, Bereich, Einheit und Standardwert."}},
    "words": {"en": {"title": "Words of NC programs", "about": "What decides how a path is driven, and what axisc makes of it."},
              "de": {"title": "Wörter in NC-Programmen", "about": "Was entscheidet, wie eine Bahn gefahren wird, und was axisc daraus macht."}},
    "topics": {"en": {"title": "Filters and subjects", "about": "Kinds of filters, and subjects that have several parameters."},
               "de": {"title": "Filter und Themen", "about": "Filtertypen und Themen, zu denen mehrere Parameter gehören."}},
}

HOME = {
    "en": """# axisc

CNC machines controlled by TwinCAT CNC or an ISG kernel smooth and damp their axes with filters that are configured in axis parameter lists.
axisc checks these lists before the machine starts, says what the control would do and what to write instead, and compiles the filters for a
small real-time runtime.

| I have | do this |
|---|---|
| **a list, or a controller's folder** | open the <a href="check.html" target="_blank">checker</a>, drop the folder on it: nothing is installed, nothing leaves your computer. Then: [controller folder](controller-folder.md), [report](report.md), [suggest](suggest.md) |
| **a pipeline** | [install](installation.md) the package; `axisc lint FOLDER` ends with 1 where there are errors: [pipelines](pipelines.md), [packages](packages.md), [findings](findings.md) |
| **a controller** | `axisc compile MACHINE`, and link the [runtime](runtime.md); what an image proves: [certificate](certificate.md), [image format](image-format.md) |

A number on the panel? [Messages of the control](messages/index.md). A code of axisc? [Rules](rules/index.md). Or type it above.
""",
    "de": """# axisc

CNC-Maschinen mit TwinCAT CNC oder ISG-Kern glätten und dämpfen ihre Achsen mit Filtern, die in Achsparameterlisten eingestellt werden. axisc prüft
diese Listen, bevor die Maschine anläuft, sagt, was die Steuerung täte und was stattdessen hineingehört, und kompiliert die Filter für eine
kleine Echtzeit-Laufzeit.

| Ich habe | Das ist zu tun |
|---|---|
| **eine Liste oder den Ordner einer Steuerung** | die <a href="../check.html" target="_blank">Prüfseite</a> öffnen und den Ordner darauf ziehen: Nichts wird installiert, nichts verlässt den Rechner. Danach: [Ordner einer Steuerung](controller-folder.md), [Bericht](report.md), [Vorschläge](suggest.md) |
| **eine Pipeline** | das Paket [installieren](installation.md); `axisc lint ORDNER` endet bei Fehlern mit 1: [Pipelines](pipelines.md), [Pakete](packages.md), [Befunde](findings.md) |
| **eine Steuerung** | `axisc compile MASCHINE` und die [Laufzeit](runtime.md) einbinden; was ein Abbild beweist: [Zertifikat](certificate.md), [Abbildformat](image-format.md) |

Eine Nummer am Bedienfeld? [Meldungen der Steuerung](messages/index.md). Ein Code von axisc? [Regeln](rules/index.md). Oder oben eintippen.

Die Seiten zu Regeln, Parametern, Meldungen und Wörtern sind deutsch, dazu [Aufzeichnen an der Maschine](record.md) und [FMU](fmu.md); die übrigen
Anleitungen gibt es auf Englisch.
""",
}

GUIDES = [
    ({"en": "Begin", "de": "Anfangen (englisch)"}, ["installation.md", "tutorial.md", "browser.md", "editors.md", "packages.md", "building.md"]),
    ({"en": "A machine's lists", "de": "Listen einer Maschine (englisch)"},
     ["controller-folder.md", "twincat-project.md", "machine-file.md", "settings.md", "values.md", "mistakes.md", "report.md", "schema-files.md"]),
    ({"en": "Filters and motion", "de": "Filter und Bewegung (englisch)"},
     ["filters.md", "plots.md", "gallery.md", "contour.md", "nc-programs.md", "circle.md", "suggest.md", "closed-loop.md", "plant-file.md", "identify.md", "compare.md", "record.md"]),
    ({"en": "Pipelines and programs", "de": "Pipelines und Programme (englisch)"},
     ["pipelines.md", "findings.md", "python.md", "library.md", "webassembly.md"]),
    ({"en": "Controllers", "de": "Steuerungen (englisch)"},
     ["runtime.md", "export.md", "fmu.md", "certificate.md", "image-format.md", "linuxcnc.md"]),
    ({"en": "More", "de": "Weiteres (englisch)"}, ["glossary.md", "architecture.md"]),
]
