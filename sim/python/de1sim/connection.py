"""connection.py - the process of `de1sim live`, and the WebSocket to it.

A thread reads what comes, so that the server never waits; the messages are taken in order by
whoever has the board.
"""
import asyncio
import concurrent.futures
import json
import os
import pathlib
import queue
import re
import shutil
import signal
import subprocess
import tempfile
import threading
import time

try:
    import websockets
except ModuleNotFoundError:
    raise ImportError("de1sim needs the Python package websockets: apt install "
                      "python3-websockets, or pip install websockets") from None

from .errors import Ended, Refused

BEGIN_S = 60  # of this machine's time, until the server has printed its address


class Connection:
    """A server of its own, which ends with it: by close(), or since the connection is gone."""

    def __init__(self, words, de1sim=None):
        program = de1sim or os.environ.get("DE1SIM") or shutil.which("de1sim")
        if not program:
            raise Refused("no de1sim: expected it on PATH, or its path in the variable DE1SIM")
        self._stderr = tempfile.NamedTemporaryFile("w+", prefix="de1sim-", suffix=".txt")
        self._queue = queue.Queue()
        self._loop = None
        command = [os.fspath(program), "live", "--driven", "--port", "0", *words]
        try:  # a session of its own: Ctrl-C is for the tests, which then close the board
            self._process = subprocess.Popen(command, stdin=subprocess.DEVNULL,
                                             stdout=subprocess.DEVNULL, stderr=self._stderr,
                                             start_new_session=True)
        except OSError as error:
            self._stderr.close()
            raise Refused(f"cannot start {program}: {error.strerror}") from None
        try:
            self.url = self._address()
            self._connect()
        except BaseException:
            self.close()
            raise

    def said(self):
        """What the process has printed, such as why it has ended."""
        text = pathlib.Path(self._stderr.name).read_text("utf-8", "replace")
        lines = [line for line in text.splitlines()
                 if "the board is at" not in line and "Ctrl-C ends it" not in line]
        return "\n".join(lines).strip()

    def send(self, **message):
        if self._loop is None:
            raise Ended("the board is closed")
        self._do(self._socket.send(json.dumps(message)))

    def receive(self):
        """The next message: a text's object, or bytes.  None: there comes no other."""
        return self._queue.get()

    def close(self):
        """Ends the process; may be called again."""
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGINT)
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        if self._loop:
            self._thread.join()
            self._loop.close()
            self._loop = None
        self._stderr.close()

    def _address(self):
        end = time.monotonic() + BEGIN_S
        while time.monotonic() < end:
            text = pathlib.Path(self._stderr.name).read_text("utf-8", "replace")
            if found := re.search(r"http://\S+/\?token=\w+(?=\n)", text):
                return found.group()
            if self._process.poll() is not None:
                raise Refused(self.said())
            time.sleep(0.005)
        raise Refused(f"no answer from de1sim live in {BEGIN_S} s: {self.said()}")

    def _connect(self):
        self._loop = asyncio.new_event_loop()
        connected = threading.Event()
        self._thread = threading.Thread(target=self._loop.run_until_complete,
                                        args=(self._read(connected),), daemon=True)
        self._thread.start()
        connected.wait()
        if self._socket is None:
            raise Refused(f"no connection to {self.url}: {self.said()}")

    async def _read(self, connected):
        self._socket = None
        try:
            # Nothing but the end of the process ends the connection, however long that takes.
            self._socket = await websockets.connect(
                self.url.replace("http:", "ws:").replace("/?", "/ws?"), max_size=None,
                compression=None, ping_interval=None, close_timeout=1)
            connected.set()
            async for message in self._socket:
                self._queue.put(json.loads(message) if isinstance(message, str) else message)
        except (OSError, websockets.WebSocketException):
            pass
        finally:
            self._queue.put(None)
            connected.set()

    def _do(self, coroutine):
        try:
            done = asyncio.run_coroutine_threadsafe(coroutine, self._loop)
            while self._thread.is_alive():
                try:
                    return done.result(0.2)
                except concurrent.futures.TimeoutError:
                    pass
        except (RuntimeError, websockets.ConnectionClosed):
            pass
        coroutine.close()
        raise Ended("the board is not connected any more")
