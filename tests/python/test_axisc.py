"""The package gives what the program gives, on every sample: findings, repairs, images, answers, outputs.

Needs the shared libraries (AXISC_LIBRARIES) and the program (AXISC); started by ctest in the project's folder.
"""

import array
import contextlib
import csv
import hashlib
import importlib.util
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import unittest

import axisc

try:
    import numpy
except ImportError:
    numpy = None

AXISC = os.environ["AXISC"]
SAMPLES = pathlib.Path("samples")
LISTS = sorted(str(path) for path in SAMPLES.rglob("*") if path.suffix in (".lis", ".nc"))
MACHINES = ["samples/mill", "samples/controller", "samples/tutorial/machine.json", "samples/motion/rack", "samples/controller-xml"]
MILL = "samples/mill"
CIRCLE = SAMPLES / "circle"


def program(*words, check=False):
    done = subprocess.run([AXISC, *words], capture_output=True, check=False)
    if check and done.returncode != 0:
        raise AssertionError(done.stderr.decode())
    return done


def image_by_program(path):
    """Its SHA-256; None where there is none. A list by itself does not say its cycle time."""
    with tempfile.TemporaryDirectory() as folder:
        image = pathlib.Path(folder, "x.axim")
        words = ["compile", "--quiet", path, "-o", str(image)]
        if program(*words).returncode == 2:
            program(*words, "--cycle-time", "1ms")
        return hashlib.sha256(image.read_bytes()).hexdigest() if image.exists() else None


class Findings(unittest.TestCase):
    def test_every_list_and_program(self):
        self.assertGreater(len(LISTS), 90)
        for language in ("en", "de"):
            with axisc.Workspace(language=language) as workspace:
                for path in LISTS[:: 1 if language == "en" else 7]:
                    with self.subTest(path):
                        lint = program("lint", "--lang", language, "--format", "json", path)
                        found = workspace.machine(path).check()
                        wanted = json.loads(lint.stdout)["diagnostics"]
                        self.assertEqual([finding.document for finding in found], wanted)

    def test_folders(self):
        for path in MACHINES:
            with self.subTest(path):
                wanted = json.loads(program("lint", "--format", "json", path).stdout)["diagnostics"]
                self.assertEqual([finding.document for finding in axisc.open(path).check()], wanted)

    def test_a_finding_has_attributes_and_a_line(self):
        finding = axisc.open("samples/tutorial/x.lis").check()[0]
        self.assertEqual((finding.code, finding.line, finding.axis), ("AX1005", 6, "X"))
        self.assertEqual(str(finding), "samples/tutorial/x.lis:6:37: error[AX1005]: `3000,0` has a decimal comma")

    def test_unsaved_text(self):
        with axisc.Workspace(cycle_time="1ms") as workspace:
            workspace.put("nowhere.lis", "kopf.achs_nr 01\n")
            machine = workspace.machine("nowhere.lis")
            self.assertEqual([finding.code for finding in machine.check()], ["AX1006"])
            self.assertEqual(machine.fix(all=True), {"nowhere.lis": b"kopf.achs_nr 1\n"})
            self.assertEqual(machine.check(), [])
            workspace.drop("nowhere.lis")
            with self.assertRaises(axisc.NotFound):
                machine.check()

    def test_repairs(self):
        for all_of_them, option in ((False, "--fix"), (True, "--fix=all")):
            path = pathlib.Path("samples/tutorial/x.lis")
            with tempfile.TemporaryDirectory() as folder:
                copy = pathlib.Path(folder, "x.lis")
                copy.write_bytes(path.read_bytes())
                program("lint", "--cycle-time", "1ms", option, str(copy))
                repaired = copy.read_bytes()
                copy.write_bytes(path.read_bytes())
                changed = axisc.open(copy, cycle_time="1ms").fix(all=all_of_them)
                self.assertEqual(changed.get(str(copy), path.read_bytes()), repaired)
                self.assertEqual(copy.read_bytes(), path.read_bytes(), "nothing is written")


class Images(unittest.TestCase):
    def test_images(self):
        compiled = 0
        wanted = {}  # by machine: a list belongs to one, or is one by itself
        for path in MACHINES + LISTS:
            with self.subTest(path):
                machine = axisc.open(path, cycle_time="1ms")
                found = machine.answer("machines")["machines"]
                name = found[0]["path"] if found else path  # of a file without an axis there is none
                if name not in wanted:
                    wanted[name] = image_by_program(name)
                try:
                    image = hashlib.sha256(machine.compile()).hexdigest()
                    compiled += 1
                except axisc.Error:
                    image = None
                self.assertEqual(image, wanted[name])
        self.assertGreater(compiled, 40)

    def test_options(self):
        with tempfile.TemporaryDirectory() as folder:
            image = pathlib.Path(folder, "x.axim")
            program("compile", "-q", MILL, "-o", str(image), "--strip", "--no-bounds", "--image-version", "7", check=True)
            stripped = axisc.open(MILL).compile(strip=True, bounds=False, image_version=7)
            self.assertEqual(stripped, image.read_bytes())
        with self.assertRaisesRegex(axisc.BadArgument, "4294967295"):
            axisc.open(MILL).compile(image_version=-1)

    def test_errors_prevent_an_image_and_come_with_their_findings(self):
        with self.assertRaisesRegex(axisc.FindingsError, "AX1005") as caught:
            axisc.open("samples/tutorial/x.lis").compile()
        self.assertIn("AX2001", [finding.code for finding in caught.exception.findings])


class Answers(unittest.TestCase):
    def same(self, answer, *words):
        self.assertEqual(answer, json.loads(program(*words, "--format", "json").stdout))

    def same_or_none(self, ask, *words):
        """The same answer, or none on both sides; whether there is one."""
        done = program(*words, "--format", "json")
        if done.returncode == 0:
            self.assertEqual(ask(), json.loads(done.stdout))
            return True
        with self.assertRaises(axisc.FindingsError if done.returncode == 1 else axisc.Unusable):
            ask()
        return False

    def test_documents_of_every_machine(self):
        paths = {found["path"] for found in axisc.open("samples").answer("machines")["machines"] if not found["alone"]}
        answered = 0
        for path in sorted(paths.union(MACHINES)):
            with self.subTest(path):
                machine = axisc.open(path)
                if path.endswith(".tsproj"):  # no machine file can say this, so that the command refuses
                    self.assertEqual({axis["list"] for axis in machine.machine()["axes"]}, {path})
                else:
                    self.same(machine.machine(), "machine", path)
                answered += self.same_or_none(machine.contour, "contour", path)
                answered += self.same_or_none(machine.delay_budget, "contour", "--budget", path)
                answered += self.same_or_none(lambda machine=machine: machine.circle(feed=1000, radius=50), "circle", path, "--feed", "1000", "--radius", "50")
        self.assertGreater(answered, 30)

    def test_documents(self):
        machine = axisc.open(MILL)
        self.same(machine.get("X", "filter[0].order"), "get", MILL, "X", "filter[0].order")
        self.same(machine.diff("samples/tutorial/y.lis"), "diff", "samples/tutorial/y.lis", MILL)
        self.same(axisc.explain("AX3005"), "explain", "AX3005")
        self.assertEqual(machine.picture("step", axis="X").encode(), program("plot", MILL, "--kind", "step", "--axis", "X", "-o", "-").stdout)
        self.assertEqual(machine.report().encode(), program("report", MILL, "-o", "-").stdout)
        self.assertEqual(machine.answer("machine", format="text"), program("machine", MILL).stdout.decode())

    def test_identification(self):
        machine, moves = "samples/resonance/machine.json", "samples/resonance/moves.csv"
        self.same(axisc.open(machine).identify(moves, axis="X"), "identify", machine, moves, "--axis", "X")
        with self.assertRaisesRegex(axisc.Unusable, "recording"):
            axisc.open(machine).identify(axis="X")

    def test_circles(self):
        machine = axisc.open(MILL)
        self.same(machine.circle(feed=[1000, 4000], radius=50, plane="XY", tolerance=10),
                  "circle", MILL, "--feed", "1000,4000", "--radius", "50", "--plane", "XY", "--tolerance", "10")
        files = [CIRCLE / "ccw.csv", CIRCLE / "cw.csv"]
        recorded = axisc.open(CIRCLE)
        self.same(recorded.circle(*files), "circle", CIRCLE, *files)
        self.same(recorded.circle(files[0], unit="mm", numbers="raw", actual=["X=4", "Y=5"]),
                  "circle", CIRCLE, files[0], "--unit", "mm", "--raw", "--actual", "X=4", "--actual", "Y=5")
        self.assertEqual(recorded.circle(*files, format="svg").encode(), program("circle", CIRCLE, *files, "-o", "-").stdout)
        with self.assertRaisesRegex(axisc.Unusable, "--feed and --radius"):
            machine.circle()
        with self.assertRaisesRegex(axisc.Unusable, "measuring instrument"):
            recorded.circle(files[0], external=True, setpoint="X=2")

    def test_images(self):
        with tempfile.TemporaryDirectory() as folder:
            image = pathlib.Path(folder, "x.axim")
            image.write_bytes(axisc.open(MILL).compile())
            self.same(axisc.inspect(image), "inspect", str(image))
            self.same(axisc.response(image, axis="X", frequencies=[1, 12.5]), "response", str(image), "--axis", "X", "--frequencies", "1,12.5")
            of_bytes = axisc.inspect(image.read_bytes(), axis="Y")
            self.assertEqual([axis["name"] for axis in of_bytes["axes"]], ["Y"])

    def test_language_server(self):
        with axisc.Workspace() as workspace:
            replies = workspace.messages({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"capabilities": {}}})
            self.assertIn("capabilities", replies[0]["result"])
            shutdown, leave = ({"jsonrpc": "2.0", "id": 2, "method": "shutdown"}, {"jsonrpc": "2.0", "method": "exit"})
            self.assertEqual([reply["id"] for reply in workspace.messages(shutdown, leave)], [2])
            self.assertEqual(workspace.messages(shutdown), [])

    def test_what_counts_whatever_files_say(self):
        for options, expected in (({}, 1000), ({"cycle_time": "2ms"}, 1000), ({"override_cycle_time": "2ms"}, 2000)):
            self.assertEqual(axisc.open(MILL, **options).machine()["cycle_time_us"], expected)


class Mistakes(unittest.TestCase):
    def test_words(self):
        with self.assertRaisesRegex(axisc.BadArgument, "en, de"):
            axisc.open(MILL, language="fr")
        with self.assertRaisesRegex(axisc.BadArgument, "soon"):
            axisc.Workspace(cycle_time="soon")
        with self.assertRaisesRegex(axisc.BadArgument, "V3.1.3075.04"):
            axisc.Workspace(build="3")
        with self.assertRaisesRegex(axisc.BadArgument, "axis_typ"):
            axisc.Workspace(axis_typ="T")
        with self.assertRaisesRegex(axisc.BadArgument, "machines, filters"):
            axisc.open(MILL).answer("weather")
        with self.assertRaisesRegex(axisc.Unusable, "the axes are|axis"):
            axisc.open(MILL).picture("step", axis="Q")
        with self.assertRaises(axisc.NotFound):
            axisc.open("samples/none")
        with self.assertRaises(axisc.BadArgument):
            axisc.Workspace().read(b"\xff.lis".decode("utf-8", "surrogateescape"))
        with self.assertRaisesRegex(axisc.Unusable, "AXISRT_WRONG_MAGIC"):
            axisc.inspect(b"no image" * 100)

    def test_a_closed_workspace(self):
        workspace = axisc.Workspace()
        workspace.close()
        with self.assertRaises(axisc.BadArgument):
            workspace.read("x.lis")


class Callbacks(unittest.TestCase):
    def test_files_from_elsewhere(self):
        files = {"shop/x.lis": b"kopf.achs_nr 1\nfilter[0].fgf0 12\n"}
        machine = axisc.open("shop/x.lis", read=files.get, cycle_time="1ms")
        self.assertIn("AX2001", [finding.code for finding in machine.check()])
        self.assertEqual(list(machine.fix(all=True)), ["shop/x.lis"])

    def test_the_folder_of_a_machine(self):
        root = pathlib.Path(MILL).resolve()
        asked = []

        def read(path):
            asked.append(path)
            file = root / pathlib.PurePosixPath(path).relative_to("/elsewhere")
            return file.read_bytes() if file.is_file() else None

        machine = axisc.open("/elsewhere/machine.json", read=read, names=lambda folder: os.listdir(root))
        self.assertEqual(len(machine.check()), len(axisc.open(MILL).check()))
        self.assertIn("/elsewhere/x.lis", asked)
        asked.clear()
        machine.check()
        self.assertEqual(len(asked), len(set(asked)), "a file is asked for once")

    def test_what_a_callback_raises_arrives(self):
        def read(path):
            raise ZeroDivisionError(path)

        with self.assertRaises(ZeroDivisionError):
            axisc.open("x.lis", read=read).check()

    def test_cancel(self):
        def read(path):
            workspace.cancel()
            return b"kopf.achs_nr 1\n"

        with axisc.Workspace(read=read) as workspace:
            with self.assertRaises(axisc.Cancelled):
                workspace.machine("x.lis").check()

    def test_one_call_at_a_time(self):
        def read(path):
            workspace.read("y.lis")

        with axisc.Workspace(read=read) as workspace:
            with self.assertRaises(axisc.Busy):
                workspace.machine("x.lis").check()

    def test_workspaces_in_threads(self):
        wanted = [finding.document for finding in axisc.open(MILL).check()]
        found = []
        threads = [threading.Thread(target=lambda: found.append([finding.document for finding in axisc.open(MILL).check()])) for _ in range(16)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [wanted] * 16)


class Executed(unittest.TestCase):
    def setUp(self):
        self.image = axisc.open(MILL).compile()

    def outputs_of_run(self, rows):
        """What `axisc run` puts out for these setpoints."""
        with tempfile.TemporaryDirectory() as folder:
            image, table = pathlib.Path(folder, "x.axim"), pathlib.Path(folder, "in.csv")
            image.write_bytes(self.image)
            axes = axisc.Runtime(self.image).axes
            table.write_text("\n".join([",".join(axes), *(",".join(map(repr, row)) for row in rows)]) + "\n")
            done = program("run", str(image), "--input", str(table), "--level", "auto", check=True)
            found = list(csv.DictReader(io.StringIO(done.stdout.decode())))
            return [[float(row[axis]) for axis in axes] for row in found]

    def test_blocks_of_cycles(self):
        runtime = axisc.Runtime(self.image)
        self.assertEqual(runtime.axes, ["X", "Y", "Z", "S"])
        rows = [[100.0 * cycle, -3.5 * cycle, 7.0, 0.25 * cycle * cycle] for cycle in range(200)]
        for axis in runtime.axes:
            runtime.reset(axis, 0.0)
        self.assertEqual(runtime.run(rows), self.outputs_of_run(rows))
        self.assertEqual(runtime.status, "AXISRT_OK")

    def test_blocks_of_any_length_and_form(self):
        flat = array.array("d", (float(i % 97) for i in range(4 * 300)))
        whole = axisc.Runtime(self.image)
        whole.reset(None, 0.0)
        wanted = whole.run(flat)
        self.assertIsInstance(wanted, array.array)
        parts = axisc.Runtime(self.image)
        parts.reset(None, 0.0)
        self.assertEqual(parts.run(flat[:400]) + parts.run(flat[400:]) + parts.run(flat[:0]), wanted)
        if numpy is not None:
            of_numpy = axisc.Runtime(self.image)
            of_numpy.reset(None, 0.0)
            block = numpy.array(flat).reshape(-1, 4)
            out = of_numpy.run(block)
            self.assertEqual(out.shape, (300, 4))
            self.assertEqual(out.ravel().tolist(), wanted.tolist())

    def test_what_the_runtime_refuses(self):
        runtime = axisc.Runtime(self.image)
        with self.assertRaisesRegex(axisc.RuntimeFailure, "AXISRT_NOT_RESET"):
            runtime.run([[0, 0, 0, 0]])
        runtime.reset(None, 0)
        with self.assertRaisesRegex(ValueError, "4 axes: X, Y, Z, S"):
            runtime.run([[0, 0, 0]])
        with self.assertRaises(axisc.RuntimeFailure) as caught:
            runtime.run(array.array("d", [0] * 6))
        self.assertEqual(caught.exception.status, "AXISRT_BAD_ARGUMENT")
        runtime.run([[float("nan"), 0, 0, 0]])
        self.assertEqual(runtime.status, "AXISRT_BAD_INPUT")
        with self.assertRaisesRegex(axisc.RuntimeFailure, "AXISRT_WRONG_MAGIC"):
            axisc.Runtime(b"no image" * 100)
        with self.assertRaisesRegex(axisc.RuntimeFailure, "AXISRT_TOO_SHORT"):
            axisc.Runtime(b"")
        with self.assertRaisesRegex(axisc.RuntimeFailure, "AXISRT_OTHER_CYCLE_TIME"):
            axisc.Runtime(self.image, cycle_time_ns=1234)
        with self.assertRaisesRegex(ValueError, "X, Y, Z, S"):
            runtime.reset("Q", 0)

    def test_commands(self):
        runtime = axisc.Runtime(self.image)
        runtime.reset(None, 0)
        runtime.command("ON", order=60)
        with self.assertRaisesRegex(axisc.RuntimeFailure, "AXISRT_NO_BANK"):
            runtime.command("ON", order=33)

    def test_numbers_beyond_32_bits(self):
        """Their lowest 32 bits are those of numbers that the runtime takes."""
        for cycle_time in (2**32 + 1000000, -(2**32) + 1000000):
            with self.assertRaisesRegex(ValueError, f"cycle_time_ns cannot be {cycle_time}: .*0 to 4294967295"):
                axisc.Runtime(self.image, cycle_time_ns=cycle_time)
        runtime = axisc.Runtime(self.image)
        runtime.reset(None, 0)
        for order in (2**32 + 60, -1, 60 - 2**32):
            with self.assertRaisesRegex(ValueError, f"order cannot be {order}: .*0 to 4294967295"):
                runtime.command("ON", order=order)
        with self.assertRaises(TypeError):
            runtime.command("ON", order=60.0)
        with self.assertRaisesRegex(axisc.RuntimeFailure, "AXISRT_NO_BANK"):
            runtime.command("ON", order=2**32 - 1)


class Documentation(unittest.TestCase):
    def test_the_blocks_of_the_page(self):
        """docs/python.md as one session; without matplotlib, without the block that needs it."""
        blocks = re.findall(r"```python\n(.*?)```", pathlib.Path("docs/python.md").read_text(encoding="utf-8"), re.DOTALL)
        self.assertGreater(len(blocks), 4)
        names = {"__name__": "page"}
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as printed:
            for block in blocks:
                if "matplotlib" in block:
                    if importlib.util.find_spec("matplotlib") is None:
                        block = block[: block.index("import matplotlib")]
                    else:
                        block = "import matplotlib\nmatplotlib.use('Agg')\n" + block
                block = block.replace('"x.svg"', repr(folder + "/x.svg")).replace('"response.png"', repr(folder + "/response.png"))
                exec(compile(block, "docs/python.md", "exec"), names)
        lines = printed.getvalue().splitlines()
        self.assertIn("['X', 'Y', 'Z', 'S'] 1000000", lines)
        self.assertIn("50663", lines)
        self.assertRegex(lines[-1], r"^X lags [0-9.]+ units behind, AXISRT_OK$")


class Package(unittest.TestCase):
    def test_a_library_that_is_missing(self):
        done = subprocess.run([sys.executable, "-c", "import axisc; axisc.Workspace()"], capture_output=True, check=False,
                              env={**os.environ, "AXISC_LIBRARIES": "/nowhere"})
        self.assertIn(b"ImportError: /nowhere/libaxisc.so.0 cannot be loaded", done.stderr)

    def test_version(self):
        self.assertIn(axisc.version, program("--version").stdout.decode())


if __name__ == "__main__":
    unittest.main()
