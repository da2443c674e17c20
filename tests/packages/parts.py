#!/usr/bin/env python3
"""The bill of materials names what the program or the library is made of, and has what SPDX 2.3 asks for:

parts.py FOLDER SOURCES KIND: shared, static or windows, of the program; library or embedded, of the library that is
linked with others or contains them.
"""
import json
import re
import sys

FOLDER, SOURCES, KIND = sys.argv[1:]
OF_LIBRARY = KIND in ("library", "embedded")
NAME = "libaxisc" if OF_LIBRARY else "axisc"
# As vcpkg.json names what the project needs, with the names in the bill.
CONTAINED = {"boost-spirit": "Boost", "boost-multiprecision": "Boost", "fmt": "fmt", "nlohmann-json": "JSON for Modern C++", "cli11": "CLI11"}
LINKED_IN = {"libsodium": "libsodium", "pugixml": "pugixml", "zlib": "zlib"}
OF_TESTS = {"catch2", "rapidcheck", "valijson"}

with open(f"{SOURCES}/vcpkg.json", encoding="utf-8") as file:
    project = json.load(file)
with open(f"{FOLDER}/axisc.spdx.json", encoding="utf-8") as file:
    bill = json.load(file)
with open(f"{FOLDER}/third-party-licences.txt", encoding="utf-8") as file:
    licences = file.read()

assert set(project["dependencies"]) == set(CONTAINED) | set(LINKED_IN) | OF_TESTS
wanted = {NAME, "uPlot", *CONTAINED.values()} - ({"CLI11"} if OF_LIBRARY else set())
if KIND in ("static", "windows", "embedded"):
    wanted |= {*LINKED_IN.values(), "GCC runtime libraries"}
wanted |= {"static": {"glibc"}, "windows": {"mingw-w64"}}.get(KIND, set())
packages = {package["name"]: package for package in bill["packages"]}
assert set(packages) == wanted, set(packages) ^ wanted
assert packages[NAME]["versionInfo"] == project["version-string"]

assert bill["spdxVersion"] == "SPDX-2.3" and bill["dataLicense"] == "CC0-1.0" and bill["SPDXID"] == "SPDXRef-DOCUMENT"
assert re.fullmatch(r"urn:uuid:[0-9a-f-]{36}", bill["documentNamespace"])
assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", bill["creationInfo"]["created"])
assert bill["name"] and bill["creationInfo"]["creators"]
known = {"SPDXRef-DOCUMENT"}
for name, package in packages.items():
    assert re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", package["SPDXID"]) and package["SPDXID"] not in known
    known.add(package["SPDXID"])
    assert package["versionInfo"] and package["licenseDeclared"], name
    assert re.fullmatch(r"NOASSERTION|https://\S+", package["downloadLocation"]), name
    assert name == NAME or f"==== {name} {package['versionInfo']}: {package['licenseDeclared']}\n\n" in licences, name
for row in bill["relationships"]:
    assert {row["spdxElementId"], row["relatedSpdxElement"]} <= known
contained = {row["relatedSpdxElement"] for row in bill["relationships"] if row["relationshipType"] == "CONTAINS"}
assert contained == known - {"SPDXRef-DOCUMENT", "SPDXRef-axisc"}
print(f"{len(packages)} packages")
