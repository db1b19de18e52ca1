"""building_test.py DE1SIM FOLDER [CASE...] - what a build does again, and what it leaves alone."""
import os
import pathlib
import shutil
import subprocess
import time

from case import DE1SIM, LEDS, Case, run


def ends_soon(state):
    """Whether this process has been killed, which on a busy machine takes a moment."""
    for _ in range(100):
        try:
            if " Z " in state.read_text():
                return True
        except (FileNotFoundError, ProcessLookupError):
            return True
        time.sleep(0.1)
    return False


class Building(Case):
    def test_what_is_built_can_be_copied_with_its_project(self):
        """No link leads back to the folder that is copied; an include beside it is found."""
        self.write(lab__inc__width_vh="`define WIDTH 10\n", common__mask_vh="`define MASK 10'h3\n",
                   lab__top_v='`include "width.vh"\n`include "mask.vh"\n' +
                   LEDS.format("SW ^ `MASK").replace("output [9:0]", "output [`WIDTH - 1:0]"),
                   lab__p_qsf="set_global_assignment -name TOP_LEVEL_ENTITY top\n"
                              "set_global_assignment -name SEARCH_PATH .\n"
                              "set_global_assignment -name SEARCH_PATH inc\n"
                              "set_global_assignment -name SEARCH_PATH ../common\n"
                              "set_global_assignment -name VERILOG_FILE top.v\n")
        built = self.de1sim("build", "lab")
        self.assertEqual(built.returncode, 0, built.stdout + built.stderr)
        shutil.copytree(self.folder / "lab", self.folder / "copy")
        built = self.de1sim("build", "copy")
        self.assertEqual(built.returncode, 0, built.stdout + built.stderr)

    def test_a_design_is_elaborated_again_where_a_file_of_it_has_changed(self):
        self.write(top_v='`include "gate.vh"\n' + LEDS.format("`GATE"),
                   gate_vh="`define GATE SW\n")
        elaborated = []
        for files in {}, {}, {"gate_vh": "`define GATE ~SW\n"}, {"top_v": LEDS.format("SW")}:
            self.write(**files)
            self.assertEqual(self.de1sim("check", ".").returncode, 0)
            tree = max(self.folder.rglob("design*.kept"))
            elaborated.append(tree.stat().st_mtime_ns)
        self.assertEqual(elaborated[0], elaborated[1])
        self.assertEqual(len(set(elaborated)), 3)

    def test_a_design_that_asks_verilator_several_times_does_so_once(self):
        """A parameter that its top lacks, generics by Verilog, an inout with bits left over."""
        self.write(p_qsf="set_global_assignment -name TOP_LEVEL_ENTITY top\n"
                   "set_global_assignment -name VERILOG_FILE top.v\nset_parameter -name DEPTH 5\n"
                   "set_global_assignment -name VHDL_FILE part.vhd\n",
                   top_v="module top(input [9:0] SW, output [9:0] LEDR, inout [3:0] GPIO_0);\n"
                         "part #(.n(10)) p(SW, LEDR); pad q(.io(GPIO_0)); endmodule\n"
                         "module pad(inout [4:0] io); assign io = 5'bz; endmodule\n",
                   part_vhd="library ieee; use ieee.std_logic_1164.all;\n"
                            "entity part is generic (n : integer := 2);\n"
                            "port (a : in std_logic_vector(n - 1 downto 0);\n"
                            "  b : out std_logic_vector(n - 1 downto 0)); end;\n"
                            "architecture x of part is begin b <= not a; end;\n")
        real = shutil.which("verilator")
        tool = self.folder / "bin" / "verilator"
        tool.parent.mkdir()
        tool.write_text(f'#!/bin/sh\n[ "$1" = --version ] || echo x >> "{self.folder}/runs"\n'
                        f'exec {real} "$@"\n')
        tool.chmod(0o755)
        environment = dict(os.environ, PATH=f"{tool.parent}:{os.environ['PATH']}")
        runs, said = [], []
        for _ in range(2):
            done = subprocess.run([DE1SIM, "check", "."], cwd=self.folder, capture_output=True,
                                  text=True, env=environment)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            runs.append((self.folder / "runs").read_text().count("x"))
            said.append(done.stdout + done.stderr)
        self.assertGreaterEqual(runs[0], 4)
        self.assertEqual(runs[1], runs[0])
        self.assertEqual(said[1], said[0])

    def test_two_at_once_build_once(self):
        self.write(top_v=LEDS.format("SW"))
        both = [subprocess.Popen([DE1SIM, "build", "."], cwd=self.folder, text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
                for _ in range(2)]
        said = [one.communicate()[0].rsplit(": ", 1)[1].strip() for one in both]
        self.assertEqual(sorted(said), ["built", "is up to date"])

    def test_a_build_that_does_not_end(self):
        """Ended with what it has started, and the next one begins again."""
        self.write(top_v=LEDS.format("SW"))
        real = shutil.which("verilator")
        tool = self.folder / "bin" / "verilator"
        tool.parent.mkdir()
        tool.write_text(f'#!/bin/sh\n[ "$1" = --version ] && exec {real} --version\n'
                        "sleep 1000 &\necho $! >> pids\nwait\n")
        tool.chmod(0o755)
        environment = dict(os.environ, PATH=f"{tool.parent}:{os.environ['PATH']}")
        done = subprocess.run([DE1SIM, "build", ".", "--build-limit", "5"], cwd=self.folder,
                              capture_output=True, text=True, env=environment)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.splitlines()[-1], "de1sim: the build has not ended in 5 s "
                         "(--build-limit): verilator was at work")
        for pid in (self.folder / ".de1sim/pids").read_text().split():
            self.assertTrue(ends_soon(pathlib.Path(f"/proc/{pid}/stat")), pid)
        self.leds(5, 5)

    def test_a_folder_that_cannot_be_written_to(self):
        self.write(project__top_v=LEDS.format("SW"),
                   s_yaml="name: x\nversion: 1\nsteps: [delay: 1ms]\n")
        before = sorted(self.folder.joinpath("project").rglob("*"))
        cache = self.folder / "cache" / "de1sim"
        cache.mkdir(parents=True)
        if "XDG_CACHE_HOME" in os.environ:  # then compiled once for all tests
            headers = pathlib.Path(os.environ["XDG_CACHE_HOME"], "de1sim", "headers")
            headers.mkdir(parents=True, exist_ok=True)
            (cache / "headers").symlink_to(headers)
        environment = dict(os.environ, XDG_CACHE_HOME=str(cache.parent))
        self.folder.joinpath("project").chmod(0o555)
        words = [DE1SIM, "run", "s.yaml", "--project", "project"]
        if os.getuid() == 0:  # who may otherwise write everywhere
            words = ["setpriv", "--bounding-set=-dac_override", "--inh-caps=-dac_override"] + words
        done = subprocess.run(words, cwd=self.folder, capture_output=True, text=True,
                              env=environment)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(sorted(self.folder.joinpath("project").rglob("*")), before)
        self.assertTrue(list(self.folder.glob("cache/de1sim/*/chip-*.so")))

    def test_headers_are_compiled_once_and_used(self):
        """The second build would stop at the text of the header, and then forget it."""
        environment = dict(os.environ, XDG_CACHE_HOME=str(self.folder / "cache"))
        for body in "SW", "~SW":
            self.write(top_v=LEDS.format(body))
            built = subprocess.run([DE1SIM, "build", "."], cwd=self.folder, env=environment,
                                   capture_output=True, text=True)
            self.assertEqual(built.returncode, 0, built.stdout + built.stderr)
            notes, = self.folder.glob("cache/de1sim/headers/*.notes")
            header = notes.with_suffix("")
            then = header.stat()
            header.write_text("#error".ljust(then.st_size))
            os.utime(header, ns=(then.st_atime_ns, then.st_mtime_ns))


if __name__ == "__main__":
    run()
