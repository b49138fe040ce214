#!/usr/bin/env python3
"""Runs what a page of documentation shows, in a scratch copy of the scenes.

    ```diff      is applied to the copy
    ```console   lines after `$ ` are run; what follows must be their output; … stands for anything
    ```sh        `make TARGET` must be a target of the Makefile (a dry run)
    ```cpp       must compile against the sdk
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
    """Yields (language, line number, text) of each fenced block."""
    for found in re.finditer(r"^```(\w+)\n(.*?)^```$", page, re.M | re.S):
        yield found.group(1), page[: found.start()].count("\n") + 2, found.group(2)


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


def run(command, folder, environment):
    done = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, timeout=300)
    return done.stdout


def compiles(text, source):
    """Returns what the compiler says, empty where it says nothing."""
    includes = ["-I", source / "sdk/include", "-I", source / "sdk/contract/include", "-isystem", "/usr/include/eigen3"]
    done = subprocess.run(["c++", "-std=c++20", "-Wall", "-Wextra", "-fsyntax-only", "-DSTYLET_PLUGIN_FILE=\"\"", *includes, "-x", "c++", "-"],
                          input=text, text=True, capture_output=True)
    return done.stderr


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("page", type=pathlib.Path)
    options.add_argument("--bin", required=True)
    options.add_argument("--source", required=True, type=pathlib.Path)
    given = options.parse_args()
    environment = dict(os.environ, PATH=os.path.abspath(given.bin) + os.pathsep + os.environ["PATH"])
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(given.source / "scenes", pathlib.Path(folder) / "scenes")
        for language, line, text in blocks(given.page.read_text()):
            where = f"{given.page.name}:{line}"
            if language == "diff":
                done = subprocess.run(["git", "apply", "-"], input=text, text=True, cwd=folder, capture_output=True)
                if done.returncode != 0:
                    print(f"{where}: the diff does not apply:\n{done.stderr}")
                    wrong += 1
            elif language == "sh":
                for target in re.findall(r"^make (\w+)", text, re.M):
                    if subprocess.run(["make", "-n", target], cwd=given.source, capture_output=True).returncode != 0:
                        print(f"{where}: `make {target}` is no target")
                        wrong += 1
            elif language == "cpp":
                if said := compiles(text, given.source):
                    print(f"{where}: does not compile:\n{said}")
                    wrong += 1
            elif language == "console":
                for command, expected in commands(text):
                    found = run(command, folder, environment)
                    if not agrees(expected, found):
                        print(f"{where}: `{command}` printed something else:")
                        print("".join(difflib.unified_diff(expected.splitlines(True), found.splitlines(True), "shown", "printed")))
                        wrong += 1
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
