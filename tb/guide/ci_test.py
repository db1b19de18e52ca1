"""ci_test.py CI BIN EXAMPLES FOLDER - the CI examples do what a server would do with them.

Runs the commands of CI/*.yml, without those that install packages, in a
copy of EXAMPLES that has two examples; BIN is in front of PATH.  What they keep has to be there.
"""
import base64
import json
import os
import pathlib
import shutil
import subprocess
import sys

import yaml

KEPT = ["report.json", "junit.xml", "audio.wav"]
TWO = ["first_led", "first_picture"]


def github(job):
    commands = [step["run"] for step in job["steps"] if "run" in step]
    kept = [step["with"]["path"] for step in job["steps"] if "path" in step.get("with", {})]
    return commands, kept


def gitlab(job):
    return job["before_script"] + job["script"], job["artifacts"]["paths"]


def main():
    ci, bin_folder, examples, folder = (pathlib.Path(a).resolve() for a in sys.argv[1:])
    container = ci.parents[2] / ".devcontainer"
    build = json.loads((container / "devcontainer.json").read_text())["build"]
    assert (container / build["dockerfile"]).resolve() == ci / "Dockerfile"
    environment = dict(os.environ, PATH=f"{bin_folder}:{os.environ['PATH']}")
    classroom = yaml.safe_load((ci / "classroom.yml").read_text())["jobs"]
    output = folder / "output.txt"  # to which the commands append
    output.unlink(missing_ok=True)
    environment["GITHUB_OUTPUT"] = str(output)
    for server, (commands, kept) in {
            "github": github(yaml.safe_load((ci / "github.yml").read_text())["jobs"]["simulate"]),
            "classroom": github(classroom["run-autograding-tests"]),
            "gitlab": gitlab(yaml.safe_load((ci / "gitlab.yml").read_text())["simulate"])}.items():
        project = folder / server
        shutil.rmtree(project, ignore_errors=True)
        project.mkdir(parents=True)
        for path in examples.iterdir():
            if path.is_file():
                shutil.copy(path, project)
        for name in TWO + ["ci"]:
            shutil.copytree(examples / name, project / name)
        for command in commands:
            if "apt-get" in command:
                continue
            subprocess.run(["sh", "-e", "-c", command], cwd=project, env=environment, check=True)
        for file in [pathlib.Path(path, "runs", name, name, what)
                     for path in kept for name in TWO for what in KEPT]:
            assert (project / file).exists(), f"{server}: no {file}"
        if server == "classroom":
            key, result = output.read_text().split("=", 1)
            assert key == "result" and json.loads(base64.b64decode(result))["max_score"] == 2
        print(f"{server}: {len(commands)} commands, kept {kept}")


main()
