"""bare_root.py - a Debian with nothing but a package's dependencies, made of this machine's files.

So that a package can be tried without a network: the files of the packages that it depends on, and
of those that every Debian has, are copied into a folder, with dpkg's records of them.
"""

import os
import pathlib
import re
import shutil
import subprocess

STATUS = pathlib.Path("/var/lib/dpkg/status")
INFO = pathlib.Path("/var/lib/dpkg/info")
RECORDS = {"list", "md5sums", "shlibs", "symbols", "triggers"}


def installed():
    """Name to fields, of every package here."""
    packages = {}
    for stanza in STATUS.read_text().strip().split("\n\n"):
        fields = dict(re.findall(r"^([A-Za-z-]+): *((?:.*)(?:\n .*)*)", stanza, re.M))
        if fields["Status"].endswith(" installed"):
            packages[fields["Package"]] = {**fields, "stanza": stanza}
    return packages


def closure(depends, packages):
    """Names of the packages that `depends`, a package's field, asks for, and of the essential."""
    provided = {}
    for name, fields in packages.items():
        virtual = re.sub(r"\(.*?\)", "", fields.get("Provides", ""))
        for one in re.findall(r"[a-z0-9.+-]+", virtual):
            provided.setdefault(one, name)
    chosen = set()
    wanted = [name for name, fields in packages.items() if fields.get("Essential") == "yes"]
    wanted.append("dpkg")

    def ask(field):
        for alternatives in filter(None, field.split(",")):
            names = [re.sub(r"[(:\[].*", "", one).strip() for one in alternatives.split("|")]
            name = next((provided.get(one, one) for one in names
                         if one in packages or one in provided), None)
            if name is None:
                raise LookupError(f"none of {names} is installed here")
            wanted.append(name)

    ask(depends)
    while wanted:
        name = wanted.pop()
        if name in chosen:
            continue
        chosen.add(name)
        ask(packages[name].get("Depends", "") + "," + packages[name].get("Pre-Depends", ""))
    return chosen


def copy(path, root):
    to = root / path.lstrip("/")
    source = pathlib.Path(path)
    if to.exists() or to.is_symlink():
        return
    if source.is_symlink():
        to.symlink_to(os.readlink(source))
    elif source.is_dir():
        to.mkdir()
    elif source.is_file():  # a small image of Debian leaves documents out
        shutil.copy2(source, to)


def make(root, depends):
    """The root of a Debian with the packages that `depends` asks for."""
    packages = installed()
    names = closure(depends, packages)
    root.mkdir(parents=True)
    (root / "usr").mkdir()
    for folder in ("bin", "lib", "lib32", "lib64", "libx32", "sbin"):
        if pathlib.Path("/" + folder).is_symlink():
            (root / "usr" / folder).mkdir()
            (root / folder).symlink_to("usr/" + folder)
    for folder in ("dev", "proc", "tmp", "var/lib/dpkg/info", "var/lib/dpkg/updates", "etc"):
        (root / folder).mkdir(parents=True, exist_ok=True)
    (root / "dev/null").touch()
    shutil.copytree("/etc/alternatives", root / "etc/alternatives", symlinks=True)
    stanzas = []
    for name in sorted(names):
        stanzas.append(packages[name]["stanza"])
        architecture = packages[name]["Architecture"]
        for label in (name, f"{name}:{architecture}"):
            for record in INFO.glob(f"{label}.*"):
                if record.name[len(label) + 1:] in RECORDS:
                    shutil.copy2(record, root / "var/lib/dpkg/info")
        for path in subprocess.check_output(["dpkg-query", "-L", name], text=True).splitlines():
            if path.startswith("/") and path != "/.":
                copy(path, root)
    (root / "var/lib/dpkg/status").write_text("\n\n".join(stanzas) + "\n")
    shutil.copy2(INFO / "format", root / "var/lib/dpkg/info")
    return names
