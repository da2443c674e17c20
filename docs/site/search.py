"""What the search of the site knows of a subject beside its page: names, numbers, and the words of both languages that people
use for it, as they spell them. It compares words as they are typed, so every spelling is in its index."""
import json
import re

PLAIN = {"ä": "a", "ö": "o", "ü": "u", "ß": "ss"}
LONG = {"ä": "ae", "ö": "oe", "ü": "ue", "ß": "ss"}


def spellings(text):
    """As it is, with ae or a for ä, and several words as one, as query.js joins them."""
    low = text.lower()
    ways = dict.fromkeys([low, *("".join(table.get(letter, letter) for letter in low) for table in (PLAIN, LONG))])
    return list(dict.fromkeys(re.sub(r"[^\w]|_", "", way) for way in ways))


def words_of(path):
    """Of lookup.json: names of subjects to what people call them, by language."""
    found = {}
    data = json.loads(path.read_text(encoding="utf-8"))
    for name, words in [(row["of"], row["words"]) for row in data["synonyms"]] + [(row["name"], row["words"]) for row in data["topics"]]:
        for language, more in words.items():
            found.setdefault(name, {"en": [], "de": []})[language] += more
    return found


def parts(name):
    """`getriebe[].dynamik.vb_max`, `P-AXIS-00212`, `AX3005`, word by word and joined; numbers also without zeros."""
    pieces = re.findall(r"[A-Za-z]+|\d+", name)
    bare = [piece.lstrip("0") for piece in pieces]
    return [*pieces, *bare, *("".join(some[begin:]) for some in (pieces, bare) for begin in range(len(pieces)))]


def enrich(path, language, subjects, words):
    """Adds to the index that mkdocs wrote. Tags count most, then titles; words of longer phrases are in the text alone."""
    index = json.loads(path.read_text(encoding="utf-8"))
    # German alone knows no numbers.
    index["config"]["lang"] = ["de", "en"] if language == "de" else ["en"]
    of_page = {}
    for kind, titles in subjects.titles.items():
        for name in titles:
            of_page.setdefault(subjects.pages[name].replace(".md", ".html"), []).append(name)
    seen = {}
    for entry in index["docs"]:
        page, _, section = entry["location"].partition("#")
        # The theme takes the text of a page from its first section.
        if page not in of_page or (section and seen.get(page)):
            continue
        names = of_page[page]
        called = {way: [word for name in names for one in dict.fromkeys([name, *name.split("/")]) for word in words.get(one, {}).get(way, [])]
                  for way in ("en", "de")}
        numbers = [subjects.also[name] for name in names if subjects.also.get(name)]
        every = called["en"] + called["de"]
        entry["text"] += " " + " ".join(dict.fromkeys([*every, *(way for word in every for way in spellings(word)),
                                                       *(piece for name in names + numbers for piece in parts(name))]))
        if not section:
            last = [name.split(".")[-1] for name in names]
            entry["tags"] = list(dict.fromkeys([*(part for name in names for part in name.split("/")), *last,
                                                *(number.rsplit("-", 1)[-1] for number in numbers),
                                                *(spellings(word)[0] for word in last + every)]))
        seen[page] = section
    if missing := set(of_page) - set(seen):
        raise SystemExit(f"site.py: the index lacks {', '.join(sorted(missing)[:5])}")
    path.write_text(json.dumps(index, ensure_ascii=False, separators=(",", ":")), encoding="utf-8")


# Of the search's worker: what is wrong, and how it is right.
MENDED = [
    # lunr compares nodes of its tree by a text of letters and numbers without anything between them: 1, 23 and 12, 3 are the same for
    # it. In an index with many numbers it finds words that are not there, and fails.
    (r"(=\w\+\w\+\w\.id)(?=\}return \w\})", r'\1+","'),
    # What query.js adds to words is not marked in the results.
    (r"(\w=\w\.replace\()(/\[\\s\*\+\\-:~\^\]\+/g)", r'\1/[~^]\\d+|\\b(?:title|text):/g,"").replace(\2'),
]


def mend(folder):
    (worker,) = (folder / "assets" / "javascripts" / "workers").glob("search.*.js")
    text = worker.read_text(encoding="utf-8")
    for wrong, right in MENDED:
        text, count = re.subn(wrong, right, text)
        if count != 1:
            raise SystemExit(f"site.py: {worker.name} is not the search that search.py knows; try it without MENDED")
    worker.write_text(text, encoding="utf-8")
