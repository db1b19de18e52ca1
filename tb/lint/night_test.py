"""night_test.py BUILD NIGHT - each line of night.txt names tests that are there."""
import json
import pathlib
import re
import subprocess
import sys

build, night = sys.argv[1:]
listed = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, check=True,
                        capture_output=True).stdout
names = [test["name"] for test in json.loads(listed)["tests"]]
for line in pathlib.Path(night).read_text().splitlines():
    if line and not line.startswith("#") and not any(re.search(line.split()[0], name)
                                                     for name in names):
        sys.exit(f"{night}: no test is named so: {line.split()[0]}")
