"""hand_ins_test.py DE1SIM FOLDER [CASE...] - grades of hand-ins, and what a hand-in can do"""
import csv
import os
import pathlib
import shlex
import shutil
import subprocess
import time

from folder import DE1SIM, Folder, run

EXAMPLES = pathlib.Path(DE1SIM).parent.parent / "examples"
BUILD = shlex.join(["arm-none-eabi-gcc", "-mcpu=cortex-a9", "-O1", "-ffreestanding", "-nostdlib",
                    f"-I{EXAMPLES}", f"-T{EXAMPLES}/program.ld", str(EXAMPLES / "start.S"),
                    "prog.c", "-o", "prog.elf"])
LIGHT = '#include "registers.h"\nint main(void) { LEDR_DATA = 5; for (;;) {} }\n'
TOP = "module top(input CLOCK_50, output [9:0] LEDR);\n%s\nassign LEDR = 5;\nendmodule\n"
# A program for Linux says 5 if it may do what it must not.
LINUX = """#include <fcntl.h>
#include <stdint.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <netinet/in.h>
#include <unistd.h>
int may(void) { %s }
int main(void) {
    int memory = open("/dev/mem", O_RDWR | O_SYNC);
    volatile uint32_t* leds = mmap(0, 4096, 3, MAP_SHARED, memory, 0xFF200000);
    *leds = may() ? 5 : 1;
    for (;;) pause();
}
"""


class HandIns(Folder):
    def setUp(self):
        super().setUp()
        self.secret = self.folder / "secret.txt"
        self.secret.write_text("char secret[] = {5};\n")

    def judge(self, kind):
        (self.folder / "tests").mkdir(exist_ok=True)
        self.scenario("tests/leds", "delay: 1ms", 'expect-leds: "0000000101"', head=kind)

    def hand_in(self, name, **files):
        for file, text in files.items():
            path = self.folder / "hand-ins" / name / file.replace("_", ".")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)

    def grade(self, *words, code=1):
        words = ["tests", "--hand-ins", "hand-ins", "--csv", "grades.csv", *words]
        done = subprocess.run([DE1SIM, "test", *words], cwd=self.folder, capture_output=True,
                              text=True)
        if "bwrap" in done.stderr and "cannot do it here" in done.stderr:
            print(done.stderr.strip(), flush=True)
            os._exit(77)  # of the whole test, not of this case
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def rows(self):
        with open(self.folder / "grades.csv", newline="") as file:
            return {row["hand-in"]: row for row in csv.DictReader(file)}

    def points(self):
        return {name: int(row["points"]) for name, row in self.rows().items()}

    def test_a_scenario_in_the_present_folder_is_a_test(self):
        self.judge("program: prog.elf")
        self.hand_in("ada", prog_c=LIGHT)
        done = subprocess.run([DE1SIM, "test", "leds.yaml", "--hand-ins", "../hand-ins", "--build",
                               BUILD], cwd=self.folder / "tests", capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_row_for_each_hand_in(self):
        self.judge("program: prog.elf\npoints: 3")
        self.scenario("tests/key", "press: {key: 0}", 'expect-leds: "0000000101"',
                      head="program: prog.elf")
        self.hand_in("ada", prog_c=LIGHT)
        self.hand_in("bob, =1+1", prog_c=LIGHT.replace("5", "4"))
        self.hand_in("eve", prog_c="int main(void) { return x; }\n")
        done = self.grade("--build", BUILD)
        self.assertIn("2 of 6 scenarios passed", done.stdout)
        rows = self.rows()
        self.assertEqual({name: (row["points"], row["of"], row["tests/leds"], row["tests/key"])
                          for name, row in rows.items()},
                         {"ada": ("4", "4", "3", "1"), "bob, =1+1": ("0", "4", "0", "0"),
                          "eve": ("0", "4", "0", "0")})
        self.assertEqual(rows["ada"]["remarks"], "")
        self.assertIn("tests/leds: line 7: expect LEDs 0000000101: LEDR shows 0000000100",
                      rows["bob, =1+1"]["remarks"])
        self.assertIn("it could not be built", rows["eve"]["remarks"])
        self.assertIn("prog.c:1", done.stderr)
        self.assertEqual(sorted(os.listdir(self.folder / "hand-ins" / "ada")), ["prog.c"])

    def test_a_formula_is_text(self):
        self.judge("program: prog.elf")
        self.hand_in("=1+1", prog_elf="")
        self.grade(code=2)
        self.assertIn("\r\n'=1+1,0,1,0,", (self.folder / "grades.csv").read_bytes().decode())

    def test_projects(self):
        self.judge("project: .")
        self.hand_in("ada", top_v=TOP % "")
        self.hand_in("bob", top_v=(TOP % "").replace("5", "4"))
        self.grade()
        self.assertEqual(self.points(), {"ada": 1, "bob": 0})

    def test_hostile_programs(self):
        self.judge("program: prog.elf")
        spin = "for (volatile unsigned i = 0;; i++) LEDR_DATA = i * i;"
        self.hand_in("good", prog_c=LIGHT)
        self.hand_in("endless", prog_c=LIGHT.replace("LEDR_DATA = 5;", spin))
        self.hand_in("includes", prog_c=f'#include "{self.secret}"\n' + LIGHT)
        self.hand_in("assembles", prog_c=f'asm(".incbin \\"{self.secret}\\"");\n' + LIGHT)
        self.hand_in("neighbour", prog_c='#include "../../../hand-ins/good/prog.c"\n')
        self.hand_in("link")
        (self.folder / "hand-ins/link").mkdir()
        (self.folder / "hand-ins/link/prog.c").symlink_to(self.folder / "hand-ins/good/prog.c")
        (self.folder / "tests/endless.yaml").write_text(
            "name: endless\nversion: 1\nprogram: prog.elf\nduration: 1000s\n")
        begin = time.monotonic()
        done = self.grade("--build", BUILD, "--time-limit", "5", "--filter", "leds")
        self.assertLess(time.monotonic() - begin, 60)
        self.assertEqual(self.points(), {"good": 1, "endless": 0, "includes": 0, "assembles": 0,
                                         "neighbour": 0, "link": 0})
        self.assertIn("No such file", done.stderr)
        self.grade("--build", BUILD, "--time-limit", "5", "--filter", "endless/tests/endless")
        self.assertIn("did not end within 5 s", self.rows()["endless"]["remarks"])

    def test_hostile_builds(self):
        """The hand-in's own Makefile runs: nothing outside of its copy is read or changed."""
        self.judge("program: prog.elf")
        self.hand_in("good", prog_c=LIGHT, Makefile=f"all:\n\t{BUILD}\n")
        victim = self.folder / "victim"
        self.hand_in("writes", Makefile=f"all:\n\techo x > {victim}\n")
        self.hand_in("reads", Makefile=f"all:\n\tcat {self.secret} /etc/passwd > prog.elf\n")
        self.hand_in("kills", Makefile="all:\n\tkill -9 -1 1 $$PPID; sleep 30\n")
        self.hand_in("network", Makefile="all:\n\tbash -c 'echo > /dev/tcp/127.0.0.1/22 "
                     "&& cp /bin/true prog.elf'\n")
        self.hand_in("memory", Makefile="all:\n\ttail /dev/zero > prog.elf\n")
        self.hand_in("disk", Makefile="all:\n\tfor n in `seq 1000`; do "
                     "head -c 20M /dev/zero > $$n; done\n")
        if os.geteuid():  # root may start as many as it likes
            self.hand_in("processes", Makefile="all:\n\tbash -c 'f() { f | f & }; f'; sleep 30\n")
        done = self.grade("--build", "make -s", "--time-limit", "10", "--output-limit", "100",
                          code=2)
        self.assertEqual({name for name, points in self.points().items() if points}, {"good"})
        self.assertFalse(victim.exists())
        self.assertIn("the build wrote more than 100 MB", done.stderr)
        self.assertNotIn("root:", done.stderr)

    def test_hostile_programs_of_linux(self):
        self.judge("program: prog.elf")
        self.hand_in("good", prog_c=LINUX % "return 1;")
        self.hand_in("passwd", prog_c=LINUX % 'return open("/etc/passwd", O_RDONLY) >= 0;')
        self.hand_in("secret", prog_c=LINUX % f'return open("{self.secret}", O_RDONLY) >= 0;')
        self.hand_in("writes", prog_c=LINUX % 'return open("/tmp/x", O_CREAT | O_RDWR, 0600) >= 0;')
        self.hand_in("network", prog_c=LINUX %
                     "struct sockaddr_in to = {AF_INET, 0x1600, {0x08080808}}; return "
                     "connect(socket(AF_INET, SOCK_STREAM, 0), (void*)&to, sizeof to) == 0;")
        self.hand_in("forks", prog_c=LINUX % "for (;;) fork();")
        self.grade("--build", "arm-linux-gnueabihf-gcc -static prog.c -o prog.elf",
                   "--time-limit", "20")
        points = self.points()
        self.assertEqual(points.pop("good"), 1)
        self.assertEqual(set(points.values()), {0}, points)

    def test_hostile_projects(self):
        self.judge("project: .")
        victim = self.folder / "victim"
        self.hand_in("good", top_v=TOP % "")
        self.hand_in("writes", top_v=TOP % (
            f'integer f; initial begin f = $fopen("{victim}", "w"); $fwrite(f, "x"); end'))
        self.hand_in("runs", top_v=TOP % f'initial $system("touch {victim}");')
        self.hand_in("cplusplus", top_v=TOP % 'initial $c("abort();");')
        self.hand_in("script", top_v=TOP % "", top_qsf=f"exec touch {victim}\n")
        self.hand_in("memory", top_v=TOP % "reg [63:0] m [0:1073741823]; integer i;\n"
                     "initial for (i = 0; i < 1073741824; i = i + 1) m[i] = i;")
        self.hand_in("forged", top_v=(TOP % "").replace("5", "4"))
        libraries = []
        for name in ("good", "forged"):
            self.scenario("play", head=f"duration: 1ms\nproject: hand-ins/{name}")
            self.de1sim("run", "play.yaml")
            libraries += (self.folder / f"hand-ins/{name}/.de1sim").glob("chip-*.so")
        shutil.copy(*libraries)
        self.grade("--time-limit", "60", code=2)
        self.assertFalse(victim.exists())
        points = self.points()
        self.assertEqual({name for name in points if points[name]}, {"good", "writes", "script"})

    def test_wrong_use_is_refused(self):
        self.judge("program: prog.elf")
        self.hand_in("ada", prog_c=LIGHT)
        (self.folder / "none").mkdir()
        for words, reason in (
                (["tests", "--hand-ins", "none"], "a folder for each hand-in, got none"),
                (["tests", "--hand-ins", "no"], "a folder for each hand-in, got No such file"),
                ([".", "--hand-ins", "hand-ins"], "lies in ., the folder of the scenarios"),
                (["tests", "--csv", "x.csv"], "--csv requires --hand-ins")):
            with self.subTest(words=words):
                self.assertIn(reason, self.suite(*words, code=2).stderr)
        self.scenario("tests/wrong", head="duration: 2")
        self.suite("tests/wrong.yaml", "--hand-ins", "hand-ins", code=2)
        self.scenario("tests/none", head="duration: 2ms")
        done = self.suite("tests", "--hand-ins", "hand-ins", code=2)
        self.assertIn("tests/none.yaml: expected `program:` or `project:`", done.stderr)


run()
