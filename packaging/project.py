"""What the sources say of the project: version, day, what is new, the commit, and the address where it is published.

The address has one place, HOMEPAGE_URL of project() in CMakeLists.txt; the variable AXISC_HOMEPAGE takes its place, for a copy
that is published elsewhere. OWNER in it stands for an account that nobody has named yet: nothing is released from there.
"""
import os
import pathlib
import re
import subprocess
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parent.parent
PLACEHOLDER = "OWNER"
AS_USED = r"(?:axisc[:@-]v?|rev: v|/v)(\d+\.\d+\.\d+)"  # by those who follow a document
VERSIONS = {
    "vcpkg.json": r'"version-string": "([^"]*)"',
    "editor/clients/vscode/package.json": r'^  "version": "([^"]*)"',
    "python/axisc/_library.py": r'^version = "([^"]*)"',
    "web/package.json": r'^  "version": "([^"]*)"',
    "editor/clients/vscode/CHANGELOG.md": r"\A(?:(?!## ).*\n)*## ([\d.]+|\w+)",  # the newest
    "action.yml": AS_USED,
    "templates/axisc.yml": AS_USED,
    "docs/installation.md": AS_USED,
    "docs/packages.md": AS_USED,
}


class Refused(Exception):
    """Why there is no release, and what to do about it."""


def git(*words):
    done = subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True)
    if done.returncode != 0:
        raise Refused(f"git {words[0]} failed: {done.stderr.strip()}; releases are made from a clone of the repository")
    return done.stdout.strip()


@dataclass(frozen=True)
class Project:
    version: str
    description: str
    homepage: str
    heading: str  # of the newest section of CHANGELOG.md, without the hashes
    news: str     # the text below it
    released: list[str]  # the versions of the older sections

    @property
    def tag(self):
        return f"v{self.version}"

    @property
    def owner(self):
        return self.homepage.split("/")[-2]

    @property
    def day(self):
        return self.heading.split("(")[-1].rstrip(")")

    def address_of(self, name):
        """Of a file of the release, on GitHub and on servers that have its addresses (Forgejo, Gitea)."""
        return f"{self.homepage}/releases/download/{self.tag}/{name}"


def read():
    lines = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    call = re.search(r"^project\(axisc\b([^)]*)\)", lines, re.MULTILINE)
    facts = {key: re.search(pattern, call[1]) if call else None
             for key, pattern in (("VERSION", r"\bVERSION\s+([\d.]+)"), ("DESCRIPTION", r'\bDESCRIPTION\s+"([^"]*)"'),
                                  ("HOMEPAGE_URL", r'\bHOMEPAGE_URL\s+"([^"]*)"'))}
    for key, found in facts.items():
        if not found:
            raise Refused(f"CMakeLists.txt: project() has no {key}; add it")
    sections = re.split(r"^## ", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), flags=re.MULTILINE)
    heading, _, news = sections[1].partition("\n") if len(sections) > 1 else ("", "", "")
    homepage = os.environ.get("AXISC_HOMEPAGE") or facts["HOMEPAGE_URL"][1]
    released = [section.split(" ", 1)[0] for section in sections[2:]]
    return Project(facts["VERSION"][1], facts["DESCRIPTION"][1], homepage.rstrip("/"), heading.strip(), news.strip(), released)


def is_published(homepage):
    return re.fullmatch(r"https://[\w.:-]+(/[\w.-]+){2,}", homepage) is not None and PLACEHOLDER not in homepage.split("/")


def other_versions(project):
    """Where another version is written than that of project()."""
    for name, pattern in VERSIONS.items():
        found = re.findall(pattern, (ROOT / name).read_text(encoding="utf-8"), re.MULTILINE)
        others = sorted({*found} - {project.version})
        if others or not found:
            yield f"{name} has {f'the version {others[0]}' if others else 'no version'}; write {project.version}"
    young = [path.parent.name for path in sorted(ROOT.glob("validator/rules/*/facts.json")) if '"unreleased"' in path.read_text(encoding="utf-8")]
    if young:
        yield (f"{len(young)} rules say that they are not released ({young[0]}, …); write \"since\": \"{project.version}\" into "
               "validator/rules/*/facts.json, then the table anew: axisc explain --all >docs/rules.md")


def check(project):
    """Refuses what must not become a release. All that is wrong is said at once."""
    wrong = []
    if not re.fullmatch(re.escape(project.version) + r" \(\d{4}-\d\d-\d\d\)", project.heading):
        wrong.append(f"CHANGELOG.md: the newest heading is \"{project.heading}\", project() in CMakeLists.txt has the version "
                     f"{project.version}; write \"## {project.version} (YYYY-MM-DD)\", or the new version into project()")
    if project.version in project.released:
        wrong.append(f"CHANGELOG.md: {project.version} has a section below the newest one: it is released already; write the next version "
                     "into project() in CMakeLists.txt")
    wrong += other_versions(project)
    if not is_published(project.homepage):
        wrong.append(f"{project.homepage} is not an address at which anything is published; write it into HOMEPAGE_URL of project() "
                     "in CMakeLists.txt, or set AXISC_HOMEPAGE=https://HOST/ACCOUNT/axisc")
    if changed := git("status", "--porcelain"):
        wrong.append("the working folder differs from the commit; commit or remove: "
                     + ", ".join(line.split(maxsplit=1)[1] for line in changed.split("\n")))
    tags = [tag for tag in git("tag", "--points-at", "HEAD").split() if tag.startswith("v")]
    if tags != [project.tag]:
        wrong.append(f"the commit has {'the tag ' + ' '.join(tags) if tags else 'no tag'}, the version is {project.version}; "
                     + ("delete the tag, or change the version" if tags else f"git tag {project.tag}"))
    if wrong:
        raise Refused("\nrelease: ".join(wrong))
