#!/usr/bin/env python3
"""The schema by itself, and the scenes that it must take."""

import json
import pathlib
import re
import tempfile
import unittest

import jsonschema

import bench


def subschemas(schema, path=""):
    """Yields (path, schema) of all of them."""
    if isinstance(schema, dict):
        yield path, schema
        for key, value in schema.items():
            yield from subschemas(value, f"{path}/{key}")
    elif isinstance(schema, list):
        for number, value in enumerate(schema):
            yield from subschemas(value, f"{path}/{number}")


class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.schema = bench.schema()
        cls.editor = bench.editor()

    def test_is_itself_sound(self):
        jsonschema.Draft7Validator.check_schema(self.schema)

    def test_explains_every_key(self):
        """Where it is declared: a definition repeats some for the map that it shares, and rules name some."""
        for path, schema in subschemas(self.schema):
            for key, value in schema.get("properties", {}).items():
                declared = isinstance(value, dict) and "/allOf/" not in path
                explained = not declared or "$ref" in value or value.get("description")
                self.assertTrue(explained, f"{path}/{key}")

    def test_forbids_unknown_keys_wherever_keys_are_declared(self):
        for path, schema in subschemas(self.schema):
            if schema.get("type") == "object" and "properties" in schema:
                chosen_by_type = any("$ref" in rule.get("then", {}) for rule in schema.get("allOf", []))
                self.assertTrue(schema.get("additionalProperties") is False or chosen_by_type, path)

    def test_holds_every_parameter_of_every_plugin_with_its_meaning_and_source(self):
        for plugin in json.loads(bench.stylet("plugins", "--json").stdout):
            definition = self.schema["definitions"][plugin["name"]]
            self.assertIn(plugin["source"], definition["description"])
            for parameter in plugin["parameters"]:
                found = definition["properties"][parameter["name"]]
                self.assertIn(parameter["meaning"], found["description"])
                self.assertIn(plugin["source"], found["description"])
                self.assertEqual(parameter["required"], parameter["name"] in definition["required"])

    def test_says_unit_range_and_need_of_a_quantity(self):
        length = self.schema["properties"]["needle"]["properties"]["length"]
        for words in ("needle length", "required", "a length in m such as '25 mm'", "more than 0 m", "stylet check"):
            self.assertIn(words, length["description"])
        self.assertRegex(length["examples"][0], length["pattern"])

    def test_shows_examples_that_it_takes(self):
        for path, schema in subschemas(self.schema):
            for example in schema.get("examples", []):
                self.assertTrue(jsonschema.Draft7Validator(schema).is_valid(example), f"{path}: {example}")

    def test_takes_every_prepared_scene(self):
        scenes = sorted(file for file in (bench.SOURCE / "scenes").rglob("*.yaml") if file.parent.name != "studies")
        self.assertGreaterEqual(len(scenes), 8)  # Figs. 9, 10(a) and 10(b) of the paper
        for scene in scenes:
            self.assertEqual(bench.complaints(bench.read(scene.read_text()), self.editor), [], scene)

    def test_holds_the_users_plugins(self):
        """`lattice` is no plugin of ours: a tissue with a required and an optional parameter, in a map of its own."""
        self.assertNotIn("lattice", json.dumps(self.schema))
        good = (bench.SOURCE / "tests/loading/good.yaml").read_text()
        editor = bench.editor(*bench.TEST_PLUGINS)
        self.assertEqual(bench.complaints(bench.read(good), editor), [])
        self.assertEqual(bench.complaints(bench.read(good.replace("type: half_space", "type: lattice")), editor), [])
        for mistake in ("lattice: {cells: [15, 15]}", "lattice: {cells: [1, 1, 1], dampng: 1 1/s}", "lattice: {}"):
            bad = good.replace("lattice: {cells: [15, 15, 15]}", mistake)
            self.assertNotEqual(bench.complaints(bench.read(bad), editor), [], mistake)
        needs_its_map = good.replace("type: half_space", "type: lattice").replace("  lattice: {cells: [15, 15, 15]}\n", "")
        self.assertEqual(bench.complaints(bench.read(needs_its_map), editor), ["tissue: 'lattice' is a required property"])

    def test_asks_for_a_radius_or_a_gauge(self):
        good = (bench.SOURCE / "tests/loading/good.yaml").read_text()
        editor = bench.editor(*bench.TEST_PLUGINS)
        for sound, radii in ((True, "gauge: 22G"), (True, "radius: 1 mm"), (True, "radius: 1 mm, inner_radius: 0.5 mm"), (False, "ends: pinned-pinned"),
                             (False, "gauge: 22G, radius: 1 mm"), (False, "gauge: 22G, inner_radius: 1 mm"), (False, "inner_radius: 1 mm")):
            scene = bench.read(good)
            del scene["needle"]["radius"]
            scene["needle"].update(bench.read(f"{{{radii}}}"))
            self.assertEqual(bench.complaints(scene, editor) == [], sound, radii)

    def test_is_found_by_the_first_line_of_a_scene(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "scenes").mkdir()
            self.assertEqual(bench.stylet("schema", "--out", "stylet.schema.json", folder=folder).stdout, "stylet.schema.json\n")
            scene = folder / "scenes/fig9.yaml"
            text = (bench.SOURCE / "scenes/paper/fig9.yaml").read_text()
            scene.write_text("# yaml-language-server: $schema=../stylet.schema.json\n" + text)
            self.assertEqual(bench.stylet("check", scene).stdout, f"{scene}: sound\n")
            named = re.match(r"# yaml-language-server: \$schema=(.*)\n", scene.read_text()).group(1)
            editor = jsonschema.Draft7Validator(json.loads((scene.parent / named).read_text()))
            self.assertEqual(bench.complaints(bench.read(scene.read_text()), editor), [])


if __name__ == "__main__":
    unittest.main()
