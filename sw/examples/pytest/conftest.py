"""conftest.py - the fixture `board` for all tests in this folder."""
pytest_plugins = ["de1sim.pytest_plugin"]
