"""judge.py - which layer finds a mutant: its block's tests, the proofs, or the whole."""
import hashlib
import json
import threading

from tree import FEW_SECONDS

LAYERS = ("block", "proofs", "whole")


class Judge:
    """Judges mutants in one tree.  `seconds` is what each test takes without a fault."""

    def __init__(self, tree, seconds, proof_seconds, stop):
        self.tree, self.seconds, self.proof_seconds = tree, seconds, proof_seconds
        self.stop = stop

    def __call__(self, fault, text):
        """(layer, test, how, undecided): layer is None for a survivor, 'invalid' for no mutant."""
        mutant = fault.apply(text)
        undecided = []
        self.tree.put(fault.file, mutant)
        try:
            refused = self.tree.lint(fault.file)
            if self.stop.is_set():
                return "stopped", "", "", undecided
            if refused:
                return "invalid", "lint", "not Verilog", undecided
            for layer in LAYERS:
                tests = self.tree.tests_of(layer, fault.file, self.seconds)
                if layer != "proofs":  # which need no building, so that each is measured alone
                    self._measure(tests, fault.file, text, mutant)
                for test in tests:
                    how = self._try(test, fault.file, text, mutant)
                    if self.stop.is_set():
                        return "stopped", "", "", undecided
                    if how == "does not build":
                        return "invalid", test.name, how, undecided
                    if how in ("hangs", "left out") and layer == "proofs":
                        undecided.append(test.name)
                    elif how != "passes":
                        return layer, test.name, how, undecided
            return None, "", "", undecided
        finally:
            self.tree.put(fault.file, text)

    def _measure(self, tests, file, text, mutant):
        """What tests take without the fault, the first time that they are needed."""
        tests = [test for test in tests if test.name not in self.seconds]
        if tests:
            self.tree.put(file, text)
        for test in tests:
            proof = test.layer == "proofs"
            how, seconds = self.tree.try_test(test, self.proof_seconds if proof else 1800)
            if self.stop.is_set():
                return
            if how != "passes" and not (proof and how == "hangs"):
                raise SystemExit(f"{test.name} {how} without a fault")
            self.seconds[test.name] = seconds
        if tests:
            self.tree.put(file, mutant)

    def _try(self, test, file, text, mutant):
        self._measure([test], file, text, mutant)
        if self.stop.is_set():
            return "stopped"
        seconds = self.seconds[test.name]
        if test.layer == "proofs":
            if seconds >= self.proof_seconds:
                return "left out"
            return self.tree.try_test(test, max(FEW_SECONDS, min(5 * seconds,
                                                                 self.proof_seconds)))[0]
        return self.tree.try_test(test, max(FEW_SECONDS, 10 * seconds))[0]


class Journal:
    """What was judged, a line each, so that an interrupted run can go on."""

    def __init__(self, path, resume, tree_hash):
        self.path, self.tree_hash, self.lock = path, tree_hash, threading.Lock()
        path.parent.mkdir(parents=True, exist_ok=True)
        self.known = {}
        if resume and path.exists():
            for line in path.read_text().splitlines():
                result = json.loads(line)
                self.known[result["id"]] = result
        else:
            path.write_text("")

    def find(self, fault, text):
        """The result of before, if it still says something: what survived may be found by now."""
        result = self.known.get(fault.id)
        if not result or result["mutant"] != digest(fault.apply(text)):
            return None
        if result["layer"] is None and result["tree"] != self.tree_hash:
            return None
        return result

    def add(self, result):
        with self.lock, self.path.open("a") as file:
            file.write(json.dumps(result) + "\n")


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()[:16]
