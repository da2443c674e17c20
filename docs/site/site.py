#!/usr/bin/env python3
"""The documentation as a site that can be searched, in English and German: site.py AXISC SOURCES OUT [PAGE]

The guides of docs/, and a page for each rule, parameter, message of the control, word of NC programs and kind of filter as
`axisc explain` prints it. PAGE is axisc.html, which becomes a page of the site. mkdocs (Debian: mkdocs-material) builds both languages and
fails at a dead link. AXISC_SITE is the address of the site, where it has one; that of the sources is
HOMEPAGE_URL of CMakeLists.txt, or AXISC_HOMEPAGE.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

sys.dont_write_bytecode = True
import search
from words import GUIDES, HOME, KINDS, WORDS

AXISC, SOURCES, OUT = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
PAGE = pathlib.Path(sys.argv[4]) if len(sys.argv) > 4 else None
sys.path.append(str(SOURCES / "packaging"))
import project
HOMEPAGE = project.read().homepage
REPOSITORY = f"{HOMEPAGE}/blob/main" if project.is_published(HOMEPAGE) else ""


def explained(language, *words):
    done = subprocess.run([AXISC, "explain", "--lang", language, *words], capture_output=True, text=True, check=True)
    return done.stdout


def slug(name):
    return re.sub(r"[^A-Za-z0-9]+", "-", name).strip("-").lower()


class Subjects:
    """What `axisc explain` knows, and where its page lies: names and numbers to "rules/ax3005.md"."""

    def __init__(self, language):
        everything = json.loads(explained(language, "--all", "--format", "json"))
        self.titles = {kind: {} for kind in KINDS}
        self.pages = {}
        self.also = {}
        for subject in everything["hits"]:
            self.add(subject["kind"] + "s", subject["name"], subject["meaning"] or "", subject["also"])

    def add(self, kind, name, meaning, also):
        if self.titles[kind].setdefault(name, meaning) != meaning:
            return
        page = f"{kind}/{slug(name)}.md"
        if kind == "parameters" and also:
            self.also[name] = also
        for known in [name, *name.split("/")] + ([also] if kind == "parameters" and also else []):
            self.pages.setdefault(known, page)


def linked(text, subjects, folder):
    """Names in the first column of tables, and codes and numbers in running text, lead to their pages."""
    up = "../" if folder else ""

    def link(name, shown):
        page = subjects.pages.get(name)
        return f"[{shown}]({up}{page})" if page else shown

    if folder:  # these pages name guides as docs/ does
        text = re.sub(r"\]\(([a-z-]+\.md)", r"](../\1", text)
    lines, fenced = [], False
    for line in text.split("\n"):
        if line.startswith("```"):
            fenced = not fenced
        if not fenced and not line.startswith("#"):
            cell = re.match(r"\| ([^|]+?) \|", line)
            if cell and cell[1] in subjects.pages:
                line = line.replace(cell[1], link(cell[1], cell[1].replace("[", "\\[")), 1)
            else:
                line = re.sub(r"(?<![\[`(\w/#-])(AX\d{4}|P-[A-Z]+-\d{5})(?![\w`\]-])", lambda m: link(m[1], m[1]), line)
        lines.append(line)
    return "\n".join(lines)


def outside(target, text):
    """A link to what lies beside the documentation."""
    path = os.path.normpath(os.path.join("docs", target))
    return f"[{text}]({REPOSITORY}/{path})" if REPOSITORY else text


def addressed(text):
    """Commands that can be pasted, where the project has an address."""
    if not REPOSITORY:
        return text
    owner = HOMEPAGE.split("/")[-2]
    text = re.sub(rf"^`{project.PLACEHOLDER}` stands for .*?\n\n", "", text, flags=re.DOTALL | re.MULTILINE)
    text = text.replace(f"https://github.com/{project.PLACEHOLDER}/axisc", HOMEPAGE)
    return text.replace(f"{project.PLACEHOLDER}/axisc", f"{owner}/axisc").replace(f"{project.PLACEHOLDER}.axisc", f"{owner}.axisc")


def guide(text, subjects, known):
    def replaced(match):
        image, shown, target = match[1], match[2], match[3]
        path, _, anchor = target.partition("#")
        if image or re.match(r"[a-z]+:", target) or not path:
            return match[0]
        if path == "rules.md":
            return f"[{shown}]({subjects.pages.get(anchor, 'rules/index.md')})"
        if path.startswith("../") or path not in known:
            return outside(target, shown)
        return match[0]

    return re.sub(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)", replaced, text)


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def write_subjects(folder, language, subjects, called):
    others = {name: ", ".join(words[language]) for name, words in called.items() if words[language]}
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for kind in KINDS:
            names = list(subjects.titles[kind])
            for name, text in zip(names, pool.map(lambda name: explained(language, name.split("/")[0]), names)):
                also = f"\n{WORDS[language]['also'].format(others[name])}\n" if name in others else ""
                write(folder / subjects.pages[name], linked(text, subjects, True) + also)
            rows = "".join(f"| [{name.replace('[', chr(92) + '[')}]({slug(name)}.md) | {title.replace('|', chr(92) + '|')} |\n"
                           for name, title in subjects.titles[kind].items())
            words = KINDS[kind][language]
            write(folder / kind / "index.md", f"# {words['title']}\n\n{words['about']}\n\n| | |\n|---|---|\n{rows}")


def write_guides(folder, language, subjects):
    docs = SOURCES / "docs"
    texts = {path.name: path.read_text(encoding="utf-8") for path in docs.glob("*.md")}
    del texts["rules.md"], texts["README.md"]
    if language != "en":  # some guides are translated; their links count from a folder below docs/
        for path in (docs / language).glob("*.md"):
            texts[path.name] = path.read_text(encoding="utf-8").replace("](../", "](")
    listed = {name for _, names in GUIDES for name in names}
    if missing := set(texts) ^ listed:
        sys.exit(f"site.py: words.py and docs/ do not have the same guides: {', '.join(sorted(missing))}")
    files = [path.relative_to(docs).as_posix() for path in docs.rglob("*") if path.suffix in (".svg", ".png", ".json")]
    known = set(texts) | set(files)
    for name, text in texts.items():
        write(folder / name, linked(guide(addressed(text), subjects, known), subjects, False))
    for name in files:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(docs / name, folder / name)


def title_of(folder, name):
    return re.search(r"^# (.*)", (folder / name).read_text(encoding="utf-8"), re.MULTILINE)[1].replace("`", "")


def configuration(folder, language):
    words = WORDS[language]
    navigation = [{words["start"]: "index.md"}]
    navigation += [{KINDS[kind][language]["title"]: f"{kind}/index.md"} for kind in KINDS]
    navigation += [{part[language]: [{title_of(folder, name): name} for name in names]} for part, names in GUIDES]
    other = "de" if language == "en" else "en"
    return {"site_name": "axisc", "site_description": words["about"], "site_url": os.environ.get("AXISC_SITE") or None,
            "docs_dir": str(folder.resolve()), "site_dir": str((OUT / "site" / ("de" if language == "de" else "")).resolve()),
            "use_directory_urls": False, "nav": navigation, "extra_javascript": ["query.js"], "extra_css": ["query.css"],
            "plugins": [{"search": {"lang": language}}],
            "theme": {"name": "material", "language": language, "font": False,
                      "features": ["navigation.sections", "navigation.top", "search.highlight", "search.suggest"],
                      "palette": [{"media": "(prefers-color-scheme: light)", "scheme": "default"},
                                  {"media": "(prefers-color-scheme: dark)", "scheme": "slate"}]},
            "extra": {"generator": False,
                      "alternate": [{"name": WORDS[language]["language"], "link": "index.html", "lang": language},
                                    {"name": WORDS[other]["language"], "lang": other,
                                     "link": "../index.html" if other == "en" else "de/index.html"}]},
            "markdown_extensions": ["tables", "attr_list", {"toc": {"permalink": True}}]}


def build(language):
    folder = OUT / f"pages-{language}"
    shutil.rmtree(folder, ignore_errors=True)
    subjects = Subjects(language)
    called = search.words_of(SOURCES / "schema" / "lookup" / "lookup.json")
    write(folder / "index.md", HOME[language])
    write_subjects(folder, language, subjects, called)
    write_guides(folder, language, subjects)
    for name in ("query.js", "query.css"):
        shutil.copyfile(SOURCES / "docs" / "site" / name, folder / name)
    chosen = configuration(folder, language)
    path = OUT / f"mkdocs-{language}.json"
    path.write_text(json.dumps(chosen, indent=2), encoding="utf-8")
    done = subprocess.run(["mkdocs", "build", "--strict", "--clean", "--config-file", path], capture_output=True, text=True)
    if done.returncode != 0:
        problems = [line for line in done.stderr.split("\n") if "WARNING" in line or "ERROR" in line]
        sys.exit("site.py: mkdocs: " + ("\n".join(problems) or done.stderr))
    made = pathlib.Path(chosen["site_dir"])
    search.enrich(made / "search" / "search_index.json", language, subjects, called)
    search.mend(made)
    return {kind: len(subjects.titles[kind]) for kind in KINDS}


def main():
    shutil.rmtree(OUT / "site", ignore_errors=True)
    OUT.mkdir(parents=True, exist_ok=True)
    for language in ("en", "de"):  # the German site lies within the English one
        print(language, build(language))
    checker = OUT / "site" / "check.html"
    if PAGE:
        shutil.copyfile(PAGE, checker)
    else:
        checker.write_text(WORDS["en"]["no_checker"], encoding="utf-8")


main()
