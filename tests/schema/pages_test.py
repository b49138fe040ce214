#!/usr/bin/env python3
"""docs/plugins is what `stylet plugins --pages` writes now; the pages hold nothing of this machine, and YAML that can be read."""

import difflib
import os
import pathlib
import re
import tempfile
import unittest

import bench

PAGES = bench.SOURCE / "docs/plugins"
SHOWN = 20  # lines of a change
REMEDY = "\nWrite the pages again and commit them:\n    build/release/bin/stylet plugins --pages docs/plugins"


def texts(folder):
    return {file.name: file.read_text() for file in sorted(pathlib.Path(folder).iterdir())}


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            bench.stylet("plugins", "--pages", folder)
            cls.written = texts(folder)
        cls.kept = texts(PAGES)

    def test_are_those_of_the_plugins_that_there_are(self):
        surplus = sorted(f"docs/plugins/{name}" for name in set(self.kept) - set(self.written))
        self.assertEqual(surplus, [], f"\nThere are no such plugins. Take their pages out:\n    git rm {' '.join(surplus)}")
        self.assertEqual(sorted(set(self.written) - set(self.kept)), [], REMEDY)

    def test_say_what_the_plugins_declare(self):
        for name, text in self.written.items():
            kept = self.kept.get(name, "")
            change = list(difflib.unified_diff(kept.splitlines(), text.splitlines(), f"docs/plugins/{name}", "written now", "", "", 1, ""))
            self.assertTrue(kept == text, "\n" + "\n".join(change[:SHOWN]) + REMEDY)

    def test_hold_nothing_of_this_machine(self):
        for name, text in self.written.items():
            for path in (bench.SOURCE, os.environ["STYLET"], "/lib/", ".so"):
                self.assertNotIn(str(path), text, name)

    def test_show_yaml_that_can_be_read(self):
        for name, text in self.written.items():
            for block in re.findall(r"^```yaml\n(.*?)^```$", text, re.M | re.S):
                scene = bench.read(block)
                self.assertIn(f"type: {name[:-3]}\n", block)
                self.assertTrue(set(scene) <= {"tissue", "needle", "effects", "device"}, name)


if __name__ == "__main__":
    unittest.main()
