"""slurm_test.py DE1SIM FOLDER [CASE...] - de1sim test --slurm, on a cluster of this machine alone

slurmctld and slurmd run as root, at free ports of 127.0.0.1, in a folder without blanks, which they
cannot read.  Exit code 77: they are not installed or do not start, as where there are no cgroups,
or somebody else than root runs this.
"""
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest

from folder import Folder

CONFIGURATION = """ClusterName=de1sim
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MpiDefault=none
SwitchType=switch/none
JobAcctGatherType=jobacct_gather/none
SlurmctldPort={control}
SlurmdPort={node}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
SchedulerParameters=sched_interval=1
NodeName=here NodeAddr=127.0.0.1 CPUs=2
PartitionName=all Nodes=here Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return listener.getsockname()[1]


class Cluster:
    def __init__(self, folder):
        for name in ("state", "spool"):
            (folder / name).mkdir(parents=True)
        configuration = folder / "slurm.conf"
        host = socket.gethostname()
        configuration.write_text(CONFIGURATION.format(folder=folder, host=host, control=free_port(),
                                                      node=free_port()))
        os.environ["SLURM_CONF"] = str(configuration)
        self.daemons = [subprocess.Popen(words, stdout=subprocess.DEVNULL,
                                         stderr=subprocess.DEVNULL)
                        for words in (["slurmctld", "-D"], ["slurmd", "-D", "-N", "here"])]
        end = time.monotonic() + 60
        while "idle" not in self.ask("sinfo", "--noheader", "--format=%T"):
            if time.monotonic() > end:
                self.end()
                for log in sorted(folder.glob("*.log")):
                    print(f"Slurm does not start; the end of {log.name}:",
                          *log.read_text().splitlines()[-5:], sep="\n")
                sys.exit(77)
            time.sleep(0.2)

    @staticmethod
    def ask(*words):
        return subprocess.run(words, capture_output=True, text=True).stdout

    def end(self):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            daemon.wait()


class Slurm(Folder):
    def many(self):
        for n in range(16):
            steps = ['expect-leds: "1111111111"'] if n == 7 else []
            self.scenario(f"s/n{n}", *steps, head=f"duration: {1 + n}ms")

    def names_and_codes(self, out):
        return self.codes(out), self.results(out)["missing"]

    def test_gives_what_a_run_here_gives(self):
        self.many()
        self.suite("s", "--out", "local", code=1)
        done = self.suite("s", "--out", "cluster", "--slurm", "--shards", "4", code=1)
        self.assertIn("15 of 16 scenarios passed", done.stdout)
        self.assertEqual(self.names_and_codes("cluster"), self.names_and_codes("local"))
        self.check_junit("cluster")
        self.assertEqual(len(list((self.folder / "cluster/shards").iterdir())), 4)
        self.assertIn("shards/", (self.folder / "cluster/index.html").read_text())

    def test_a_cancelled_task_runs_its_lost_scenarios_again(self):
        """Of two tasks one is cancelled while it runs; what had its result keeps it."""
        self.many()
        self.scenario("s/slow", head="duration: 4s")
        process = subprocess.Popen([sys.argv[1], "test", "s", "--out", "cluster", "--slurm",
                                    "--shards", "8"], cwd=self.folder, stderr=subprocess.PIPE,
                                   stdout=subprocess.PIPE, text=True)
        slow = self.folder / "cluster/shards/1/runs/s/slow"  # the longest is in the first
        while not slow.exists() and process.poll() is None:
            time.sleep(0.1)
        time.sleep(0.5)
        [task] = [line.split()[0] for line in
                  Cluster.ask("squeue", "--noheader", "--array", "--format=%i %K").splitlines()
                  if line.split()[1] == "1"]
        subprocess.run(["scancel", task], check=True)
        out, said = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 1, said)
        self.assertIn("shard 1/8 has lost ", said)
        self.assertIn("16 of 17 scenarios passed", out)
        self.assertEqual(self.results("cluster")["missing"], [])
        # Each has run once, but for those that were lost.
        lost = int(said.split("shard 1/8 has lost ")[1].split()[0])
        lines = [line for line in said.splitlines() if line.startswith(("ok ", "FAILED "))]
        self.assertEqual(len(lines), 17)
        self.assertGreaterEqual(lost, 1)
        script = (self.folder / "cluster/slurm/task.sh").read_text()
        self.assertIn("--resume", script)

    def test_what_cannot_be(self):
        self.scenario("s/a")
        done = self.suite("s", "--slurm", "--sbatch", "--partition=none", code=2)
        self.assertRegex(done.stderr, "^de1sim: --slurm: sbatch: error: .*partition.*\n$")
        done = self.suite("s", "--slurm", "--jobs", "2", code=2)
        self.assertIn("--jobs excludes --slurm", done.stderr)
        path, os.environ["PATH"] = os.environ["PATH"], "/nowhere"
        try:
            done = self.suite("s", "--slurm", code=2)
        finally:
            os.environ["PATH"] = path
        self.assertEqual(done.stderr, "de1sim: --slurm: there is no sbatch on the PATH\n")


if os.getuid() != 0 or not shutil.which("slurmctld"):
    sys.exit(77)
place = pathlib.Path(tempfile.mkdtemp(prefix="de1sim-slurm-"))
cluster = Cluster(place)
try:
    done = unittest.main(argv=sys.argv[:1] + sys.argv[3:], exit=False)
    sys.exit(not done.result.wasSuccessful())
finally:
    cluster.end()
    shutil.rmtree(place, ignore_errors=True)
