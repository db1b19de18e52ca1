"""conftest.py - the tests of sim/python; the environment has DE1SIM, PROGRAMS and PYTHONPATH."""
import os
import pathlib

import pytest

pytest_plugins = ["de1sim.pytest_plugin"]


@pytest.fixture
def programs():
    return pathlib.Path(os.environ["PROGRAMS"])


@pytest.fixture
def tool():
    return os.environ["DE1SIM"]
