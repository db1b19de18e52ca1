"""standin.py - a folder in place of the board: its files, its kernel, its programs, its sshd.

The kernel is a thread: it sees what is written to the overlay's `path` or to /dev/fpga0, takes the
bitstream and says `operating`, or `write init error` for one that starts as `refused`.  A bitstream
is a line "MAP NAME" and filling; a program is a shell script that knows its MAP and its NAME.

sshd serves one connection a process (sshd -i), so that cut() ends a connection and nothing else.
The key exchange is not ssh's default, which takes most of a connection's processor time.
"""
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import threading
import time

PROGRAMS = pathlib.Path(__file__).parent / "bin"
SSHD = "/usr/sbin/sshd"


def text(path):
    try:
        return path.read_text().strip()
    except OSError:
        return ""


class StandIn:
    def __init__(self, folder, way="overlay", systemd=True):
        self.folder = folder
        self.root = folder / "a board's root"
        self.way = way
        self.systemd = systemd
        self.complaints = []  # what would have hung a real board
        self.connections = []
        self.accepted = 0
        self.refuses = False
        self.refused = b"broken"  # how a bitstream starts that does not load
        self.stopping = threading.Event()
        self.make_files()
        self.make_keys()
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.listener.settimeout(0.1)
        self.write_ssh_files(self.listener.getsockname()[1])
        self.threads = [threading.Thread(target=t) for t in (self.serve, self.play_kernel)]
        for thread in self.threads:
            thread.start()

    # ---- Files ----

    def make_files(self):
        for name in ["proc/device-tree/soc", "sys/class", "dev", "registers", "opt", "etc", "run"]:
            (self.root / name).mkdir(parents=True)
        if self.way == "overlay":
            (self.root / "proc/device-tree/soc/base-fpga-region").mkdir()
            (self.root / "sys/kernel/config/device-tree/overlays").mkdir(parents=True)
            self.state = self.root / "sys/class/fpga_manager/fpga0/state"
            self.good = "operating"
        elif self.way == "device":
            os.mkfifo(self.root / "dev/fpga0")
            self.device = os.open(self.root / "dev/fpga0", os.O_RDONLY | os.O_NONBLOCK)
            self.written = b""
            for bridge in ["hps2fpga", "lwhps2fpga"]:
                (self.root / "sys/class/fpga-bridge" / bridge).mkdir(parents=True)
            self.state = self.root / "sys/class/fpga/fpga0/status"
            self.good = "user mode"
        if self.way != "none":
            self.state.parent.mkdir(parents=True)
            (self.state.parent / "name").write_text("Altera SOCFPGA FPGA Manager\n")
        self.set_msel("01010")
        self.bin = self.folder / "bin"
        self.bin.mkdir()
        busybox = shutil.which("busybox")
        subprocess.run([busybox, "--install", "-s", self.bin], check=True)
        if not (self.bin / "busybox").exists():
            os.symlink(busybox, self.bin / "busybox")
        os.symlink(shutil.which("flock"), self.bin / "flock")  # Debian's busybox has none
        for program in PROGRAMS.iterdir():
            self.replace(program.name, program.read_text())
        self.power_on()

    def replace(self, name, script):
        (self.bin / name).unlink(missing_ok=True)
        (self.bin / name).write_text(script)
        (self.bin / name).chmod(0o755)

    def set_msel(self, digits):
        (self.root / "registers/0xFF706000").write_text(f"0x{int(digits, 2) << 3 | 4:08X}\n")

    def power_on(self):
        """As after power was off: nothing in the FPGA, /run empty, bridges off, no overlay."""
        self.fpga = self.root / "fpga"
        self.fpga.write_bytes(b"")
        shutil.rmtree(self.root / "run")
        (self.root / ("run/systemd/system" if self.systemd else "run")).mkdir(parents=True)
        shutil.rmtree(self.root / "sys/kernel/config/device-tree/overlays/de1sim",
                      ignore_errors=True)
        (self.root / "registers/0xFFD0501C").write_text("0x00000007\n")
        for bridge in (self.root / "sys/class/fpga-bridge").glob("*"):
            (bridge / "enable").write_text("0\n")
        if self.way != "none":
            self.state.write_text("power off\n")
        for name in ["running", "service.pid"]:
            (self.root / name).unlink(missing_ok=True)

    def bridges_are_on(self):
        enables = list((self.root / "sys/class/fpga-bridge").glob("*/enable"))
        if enables:
            return all(text(enable) == "1" for enable in enables)
        return int(text(self.root / "registers/0xFFD0501C"), 0) & 3 == 0

    # ---- The kernel ----

    def play_kernel(self):
        overlay = self.root / "sys/kernel/config/device-tree/overlays/de1sim"
        status = str(overlay / "status")
        while not self.stopping.wait(0.01):
            if os.path.exists(status) and text(overlay / "status") == "unapplied" and \
                    text(overlay / "path"):
                self.apply(overlay)
            if self.way == "device":
                self.read_device()

    def apply(self, overlay):
        firmware = self.root / "lib/firmware"
        dtbo = firmware / text(overlay / "path")
        get = ["fdtget", dtbo, "/fragment@0"]
        where = subprocess.run(get + ["target-path"], capture_output=True, text=True).stdout.strip()
        name = subprocess.run(get[:2] + ["/fragment@0/__overlay__", "firmware-name"],
                              capture_output=True, text=True).stdout.strip()
        if not (self.root / "proc/device-tree" / where[1:]).is_dir() or not name:
            return
        self.take((firmware / name).read_bytes())
        if text(self.state) == "operating":
            (overlay / "status").write_text("applied\n")
        else:
            (overlay / "path").write_text("")

    def read_device(self):
        try:
            piece = os.read(self.device, 1 << 20)
        except BlockingIOError:  # a writer, and nothing written yet
            return
        if piece:
            self.state.write_text("write\n")
            self.written += piece
        elif self.written:
            self.take(self.written)
            self.written = b""

    def take(self, bitstream):
        if self.bridges_are_on():
            self.complaints.append("loaded with the bridges on")
        time.sleep(0.02)
        if bitstream.startswith(self.refused):
            self.fpga.write_bytes(b"")
            self.state.write_text("write init error\n")
        else:
            self.fpga.write_bytes(bitstream)
            self.state.write_text(self.good + "\n")

    # ---- ssh ----

    def make_keys(self):
        self.ssh = self.folder / "ssh"
        self.ssh.mkdir()
        for key in ["host_key", "user_key", "other_key"]:
            subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", self.ssh / key],
                           check=True)
        shutil.copy(self.ssh / "user_key.pub", self.ssh / "authorized_keys")
        if os.geteuid() == 0:
            os.makedirs("/run/sshd", mode=0o755, exist_ok=True)  # sshd as root asks for it

    def knows_host(self, key):
        (self.ssh / "known_hosts").write_text("board " + text(self.ssh / key) + "\n")

    def write_ssh_files(self, port):
        self.knows_host("host_key.pub")
        (self.ssh / "sshd_config").write_text(f"""
HostKey "{self.ssh}/host_key"
AuthorizedKeysFile "{self.ssh}/authorized_keys"
PidFile none
StrictModes no
UsePAM no
PasswordAuthentication no
KbdInteractiveAuthentication no
SetEnv "DE1SIM_ROOT={self.root}" "PATH={self.bin}" "HOME={self.folder}"
""")
        (self.ssh / "config").write_text(f"""
Host board
    HostName 127.0.0.1
    Port {port}
    HostKeyAlias board
    IdentityFile "{self.ssh}/user_key"
    IdentitiesOnly yes
    UserKnownHostsFile "{self.ssh}/known_hosts"
    GlobalKnownHostsFile /dev/null
    BatchMode yes
    KexAlgorithms curve25519-sha256
""")

    def serve(self):
        while not self.stopping.is_set():
            try:
                connection, _ = self.listener.accept()
            except TimeoutError:
                continue
            self.accepted += 1
            if self.refuses:
                connection.close()
                continue
            log = open(self.ssh / "log", "ab")
            server = subprocess.Popen([SSHD, "-i", "-f", self.ssh / "sshd_config", "-e"],
                                      stdin=connection, stdout=connection, stderr=log)
            log.close()
            self.connections.append((connection, server))

    def cut(self):
        """As if the cable were unplugged, until heal()."""
        self.refuses = True
        for connection, _ in self.connections:
            try:
                connection.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass

    def heal(self):
        self.refuses = False

    # ---- Processes on the board ----

    def processes(self):
        """(pid, command line) of what runs with this board's root."""
        mark = b"DE1SIM_ROOT=" + bytes(self.root)
        for pid in filter(str.isdigit, os.listdir("/proc")):
            try:
                with open(f"/proc/{pid}/environ", "rb") as environment:
                    if mark not in environment.read().split(b"\0"):
                        continue
                with open(f"/proc/{pid}/cmdline", "rb") as line:
                    yield int(pid), line.read()
            except OSError:
                pass

    def wait_for_rest(self):
        deadline = time.monotonic() + 20
        while any(b"board.sh" in line for _, line in self.processes()):
            if time.monotonic() > deadline:
                raise AssertionError("the board's script does not end")
            time.sleep(0.02)

    def kill_all(self):
        while found := list(self.processes()):
            for pid, _ in found:
                try:
                    os.kill(pid, signal.SIGKILL)
                except OSError:
                    pass
            time.sleep(0.01)

    def boot(self):
        """The power was off and is on again; systemd starts what is enabled."""
        self.kill_all()
        self.power_on()
        if (self.root / "enabled").exists():
            environment = {"DE1SIM_ROOT": str(self.root), "PATH": str(self.bin)}
            subprocess.run([self.bin / "systemctl", "start", "de1sim"], env=environment,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def stop(self):
        self.cut()
        self.stopping.set()
        for thread in self.threads:
            thread.join()
        self.kill_all()
        for connection, server in self.connections:
            connection.close()
            try:
                server.wait(5)
            except subprocess.TimeoutExpired:
                server.kill()
                server.wait()
        self.listener.close()
