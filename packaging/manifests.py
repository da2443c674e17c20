"""How package managers and pipelines get the program: manifests for winget and scoop, and a container file."""
import json
import pathlib

import artefacts

WINGET = "1.6.0"
LICENCE = "MIT"


def block(value, indent=""):
    """YAML of nested rows and lists. JSON's strings are YAML's."""
    lines = []
    for key, inner in value.items():
        if not isinstance(inner, list):
            lines.append(f"{indent}{key}: {json.dumps(inner, ensure_ascii=False)}")
            continue
        lines.append(f"{indent}{key}:")
        for item in inner:
            rows = block(item, indent + "  ") if isinstance(item, dict) else [indent + "  " + json.dumps(item, ensure_ascii=False)]
            lines += [f"{indent}- {rows[0].lstrip()}", *rows[1:]]
    return lines


def yaml(manifest, rows):
    schema = f"# yaml-language-server: $schema=https://aka.ms/winget-manifest.{manifest}.{WINGET}.schema.json"
    return "\n".join([schema, *block({**rows, "ManifestType": manifest, "ManifestVersion": WINGET})]) + "\n"


def winget(project, archive, digest):
    """The three files that microsoft/winget-pkgs takes. The program runs where it is unpacked, as `axisc`."""
    program, _ = artefacts.inside(archive, "bin/axisc.exe")
    identifier = f"{project.owner}.axisc"
    same = {"PackageIdentifier": identifier, "PackageVersion": project.version}
    return {
        f"{identifier}.yaml": yaml("version", {**same, "DefaultLocale": "en-US"}),
        f"{identifier}.installer.yaml": yaml("installer", {
            **same, "InstallerType": "zip", "NestedInstallerType": "portable",
            "NestedInstallerFiles": [{"RelativeFilePath": program.replace("/", "\\"), "PortableCommandAlias": "axisc"}],
            "MinimumOSVersion": "10.0.18362.0", "ReleaseDate": project.day,
            "Installers": [{"Architecture": "x64", "InstallerUrl": project.address_of(archive.name), "InstallerSha256": digest.upper()}]}),
        f"{identifier}.locale.en-US.yaml": yaml("defaultLocale", {
            **same, "PackageLocale": "en-US", "Publisher": "The axisc authors", "PublisherUrl": project.homepage,
            "PackageName": "axisc", "PackageUrl": project.homepage, "License": LICENCE,
            "LicenseUrl": f"{project.homepage}/blob/{project.tag}/LICENSE", "ShortDescription": project.description,
            "Moniker": "axisc", "Tags": ["cnc", "isg", "linter", "motion-control", "twincat"],
            "ReleaseNotesUrl": f"{project.homepage}/releases/tag/{project.tag}"}),
    }


def scoop(project, archive, digest):
    """A manifest that `scoop install ADDRESS` takes; the name of the file becomes that of the program."""
    program, _ = artefacts.inside(archive, "bin/axisc.exe")
    folder, _, inner = program.partition("/")
    return {"axisc.json": json.dumps({
        "version": project.version, "description": project.description, "homepage": project.homepage, "license": LICENCE,
        "architecture": {"64bit": {"url": project.address_of(archive.name), "hash": digest, "extract_dir": folder}},
        "bin": inner.replace("/", "\\"),
    }, indent=2) + "\n"}


def container(project, archive, digest):
    text = (pathlib.Path(__file__).parent / "Containerfile.in").read_text(encoding="utf-8")
    for key, value in (("VERSION", project.version), ("ARCHIVE", project.address_of(archive.name)), ("SHA256", digest),
                       ("HOMEPAGE", project.homepage)):
        text = text.replace(f"@{key}@", value)
    return {"Containerfile": text}
