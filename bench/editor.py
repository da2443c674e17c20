#!/usr/bin/env python3
"""How long the language server takes in a machine of 16 axes with lists of 1,000 lines: editor.py AXISC [EDITS]"""
import json
import os
import random
import subprocess
import sys
import tempfile
import time

PROGRAM = os.path.abspath(sys.argv[1])
EDITS = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
AXES, LINES = 16, 1000


def machine(folder):
    """Every parameter with a default, so that lists are long and sound."""
    catalogue = json.loads(subprocess.run([PROGRAM, "explain", "--all", "--format", "json"], capture_output=True).stdout)
    lines = []
    for parameter in catalogue["parameters"]:
        names = [parameter["name"]]
        while "[]" in names[0]:
            names = [name.replace("[]", f"[{index}]", 1) for name in names for index in range(3)]
        if parameter["default"]:
            lines += [f"{name:50} {parameter['default']}\n" for name in names]
    for axis in range(AXES):
        with open(f"{folder}/a{axis}.lis", "w", encoding="utf-8") as file:
            file.write(f"kopf.achs_nr {axis + 1}\nkopf.log_achs_name A{axis}\n" + "".join(lines[: LINES - 3]) + "Ende\n")
    with open(f"{folder}/machine.json", "w", encoding="utf-8") as file:
        json.dump({"cycle_time_us": 1000, "axes": [{"name": f"A{i}", "list": f"a{i}.lis"} for i in range(AXES)]}, file)


class Server:
    def __init__(self):
        self.process = subprocess.Popen([PROGRAM, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.last = 0

    def send(self, method, params, **more):
        text = json.dumps({"jsonrpc": "2.0", "method": method, "params": params, **more}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(text) + text)
        self.process.stdin.flush()

    def receive(self):
        """The bytes of a message: what a client makes of them is its own time."""
        size = int(self.process.stdout.readline().split(b":")[1])
        self.process.stdout.readline()
        return self.process.stdout.read(size)

    def ask(self, method, params):
        self.last += 1
        self.send(method, params, id=self.last)
        return self.receive()

    def memory(self):
        with open(f"/proc/{self.process.pid}/status", encoding="ascii") as file:
            return next(int(line.split()[1]) / 1024 for line in file if line.startswith("VmRSS"))


def show(what, times):
    times.sort()
    middle, late = times[len(times) // 2], times[int(len(times) * 0.99)]
    print(f"{what:34} median {middle * 1e3:6.2f} ms   99 % {late * 1e3:6.2f} ms   largest {times[-1] * 1e3:6.2f} ms")


def timed(call):
    begin = time.perf_counter()
    answer = call()
    return time.perf_counter() - begin, answer


def main():
    random.seed(1)
    with tempfile.TemporaryDirectory() as folder:
        machine(folder)
        uri = f"file://{folder}/a3.lis"
        with open(f"{folder}/a3.lis", encoding="utf-8") as file:
            text = file.read()
        begin = time.perf_counter()
        server = Server()
        server.ask("initialize", {"capabilities": {}})
        server.send("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": "isg-list", "version": 1, "text": text}})
        server.receive()
        print(f"start to first diagnostics: {(time.perf_counter() - begin) * 1e3:.1f} ms, {server.memory():.1f} MB")
        random_line = lambda: random.randrange(2, LINES - 10)
        version = 1

        def keystroke(line, character, removed, text):
            nonlocal version
            version += 1
            edit = {"range": {"start": {"line": line, "character": character},
                              "end": {"line": line, "character": character + removed}}, "text": text}
            change = {"textDocument": {"uri": uri, "version": version}, "contentChanges": [edit]}

            def answer():
                server.send("textDocument/didChange", change)
                return server.receive()

            return timed(answer)

        def written_and_removed(edits):
            """A letter in front of a name, and away again: the list has the same findings after every second edit."""
            times = []
            for _ in range(edits // 2):
                line = random_line()
                times += [keystroke(line, 0, 0, "x")[0], keystroke(line, 0, 1, "")[0]]
            return times

        show("keystroke to diagnostics, sound list", written_and_removed(min(EDITS, 1000)))
        for line in range(2, LINES - 10):
            _, answer = keystroke(line, 60, 0, "x")
        found = len(json.loads(answer)["params"]["diagnostics"])
        quarter, times = EDITS // 4, []
        memory = [server.memory()]
        for _ in range(4):
            times += written_and_removed(quarter)
            memory.append(server.memory())
        show(f"keystroke to {found} diagnostics", times)
        print(f"memory before {EDITS} edits and after each quarter: " + ", ".join(f"{size:.1f}" for size in memory) + " MB")
        at = lambda: {"line": random.randrange(LINES), "character": random.choice([3, 8, 52])}
        whole = {"start": {"line": 0, "character": 0}, "end": {"line": LINES, "character": 0}}
        for method, params in (("hover", None), ("completion", None), ("definition", None), ("inlayHint", {"range": whole}),
                               ("semanticTokens/full", {}), ("documentSymbol", {})):
            times = []
            for _ in range(300):
                more = {"position": at()} if params is None else params
                times.append(timed(lambda more=more: server.ask("textDocument/" + method, {"textDocument": {"uri": uri}, **more}))[0])
            show(method, times)
        server.ask("shutdown", None)
        server.send("exit", None)
        server.process.wait()


if __name__ == "__main__":
    main()
