"""tree.py - a copy of the source tree, built once, in which mutants are judged.

The copy is outside the repository.  Verilator's warnings do not stop a build there, since a fault
often causes one.
"""
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import time

LEFT_OUT = {"build", "out", ".git", ".de1sim", "__pycache__"}
FEW_SECONDS = 20       # even a short test may take so long on a busy machine
# Verilator writes all of a class again: what includes its header comes from the cache if the class
# looks as before.  Mutants themselves are not kept.
CACHE = {"CCACHE_SLOPPINESS":
         "pch_defines,time_macros,include_file_mtime,include_file_ctime"}
CACHE_OF_MUTANTS = {**CACHE, "CCACHE_READONLY": "1"}
PLAY = re.compile(r"Scenario\.(?!demo|board)")
TOP = re.compile(r"(Top|EveryClock)\.")   # of two programs: the plain Verilog beside the twins


class Run:
    """What a command answered: `code` is None if it ran into the time limit."""
    running = set()

    def __init__(self, command, limit, cwd, environment=None):
        began = time.monotonic()
        process = subprocess.Popen(command, cwd=cwd, text=True, errors="replace",
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, start_new_session=True,
                                   env={**os.environ, **(environment or {})})
        self.running.add(process)
        try:
            self.output = process.communicate(timeout=limit)[0]
            self.code = process.returncode
        except subprocess.TimeoutExpired:
            self.code = None
        finally:
            if process.poll() is None:
                end(process)
                self.output = process.communicate()[0]
            self.running.discard(process)
        self.seconds = time.monotonic() - began


    @classmethod
    def end_all(cls):
        for process in list(cls.running):
            end(process)


def end(process):
    """Ends it, with what it has started; Ninja first ends its compilers, in groups of their own."""
    for kind, wait in ((signal.SIGTERM, 5), (signal.SIGKILL, 0)):
        try:
            os.killpg(process.pid, kind)
        except ProcessLookupError:
            return
        deadline = time.monotonic() + wait
        while process.poll() is None and time.monotonic() < deadline:
            time.sleep(0.05)


class Test:
    def __init__(self, layer, name, command, cwd, targets, reads, environment=None):
        self.layer, self.name, self.command, self.cwd = layer, name, command, cwd
        self.targets, self.reads, self.environment = targets, reads, environment


class Tree:
    def __init__(self, source, folder, log):
        self.source, self.root, self.log = source, folder, log
        self.build, self.rtl = self.root / "build", self.root / "rtl"
        self.verilator = folder.with_name("verilator_bin")

    # ---- The copy ----

    def prepare(self):
        self.root.mkdir(parents=True, exist_ok=True)
        self._copy()
        if not self.verilator.exists():
            real = shutil.which("verilator_bin")
            self.verilator.write_text(f'#!/bin/sh\nexec {real} "$@" -Wno-fatal\n')
            self.verilator.chmod(0o755)
        # The copy may have other tests than before; where a source is gone Ninja cannot help.
        if Run(["ninja", "-C", self.build, "build.ninja"], None, self.root, CACHE).code:
            launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
            self._must(["cmake", "--preset", "default", f"-DVERILATOR_BIN={self.verilator}",
                        *launcher,
                        *(f"-DDE1SIM_{name}=ON" for name in ("FIRMWARE", "TESTS", "TEST_ALL"))])
        self.labels, self.folders = self._programs()
        wanted = [name for name, label in self.labels.items() if label in ("rtl", "sim")
                  and self._reads(f"bin/{name}")]
        self._must(self._build("de1sim", "examples", "all_pins", *wanted))
        self.lists = list(self.build.rglob("V*_copy.cmake"))
        self.tests = self._find_tests(wanted)

    def _copy(self):
        kept = set()
        for path, folders, files in os.walk(self.source):
            folders[:] = [name for name in folders if name not in LEFT_OUT]
            for name in files:
                file = pathlib.Path(path, name)
                copy = self.root / file.relative_to(self.source)
                kept.add(copy)
                if not file.is_file():
                    continue
                if not copy.exists() or copy.read_bytes() != file.read_bytes():
                    copy.parent.mkdir(parents=True, exist_ok=True)
                    shutil.copyfile(file, copy)
                    shutil.copymode(file, copy)
        for path, folders, files in os.walk(self.root):
            folders[:] = [name for name in folders if name not in LEFT_OUT]
            for name in files:
                if pathlib.Path(path, name) not in kept:
                    pathlib.Path(path, name).unlink()

    def _build(self, *targets):
        return ["cmake", "--build", self.build, "-j1", "--target", *targets]

    def _must(self, command):
        self.log(f"  {' '.join(str(word) for word in command)[:90]} ...")
        run = Run(command, None, self.root, CACHE)
        if run.code:
            raise SystemExit(f"{run.output[-3000:]}\nthe tree without a fault does not build")

    # ---- Its tests ----

    def _programs(self):
        """Programs of tests: their CTest labels, and the folder that they run in."""
        text = (self.build / "build.ninja").read_text()
        found = re.findall(r"TEST_TARGET=(\S+) .*?TEST_WORKING_DIR=(.+?) -D .*?LABELS;(\w+);", text)
        return {name: label for name, _, label in found}, {name: cwd for name, cwd, _ in found}

    def _reads(self, target):
        """Files of rtl/ that a target is made from."""
        output = Run(["ninja", "-t", "inputs", target], 60, self.build).output
        return {line[len(f"{self.rtl}/"):] for line in output.splitlines()
                if line.startswith(f"{self.rtl}/") and line.endswith(".v")}

    def _find_tests(self, wanted):
        reads = {f"{self.build}/bin/{name}": self._reads(f"bin/{name}")
                 for name in [*wanted, "de1sim"]}
        tests = [Test("block", name, [f"{self.build}/bin/{name}", "--gtest_brief=1",
                                      "--gtest_fail_fast"],
                      self.folders[name], [name], reads[f"{self.build}/bin/{name}"])
                 for name in wanted if self.labels[name] == "rtl"]
        shown = Run(["ctest", "--show-only=json-v1"], 60, self.build).output
        for test in json.loads(shown)["tests"]:
            command, name = test.get("command"), test["name"]
            properties = {p["name"]: p["value"] for p in test["properties"]}
            labels = properties.get("LABELS", [])
            if not command:
                continue
            where = properties.get("WORKING_DIRECTORY", str(self.build))
            environment = dict(v.split("=", 1) for v in properties.get("ENVIRONMENT", []))
            if "formal" in labels and re.match("(Proof|Sleep)[.]", name):
                if name.startswith("Sleep."):
                    files = set(Run([*command, "--list"], 60, where).output.split())
                else:
                    files = {word for word in command if word.endswith(".v")}
                tests.append(Test("proofs", name, command, where, [], files, environment))
            elif TOP.match(name):
                programs = [word for word in command if word.startswith(f"{self.build}/bin/")]
                files = set().union(*(self._reads(f"bin/{pathlib.Path(p).name}")
                                      for p in programs))
                tests.append(Test("whole", name, command, where,
                                  [pathlib.Path(p).name for p in programs], files, environment))
            elif command[0] in reads and ("sim" in labels or PLAY.match(name)
                                          or command[-1].startswith(f"{self.build}/examples/")):
                target = pathlib.Path(command[0]).name
                tests.append(Test("whole", name, command, where, [target], reads[command[0]],
                                  environment))
        return tests

    def tests_of(self, layer, file, seconds):
        """Those that read a file: who reads little comes first, then who is quick."""
        return sorted((test for test in self.tests if test.layer == layer and file in test.reads),
                      key=lambda test: (len(test.reads) if layer == "proofs" else
                                        "de1sim" in test.targets, len(test.targets),
                                        seconds.get(test.name, 0)))

    # ---- Judging ----

    def lint(self, file):
        """None if the file is Verilog; else what Verilator says."""
        folders = sorted({path.parent for path in self.rtl.rglob("*.v")
                          if path.relative_to(self.rtl).parts[0] not in
                          ("ip", "board", "examples")})
        path = self.rtl / file
        run = Run([self.verilator, "--lint-only", "--top-module", path.stem,
                   *(word for folder in folders for word in ("-y", folder)),
                   *(f"-I{self.rtl / name}" for name in ("regmap", "bus", "vga")), path],
                  FEW_SECONDS, self.root)
        return None if run.code == 0 else run.output or "hangs"

    def try_test(self, test, limit):
        """'passes', 'fails', 'hangs' or 'does not build'."""
        if test.targets and self._make(test.targets) != 0:
            return "does not build", 0
        run = Run(test.command, limit, test.cwd, test.environment)
        return {0: "passes", None: "hangs"}.get(run.code, "fails"), run.seconds

    def _make(self, targets):
        """Builds as CMake does, but for what it asks each time: whether Verilator makes the same
        files.  To know that it runs Verilator on all classes."""
        shutil.copyfile(self.build / "build.ninja", self.build / "mutants.ninja")
        run = Run(["ninja", "-f", "mutants.ninja", "-j1", *targets], 600, self.build,
                  CACHE_OF_MUTANTS)
        for copy in self.lists:
            made = copy.with_name(copy.name.replace("_copy.cmake", ".cmake"))
            if made.read_bytes() != copy.read_bytes():
                return Run(self._build(*targets), 600, self.root, CACHE_OF_MUTANTS).code
        return run.code

    def put(self, file, text):
        (self.rtl / file).write_text(text)
