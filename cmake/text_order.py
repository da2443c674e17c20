#!/usr/bin/env python3
"""Writes cmake/text_order.ld: the functions that `axisc lint` runs through, in the order of their first use.

    cmake --preset static && cmake --build --preset static --target axisc
    cmake/text_order.py build/static >build/text_order.ld && mv build/text_order.ld cmake/

qemu-x86_64 (./setup.sh ci) writes down what runs, the linker's map says where it came from. The linker passes over names that
a later program no longer has, and what it does not find here stays where it was: an old file costs time, nothing else.
"""
import bisect
import pathlib
import re
import subprocess
import sys
import tempfile

PROJECT = pathlib.Path(__file__).resolve().parent.parent
# A sound list first, then what mistakes need besides.
INPUTS = ["samples/mill/x.lis", "samples/mistakes"]
SECTION = re.compile(r"^ (\.text\S*)\s+0x([0-9a-f]+)\s+0x([0-9a-f]+) (\S+)$", re.MULTILINE)
# The C library chooses among these for the processor it finds.
STRING_FUNCTIONS = "*libc.a:*(.text.avx .text.evex .text.evex512)"

HEAD = """/* Written by cmake/text_order.py: what `axisc lint` runs through lies together, in the order of its first use. Scattered over
   the program it is mapped in 45 pieces more, which is an eighth of the time of linting one list. */
SECTIONS
{
  .text.lint :
  {
"""
TAIL = """  }
}
INSERT BEFORE .text;
"""


def run_addresses(program, source):
    """Where code was first run, in this order."""
    with tempfile.NamedTemporaryFile() as log:
        command = ["qemu-x86_64", "-cpu", "max", "-d", "in_asm", "-D", log.name, program, "lint", "--cycle-time", "1ms"]
        status = subprocess.run(command + ["-j1", source], cwd=PROJECT, env={}, stdout=subprocess.DEVNULL).returncode
        if status not in (0, 1):  # without and with findings
            sys.exit(f"{program} ends with status {status}")
        text = pathlib.Path(log.name).read_text()
    return [int(address, 16) for address in re.findall(r"^0x([0-9a-f]+):", text, re.MULTILINE)]


def pattern(name, origin):
    """How the linker finds the section again. Compilers give each function a section, the C library each file."""
    if name != ".text" and "libc.a(" not in origin:
        return f"*({name})"
    archive = re.fullmatch(r".*/(\S+\.a)\((\S+)\)", "/" + origin)
    if not archive:
        return f"*{pathlib.Path(origin).name}({name})"
    library = re.sub(r"-[0-9.]+\.a$", "*.a", archive[1])
    return f"*{library}:{archive[2]}({name})"


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    memory = (build / "axisc.map").read_text().partition("\nLinker script and memory map\n")[2]
    sections = sorted((int(begin, 16), int(size, 16), pattern(name, origin))
                      for name, begin, size, origin in SECTION.findall(memory) if int(begin, 16))
    begins = [begin for begin, _, _ in sections]
    order = {}
    for source in INPUTS:
        for address in run_addresses(str(build / "bin/axisc"), source):
            begin, size, found = sections[bisect.bisect_right(begins, address) - 1]
            if begin <= address < begin + size:
                order.setdefault(found)
    order.setdefault(STRING_FUNCTIONS)
    sys.stdout.write(HEAD + "".join(f"    {line}\n" for line in order) + TAIL)


if __name__ == "__main__":
    main()
