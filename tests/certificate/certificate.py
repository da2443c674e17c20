#!/usr/bin/env python3
"""Compiler, `axisc certify`, examples/axim_check.c and check.py agree: certificate.py AXISC SOURCES FOLDER CC [LISTS]

LISTS random lists (20 unless said otherwise) are checked besides the samples.
"""
import os
import random
import re
import struct
import subprocess
import sys

AXISC, SOURCES, FOLDER, CC = sys.argv[1:5]
LISTS = int(sys.argv[5]) if len(sys.argv) > 5 else 20
EXAMPLE = os.path.join(SOURCES, "examples", "axim_check.c")
CHECKER = os.path.join(FOLDER, "axim_check")
SAMPLES = ("mill", "resonance/machine.json")
failures = 0


def run(*command):
    return subprocess.run(command, capture_output=True, text=True)


def expect(holds, what, done=None):
    global failures
    if not holds:
        failures += 1
        print("FAILED:", what, (done.stdout + done.stderr)[-600:] if done else "")


def shifted(crc):
    for _ in range(8):
        crc = crc >> 1 ^ (0x82F63B78 & -(crc & 1))
    return crc


TABLE = [shifted(octet) for octet in range(256)]


def checksum(octets):
    crc = 0xFFFFFFFF
    for octet in octets:
        crc = crc >> 8 ^ TABLE[(crc ^ octet) & 255]
    return crc ^ 0xFFFFFFFF


def section(image, wanted):
    for i in range(struct.unpack_from("<I", image, 28)[0]):
        kind, _, offset, _, _, count = struct.unpack_from("<IIQQII", image, 128 + 32 * i)
        if kind == wanted:
            return offset, count
    return None


def write(path, image):
    end = 128 + 32 * struct.unpack_from("<I", image, 28)[0]
    struct.pack_into("<I", image, 24, checksum(image[end:]))
    struct.pack_into("<I", image, 12, 0)
    struct.pack_into("<I", image, 12, checksum(image[:end]))
    with open(path, "wb") as file:
        file.write(image)


def the_checker():
    flags = ["-std=c99", "-O2", "-Wall", "-Wextra", "-pedantic", "-Werror"]
    done = run(CC, *flags, EXAMPLE, "-lm", "-o", CHECKER)
    expect(done.returncode == 0, "axim_check.c does not compile", done)
    with open(EXAMPLE, encoding="utf-8") as file:
        text = file.read()
    included = re.findall(r'#\s*include\s*([<"][^>"]*[>"])', text)
    expect(included == ["<math.h>", "<stdint.h>", "<stdio.h>", "<stdlib.h>", "<string.h>"],
           f"axim_check.c includes {included}")
    expect(text.count("\n") <= 450, "axim_check.c has more than 450 lines")


def compiled(name, source, *options):
    path = os.path.join(FOLDER, name + ".axim")
    if os.path.exists(path):
        os.remove(path)
    done = run(AXISC, "compile", source, "-o", path, *options)
    return path if done.returncode == 0 else None


def all_agree(path):
    for command in ([CHECKER], [AXISC, "certify"], [sys.executable, os.path.join(SOURCES, "tests/certificate/check.py")]):
        done = run(*command, path)
        expect(done.returncode == 0, f"{command} {path}", done)


def bounds_of(path):
    """Flags, gain_low and gain_high of each record."""
    with open(path, "rb") as file:
        image = file.read()
    first, count = section(image, 20)
    return [struct.unpack_from("<12xI8x2d", image, first + 128 * i) for i in range(count)]


def is_tight(path):
    for flags, low, high in bounds_of(path):
        expect(flags or high - low <= 1e-9 * high, f"{path}: the gain is within {low} ... {high} only")


def samples():
    for sample in SAMPLES:
        name = sample.replace("/", "-")
        path = compiled(name, os.path.join(SOURCES, "samples", sample))
        expect(path is not None, f"samples/{sample} is not compiled")
        all_agree(path)
    source = os.path.join(SOURCES, "samples", "mill")
    stripped = compiled("stripped", source, "--strip")
    all_agree(stripped)
    expect(section(open(stripped, "rb").read(), 20)[1] == 17, "a stripped image of the mill has not 17 records")
    without = compiled("without", source, "--no-bounds")
    expect(run(CHECKER, without).returncode == 2, "an image without bounds is not said to be unreadable")
    done = run(AXISC, "certify", without)
    expect(done.returncode == 0 and "claims no bounds" in done.stdout, "certify without bounds", done)


def random_list(draw):
    lines = ["kopf.achs_nr 1", "kopf.log_achs_name X", "kenngr.achs_typ 1",
             f"getriebe[0].dynamik.vb_max {draw.randint(1000, 900000)}", "getriebe[0].dynamik.a_max 3000"]
    for i in range(draw.randint(1, 3)):
        kind = draw.choice(["LOWPASS", "HIGHPASS", "BANDPASS", "BANDSTOP", "PT1", "PT2", "ALLPASS", "TIME_DELAY"])
        lines += [f"filter[{i}].type {kind}", f"filter[{i}].enable 1",
                  f"filter[{i}].fg_f0 {10 ** draw.uniform(0.4, 2.6):.4g}",
                  f"filter[{i}].order {draw.randint(1, 3)}", f"filter[{i}].guete {10 ** draw.uniform(-0.3, 1):.3g}",
                  f"filter[{i}].prototype {draw.randint(1, 3)}",
                  f"filter[{i}].time_constant {draw.randint(1000, 50000)}",
                  f"filter[{i}].share_percent {draw.choice([100, 100, draw.randint(1, 99)])}"]
    if draw.random() < 0.5:
        lines += ["filter_fir.enable 1", f"filter_fir.type {draw.randint(0, 2)}",
                  f"filter_fir.order {draw.randint(2, 120)}"]
    return "\n".join(lines) + "\nEnde\n"


def random_lists():
    draw = random.Random(20261127)
    found = 0
    for attempt in range(6 * LISTS):
        if found == LISTS:
            return
        path = os.path.join(FOLDER, "random.lis")
        with open(path, "w", encoding="utf-8") as file:
            file.write(random_list(draw))
        image = compiled("random", path, "--quiet", "--cycle-time", draw.choice(["1ms", "500us", "2ms"]))
        if image:
            found += 1
            all_agree(image)
            is_tight(image)
    expect(False, f"only {found} of {LISTS} random lists were compiled")


def without_certain_rest():
    """Filters next to half the sampling rate, and very slow ones: claims stay true, and are confirmed.

    The first gain is a sum of |h| in 113 bits until less than 1e-24 is left.
    """
    others = ["filter[0].order 2", "filter[0].guete 9.49", "filter[0].prototype 2"]
    others += ["filter[1].type ALLPASS", "filter[1].enable 1", "filter[1].fg_f0 125.2", "filter[1].order 1",
               "filter[2].type BANDSTOP", "filter[2].enable 1", "filter[2].fg_f0 15.62", "filter[2].order 2",
               "filter[2].guete 4.89", "filter[2].prototype 2", "filter[2].share_percent 1"]
    cases = [("2ms", ["filter[0].type BANDSTOP", "filter[0].enable 1", "filter[0].fg_f0 249.5", *others], 3.1230862194490743),
             ("1ms", ["filter[0].type LOWPASS", "filter[0].enable 1", "filter[0].fg_f0 499.9993",
                      "filter[0].order 2", "filter[0].prototype 2"], None),
             ("1ms", [f"filter[{i}].{line}" for i in range(3)
                      for line in ("type LOWPASS", "enable 1", "fg_f0 499.9993", "order 2", "prototype 1")], 1),
             # Slower than any walk; |H| is 1 at half the sampling rate, as that of low-passes at 0 Hz.
             ("1ms", [f"filter[{i}].{line}" for i in range(3)
                      for line in ("type HIGHPASS", "enable 1", "fg_f0 2e-6", "order 6", "prototype 1")], 1)]
    for cycle_time, lines, gain in cases:
        path = os.path.join(FOLDER, "fast.lis")
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(["kopf.achs_nr 1", "kenngr.achs_typ 1", *lines, "Ende\n"]))
        image = compiled("fast", path, "--quiet", "--cycle-time", cycle_time)
        expect(image is not None, f"{lines[:2]} is not compiled")
        all_agree(image)
        [(flags, low, high)] = bounds_of(image)
        expect(flags == 1, f"{lines[:2]} is no majorant")
        expect(high < 1e15 and (gain is None or low <= gain <= high), f"{lines[:2]}: gain {gain} is outside {low} ... {high}")


def next_to_nothing():
    """A band-pass behind a slow PT2 lets a millionth through: roundings count more than what is left."""
    path = os.path.join(FOLDER, "nothing.lis")
    with open(path, "w", encoding="utf-8") as file:
        file.write("kopf.achs_nr 1\nkenngr.achs_typ 1\ngetriebe[0].dynamik.vb_max 803628\n"
                   "getriebe[0].dynamik.a_max 3000\nfilter[0].type PT2\nfilter[0].enable 1\n"
                   "filter[0].order 2\nfilter[0].time_constant 39285\nfilter[1].type BANDPASS\nfilter[1].enable 1\n"
                   "filter[1].fg_f0 125.2\nfilter[1].order 3\nfilter[1].guete 8.94\nfilter[1].prototype 2\n"
                   "filter_fir.enable 1\nfilter_fir.type 2\nfilter_fir.order 98\nEnde\n")
    image = compiled("nothing", path, "--quiet", "--cycle-time", "2ms")
    expect(image is not None, "the list of the small gain is not compiled")
    expect(0 < bounds_of(image)[-1][2] < 1e-5, f"the gain is not small: {bounds_of(image)}")
    all_agree(image)
    is_tight(image)


def shortest_fade():
    """One whose added acceleration is 2e-7 of its limit below it: the compiler's own condition, and no more."""
    path = os.path.join(FOLDER, "shortest.lis")
    with open(path, "w", encoding="utf-8") as file:
        file.write("kopf.achs_nr 1\nkenngr.achs_typ 1\ngetriebe[0].dynamik.vb_max 830452\n"
                   "getriebe[0].dynamik.a_max 3000\nfilter[0].type ALLPASS\nfilter[0].enable 1\n"
                   "filter[0].fg_f0 11.6\nfilter[0].order 2\nfilter[0].prototype 3\n"
                   "filter_fir.enable 1\nfilter_fir.type 2\nfilter_fir.order 96\nEnde\n")
    image = compiled("shortest", path, "--quiet", "--cycle-time", "1ms")
    expect(image is not None, "the list of the shortest fade is not compiled")
    all_agree(image)


def refused(image, what):
    path = os.path.join(FOLDER, "changed.axim")
    write(path, image)
    expect(run(CHECKER, path).returncode == 1, f"{what} is not refused")


def mutations_of(name):
    """Every field of every record, moved to the wrong side by 2^-38, or by one."""
    with open(os.path.join(FOLDER, name + ".axim"), "rb") as file:
        right = bytearray(file.read())
    first, count = section(right, 20)
    cases = 0
    for record in range(first, first + 128 * count, 128):
        for field in range(24, 112, 8):
            image = bytearray(right)
            if field == 96:
                rest = struct.unpack_from("<Q", image, record + field)[0]
                if rest == 0:
                    continue
                struct.pack_into("<Q", image, record + field, rest - 1)
            else:
                value = struct.unpack_from("<d", image, record + field)[0]
                if value == 0:
                    continue
                struct.pack_into("<d", image, record + field, value * (1 + (1 if field == 24 else -1) * 2.0**-38))
            refused(image, f"{name}: record at {record}, field at {field}")
            cases += 1
        for field in range(0, 24, 4):
            image = bytearray(right)
            struct.pack_into("<I", image, record + field, struct.unpack_from("<I", image, record + field)[0] ^ 1)
            refused(image, f"{name}: record at {record}, number at {field}")
            cases += 1
    return cases


def mutations():
    # Stripped images are short, and checksums cost time here.
    cases = mutations_of("stripped")
    draw = random.Random(815)
    for _ in range(400):
        if cases >= 1000:
            break
        with open(os.path.join(FOLDER, "random.lis"), "w", encoding="utf-8") as file:
            file.write(random_list(draw))
        if compiled("short", os.path.join(FOLDER, "random.lis"), "--quiet", "--strip", "--cycle-time", "1ms"):
            cases += mutations_of("short")
    expect(cases >= 1000, f"only {cases} mutations")
    print(f"{cases} mutations")


def short_fade():
    with open(os.path.join(FOLDER, "stripped.axim"), "rb") as file:
        image = bytearray(file.read())
    path = os.path.join(FOLDER, "changed.axim")
    banks, _ = section(image, 9)
    struct.pack_into("<I", image, banks + 64 + 36, 20)
    write(path, image)
    done = run(CHECKER, path)
    expect(done.returncode == 1 and "change of kernels" in done.stdout, "a fade that is too short", done)
    done = run(AXISC, "certify", path)
    expect(done.returncode == 1, "certify and a fade that is too short", done)


def main():
    the_checker()
    samples()
    random_lists()
    mutations()
    without_certain_rest()
    next_to_nothing()
    shortest_fade()
    short_fade()
    print("certificates:", "FAILED" if failures else "all agree")
    return 1 if failures else 0


sys.exit(main())
