#!/usr/bin/env python3
"""Every scene of tests/bad_scenes is refused by the schema, too, but for those whose fault no schema can see."""

import unittest

import yaml

import bench

# An editor's YAML reader refuses these before the schema has a look.
NO_YAML = {
    "bad_indent": "a line is indented by one space too many",
    "bad_yaml": "a bracket is not closed",
    "map_as_key": "a key is a map",
    "two_documents": "one document is one scene",
}
# These it cannot see. Each with the reason.
UNSEEN = {
    "alias": "the YAML reader puts the value in place of the alias",
    "duplicate_key": "the YAML reader keeps one of the two; editors mark the other by themselves",
    "missing_file": "a schema looks for no files",
    "file_outside": "whether '..' leaves the folder tree depends on where the scene lies",
    "unknown_unit": "only UDUNITS-2 knows what is a unit",
    "wrong_unit": "only UDUNITS-2 knows the dimension of a unit",
    "thick_needle": "compares two values: radius and length",
    "short_for_its_gauge": "compares two values: the gauge's radius and the length",
    "tube_without_wall": "compares two values: inner_radius and radius",
    "layers_alike": "compares items of a list: the names; only the last may leave its thickness out",
    "layers_too_thick": "adds up items of a list and compares the sum with the extent",
    "layers_leave_a_gap": "adds up items of a list and compares the sum with the extent",
}

NO_TEXT = "not_utf8"


class BadScenes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.editor = bench.editor(*bench.TEST_PLUGINS)
        cls.scenes = {file.stem: file.read_bytes() for file in (bench.SOURCE / "tests/bad_scenes").glob("*.yaml")}

    def found(self, name):
        return bench.complaints(bench.read(self.scenes[name]), self.editor)

    def test_of_which_some_are_no_yaml(self):
        for name in NO_YAML:
            with self.assertRaises(yaml.YAMLError, msg=name):
                bench.read(self.scenes[name])

    def test_of_which_some_cannot_be_seen(self):
        for name in UNSEEN:
            self.assertEqual(self.found(name), [], f"{name} is seen by now: take it out of UNSEEN")

    def test_of_which_one_is_no_text(self):
        with self.assertRaises(yaml.reader.ReaderError):
            bench.read(self.scenes[NO_TEXT])

    def test_are_refused_otherwise(self):
        others = sorted(set(self.scenes) - set(NO_YAML) - set(UNSEEN) - {NO_TEXT})
        for name in others:
            self.assertNotEqual(self.found(name), [], f"{name} passes: let the schema see it, or tell in UNSEEN why it cannot")
        print(f"{len(others)} of {len(self.scenes)} bad scenes are refused by the schema, {len(NO_YAML)} by the YAML reader")


if __name__ == "__main__":
    unittest.main()
