#!/usr/bin/env python3
"""The printed JSON schemas, for an implementation that is not ours: schemas.py AXISC SOURCES."""
import copy
import json
import os
import subprocess
import sys

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed: not tried")
    sys.exit(77)

AXISC, SOURCES = sys.argv[1:]


def read(path):
    with open(os.path.join(SOURCES, path), encoding="utf-8") as file:
        return json.load(file)


def machine_files():
    for folder, _, files in os.walk(os.path.join(SOURCES, "samples")):
        if "machine.json" in files:
            yield os.path.join(folder, "machine.json")


def changed(document, change):
    other = copy.deepcopy(document)
    change(other)
    return other


def misspelt(key):
    return lambda document: document.update({key + "x": document.pop(key)})


FILES = {
    "machine": list(machine_files()),
    "settings": [],
    "plant": ["samples/motion/rack/plant.json"],
    "schema": ["schema/axis-parameters.json"],
    "finding": [],
}
FINDINGS = subprocess.run([AXISC, "lint", "samples/mistakes", "--format", "jsonl"], cwd=SOURCES, capture_output=True, text=True)
EXAMPLES = {
    "settings": [{"cycle_time_us": 250, "disable": ["AX4007"], "severity": {"AX3013": "error"}}],
    "finding": [json.loads(line) for line in FINDINGS.stdout.splitlines()],
}
MISTAKES = {
    "machine": [misspelt("axes"), lambda d: d.update(cycle_time_us="1ms"), lambda d: d.update(axes=[])],
    "settings": [misspelt("disable"), lambda d: d.update(cycle_time_us=0), lambda d: d["severity"].update(AX3013="fatal")],
    "plant": [misspelt("plants"), lambda d: d["plants"][0].pop("name"), lambda d: d["plants"][0].update(load_mass_kg=-1)],
    "finding": [misspelt("code"), lambda d: d.update(severity="fatal"), lambda d: d.update(line=0), lambda d: d.pop("fix")],
    "schema": [misspelt("parameters"), lambda d: d.update(version=2), lambda d: d["parameters"][0].update(type="FLOAT")],
}

tried = 0
for kind, paths in FILES.items():
    text = subprocess.run([AXISC, "schema", kind], check=True, capture_output=True, text=True).stdout
    schema = json.loads(text)
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    documents = [read(path) for path in paths] + EXAMPLES.get(kind, [])
    assert documents, kind
    for document in documents:
        validator.validate(document)
        tried += 1
    for mistake in MISTAKES[kind]:
        assert not validator.is_valid(changed(documents[-1], mistake)), (kind, mistake)
print(f"{tried} files are valid, {sum(map(len, MISTAKES.values()))} mistakes are refused")
