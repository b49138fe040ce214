#!/usr/bin/env python3
"""Runs what a page of documentation shows, in a scratch folder that is home and holds a copy of the scenes, and the build as build/release.

    ```diff      is applied to the copy
    ```console   lines after `$ ` are run; what follows must be their output; … stands for anything
    ```sh        is run and must succeed; of `make TARGET`, TARGET must be a target of the Makefile (a dry run)
    ```cpp       must compile against the sdk

As in a terminal, `cd` holds for what follows, until the next section.
"""

import argparse
import difflib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile


def blocks(page):
    """Yields (language, line number, text) of each fenced block, and ("section", line number, title) of each heading."""
    for found in re.finditer(r"^## ([^\n]*)$|^```(\w+)\n(.*?)^```$", page, re.M | re.S):
        line = page[: found.start()].count("\n") + 2
        yield ("section", line, found.group(1)) if found.group(1) else (found.group(2), line, found.group(3))


def commands(text):
    """Yields (command, expected output) of a console block."""
    for part in re.split(r"^\$ ", text, flags=re.M)[1:]:
        command, _, expected = part.partition("\n")
        yield command, expected


def agrees(expected, found):
    def tidy(output):
        return "\n".join(line.rstrip() for line in output.strip("\n").split("\n"))

    pattern = ".*?".join(re.escape(piece) for piece in tidy(expected).split("…"))
    return re.fullmatch(pattern, tidy(found), re.S) is not None


class Terminal:
    """A shell that stays where it was led. What it says and whether it succeeded: (output, success)."""

    def __init__(self, home, given):
        self.home = self.folder = home
        self.environment = dict(os.environ, HOME=str(home), CXX=given.compiler, CMAKE_BUILD_PARALLEL_LEVEL="2",
                                PATH=f"{given.build / 'bin'}{os.pathsep}{os.environ['PATH']}")

    def run(self, script):
        end = self.home / ".folder"
        done = subprocess.run(["bash", "-e", "-c", f"trap 'pwd >{end}' EXIT\n{script}"], cwd=self.folder, env=self.environment,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600)
        self.folder = end.read_text().rstrip("\n")
        return done.stdout, done.returncode == 0


def compiles(text, given):
    """Returns what the compiler says, empty where it says nothing."""
    includes = ["-I", given.source / "sdk/include", "-I", given.source / "sdk/contract/include", "-isystem", "/usr/include/eigen3"]
    done = subprocess.run([given.compiler, "-std=c++20", "-Wall", "-Wextra", "-fsyntax-only", "-DSTYLET_PLUGIN_FILE=\"\"", *includes,
                           "-x", "c++", "-"], input=text, text=True, capture_output=True)
    return done.stderr


def complaints(language, text, terminal, given):
    """Yields what is wrong with a block."""
    if language == "section":
        terminal.folder = terminal.home
    elif language == "diff":
        done = subprocess.run(["git", "apply", "-"], input=text, text=True, cwd=terminal.home, capture_output=True)
        if done.returncode != 0:
            yield f"the diff does not apply:\n{done.stderr}"
    elif language == "sh":
        for target in re.findall(r"^make (\w+)", text, re.M):
            if subprocess.run(["make", "-n", target], cwd=given.source, capture_output=True).returncode != 0:
                yield f"`make {target}` is no target"
        said, success = terminal.run(re.sub(r"^make .*$", "", text, flags=re.M))
        if not success:
            yield f"fails:\n{said}"
    elif language == "cpp":
        if said := compiles(text, given):
            yield f"does not compile:\n{said}"
    elif language == "console":
        for command, expected in commands(text):
            found, _ = terminal.run(command)
            if not agrees(expected, found):
                lines = difflib.unified_diff(expected.splitlines(True), found.splitlines(True), "shown", "printed")
                yield f"`{command}` printed something else:\n{''.join(lines)}"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("page", type=pathlib.Path)
    options.add_argument("--build", required=True, type=pathlib.Path)
    options.add_argument("--source", required=True, type=pathlib.Path)
    options.add_argument("--compiler", required=True)
    given = options.parse_args()
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        home = pathlib.Path(folder)
        shutil.copytree(given.source / "scenes", home / "scenes")
        (home / "build").mkdir()
        (home / "build/release").symlink_to(given.build.resolve())
        terminal = Terminal(home, given)
        for language, line, text in blocks(given.page.read_text()):
            for complaint in complaints(language, text, terminal, given):
                print(f"{given.page.name}:{line}: {complaint}")
                wrong += 1
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
