"""mutants.py - puts single faults into rtl/ and tells which tests find them.  See README.md."""
import argparse
import collections
import fcntl
import hashlib
import json
import os
import pathlib
import queue
import random
import signal
import sys
import tempfile
import threading
import time

from equivalents import Stale, equivalents, killed_after_all
from faults import faults_of
from judge import LAYERS, Journal, Judge, digest
from tree import LEFT_OUT, Run, Tree
from verilog import constants_of

HERE = pathlib.Path(__file__).resolve().parent
NOT_OURS = {"ip", "board", "examples"}
# But the interconnect of a Platform Designer system is ours, as far as there are proofs of it.
INTERCONNECT = {f"ip/qsys/de1sim_{name}.v" for name in (
    "avalon_arbiter", "avalon_decoder", "avalon_queue", "avalon_slave", "avalon_width", "reset")}
# Of these the simulation has its own version.
DEVICE_ONLY = {"fpga_clocks.v"}
WHAT_JUDGES = {".v", ".vh", ".def", ".cpp", ".h", ".py", ".cmake", ".txt", ".yaml", ".png"}


def all_faults(rtl):
    """The faults of every file, and the files' texts."""
    faults, texts = [], {}
    included = constants_of((rtl / "regmap" / "regmap.vh").read_text())
    for path in sorted(rtl.rglob("*.v")):
        file = path.relative_to(rtl)
        ours = file.parts[0] not in NOT_OURS or str(file) in INTERCONNECT
        if ours and str(file) not in DEVICE_ONLY:
            texts[str(file)] = path.read_text()
            faults += faults_of(str(file), texts[str(file)], included)
    return faults, texts


def chosen(faults, arguments):
    if arguments.only:
        found = [fault for fault in faults if fault.id == arguments.only]
        if not found:
            sys.exit(f"there is no fault {arguments.only}")
        return found
    if arguments.block:
        block = arguments.block
        faults = [fault for fault in faults if fault.file.startswith(f"{block}/")
                  or pathlib.Path(fault.file).stem == block]
        if not faults:
            sys.exit(f"there is no block {block}")
    if not arguments.number:
        return faults
    return random.Random(arguments.seed).sample(faults, min(arguments.number, len(faults)))


def tree_hash(source):
    """What decides whether a survivor has to be judged again."""
    whole = hashlib.sha256()
    for top in ("rtl", "sw", "sim", "tb"):
        for path, folders, files in os.walk(source / top):
            folders[:] = sorted(name for name in folders if name not in LEFT_OUT)
            for file in (pathlib.Path(path, name) for name in sorted(files)):
                if file.suffix in WHAT_JUDGES and HERE not in file.parents:
                    whole.update(str(file.relative_to(source)).encode() + file.read_bytes())
    return whole.hexdigest()[:16]


def told(result):
    layer = {"invalid": "not a mutant", None: "SURVIVES"}.get(result["layer"], result["layer"])
    by = f"{result['by']} {result['how']}" if result["layer"] else ""
    equivalent = " (equivalent)" if result["equivalent"] else ""
    return f"{layer:12} {result['seconds']:5.0f} s  {result['id']}{equivalent}  {by}".rstrip()


def summary(results):
    """(lines, rates): what share the layers have found so far, and what none has."""
    counted = [r for r in results if r["layer"] != "invalid" and not r["equivalent"]]
    invalid = sum(r["layer"] == "invalid" for r in results)
    lines = [f"{len(results)} faults: {invalid} not mutants, "
             f"{len(results) - invalid - len(counted)} equivalent, {len(counted)} judged"]
    rates, killed = {}, 0
    for layer in LAYERS:
        killed += sum(r["layer"] == layer for r in counted)
        rates[layer] = 100 * killed / len(counted) if counted else 100.0
        lines.append(f"  found up to {layer:8} {killed:4} of {len(counted)}  {rates[layer]:6.2f} %")
    kinds = collections.Counter(r["kind"] for r in counted)
    found = collections.Counter(r["kind"] for r in counted if r["layer"])
    lines += [f"    {kind:12} {found[kind]:4} of {kinds[kind]}" for kind in sorted(kinds)]
    survivors = sorted((r for r in counted if r["layer"] is None), key=lambda r: r["id"])
    lines += [f"survives: {r['id']}\n          {r['text']}"
              + (f"\n          undecided: {' '.join(r['undecided'])}" if r["undecided"] else "")
              for r in survivors]
    return lines, rates


def judge_all(faults, texts, known, arguments):
    """Results of the faults, as they come; fewer if it is interrupted."""
    journal = Journal(arguments.out / "results.jsonl", arguments.resume,
                      tree_hash(arguments.source))
    results, waiting, errors = [], queue.SimpleQueue(), []
    stop, asked = threading.Event(), threading.Event()
    number = 0
    for fault in faults:
        before = journal.find(fault, texts[fault.file])
        if before:
            results.append({**before, "equivalent": known.get(fault.id)})
        else:
            waiting.put(fault)
            number += 1
    print(f"{len(faults)} faults, {number} to judge", flush=True)
    seconds, done = {}, len(results)

    def work(place):
        nonlocal done
        try:
            tree = Tree(arguments.source, arguments.work / str(place), print)
            tree.prepare()
            judge = Judge(tree, seconds, arguments.proof_seconds, stop)
            while not stop.is_set():
                fault = waiting.get_nowait()
                began = time.monotonic()
                layer, by, how, undecided = judge(fault, texts[fault.file])
                if layer == "stopped":
                    return
                result = {"id": fault.id, "kind": fault.kind, "text": fault.text, "layer": layer,
                          "by": by, "how": how, "undecided": undecided,
                          "seconds": round(time.monotonic() - began, 1),
                          "mutant": digest(fault.apply(texts[fault.file])),
                          "tree": journal.tree_hash, "equivalent": known.get(fault.id)}
                journal.add(result)
                results.append(result)
                done += 1
                print(f"{done:4}/{len(faults)}  {told(result)}", flush=True)
        except queue.Empty:
            pass
        except BaseException as error:  # the other threads end too
            if not asked.is_set():
                errors.append(error)
            stop.set()

    threads = [threading.Thread(target=work, args=(place,))
               for place in range(1, min(arguments.j, number) + 1)]

    def interrupt(*_):  # raises nothing: Thread.join() would take the thread for ended
        asked.set()
        stop.set()

    for kind in (signal.SIGINT, signal.SIGTERM):  # also where a shell ignores them
        signal.signal(kind, interrupt)
    for thread in threads:
        thread.start()
    for thread in threads:
        while thread.is_alive():
            thread.join(0.2)
            if stop.is_set():
                Run.end_all()
    if errors:
        raise errors[0]
    return results, asked.is_set()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--number", type=int, default=330, help="how many faults; 0: all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--block", help="a folder of rtl/ or a file's name without .v")
    parser.add_argument("--only", help="the id of one fault")
    parser.add_argument("--list", action="store_true", help="print the ids and judge nothing")
    parser.add_argument("--at-least", type=float, default=99, help="percent to be found")
    parser.add_argument("--resume", action="store_true", help="go on with what was interrupted")
    parser.add_argument("-j", type=int, default=1, help="trees in which mutants are built")
    parser.add_argument("--proof-seconds", type=float, default=600, help="limit of a proof")
    parser.add_argument("--source", type=pathlib.Path, default=HERE.parent.parent)
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--work", type=pathlib.Path, help="folder of the trees",
                        default=f"{tempfile.gettempdir()}/de1sim-mutants-{os.getuid()}")
    arguments = parser.parse_args()
    arguments.out = arguments.out or arguments.source / "build" / "mutants"
    faults, texts = all_faults(arguments.source / "rtl")
    try:
        known = equivalents((HERE / "equivalent.txt").read_text().splitlines(), faults)
    except Stale as stale:
        sys.exit(str(stale))
    faults = chosen(faults, arguments)
    if arguments.list:
        print("\n".join(fault.id for fault in faults))
        return
    os.nice(10)
    arguments.work.mkdir(parents=True, exist_ok=True)
    lock = (arguments.work / "lock").open("w")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        sys.exit(f"{arguments.work} is in use; --work names another folder")
    results, interrupted = judge_all(faults, texts, known, arguments)
    lines, rates = summary(results)
    print("\n".join(lines))
    stale = killed_after_all(results)
    print("\n".join(stale), end="\n" if stale else "")
    (arguments.out / "results.json").write_text(json.dumps(
        {"seed": arguments.seed, "number": len(faults), "rates": rates, "stale": stale,
         "results": results}, indent=1) + "\n")
    if interrupted:
        print("interrupted; --resume goes on")
        sys.exit(130)
    if stale:
        sys.exit(2)
    sys.exit(0 if rates[LAYERS[-1]] >= arguments.at_least else 1)


if __name__ == "__main__":
    main()
