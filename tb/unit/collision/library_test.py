"""library_test.py CASE SW_COLLISION WORK [CXX] - the library used without the rest of this tree.

readme      the README shows example/main.cpp as it is, the CMake that the other cases build it
            with, and what it prints
subfolder   a bare project takes the library by add_subdirectory, and its program prints that
installed   the library is built and installed alone, and a bare project finds it
"""
import pathlib
import re
import shutil
import subprocess
import sys

CASE, LIBRARY, WORK = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])


def blocks():
    """The README's code blocks by language; one of each."""
    text = (LIBRARY / "README.md").read_text()
    return {language: code for language, code in re.findall(r"```([\w+]+)\n(.*?)```", text, re.S)}


def run(*command):
    print("+", *command, flush=True)
    return subprocess.run([str(word) for word in command], check=True, text=True,
                          stdout=subprocess.PIPE).stdout


def cmake(source, build, *definitions):
    run("cmake", "-S", source, "-B", build, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={sys.argv[4]}",
        *definitions)
    run("cmake", "--build", build, "-j", "1")


def example(cmake_lines, *definitions):
    """Builds and runs the example in a fresh folder; its output must be the README's."""
    project = WORK / "project"
    project.mkdir(parents=True)
    shutil.copy(LIBRARY / "example" / "main.cpp", project)
    (project / "CMakeLists.txt").write_text(cmake_lines)
    cmake(project, WORK / "build", *definitions)
    printed = run(WORK / "build" / "example")
    assert printed == blocks()["text"], f"the example prints, other than in the README:\n{printed}"


def subfolder():
    lines = blocks()["cmake"].replace("path/to/sw/collision", f'"{LIBRARY.as_posix()}"')
    assert "add_subdirectory(" in lines
    example(lines)


def installed():
    cmake(LIBRARY, WORK / "library")
    run("cmake", "--install", WORK / "library", "--prefix", WORK / "prefix")
    lines = re.sub(r"add_subdirectory\(.*\)", "find_package(de1sim REQUIRED)", blocks()["cmake"])
    example(lines, f"-DCMAKE_PREFIX_PATH={WORK / 'prefix'}")


def readme():
    source = (LIBRARY / "example" / "main.cpp").read_text()
    assert blocks()["c++"] == source, "README.md shows another example than example/main.cpp"


shutil.rmtree(WORK, ignore_errors=True)
{"readme": readme, "subfolder": subfolder, "installed": installed}[CASE]()
