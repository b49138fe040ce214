#!/usr/bin/env python3
"""What the schema and `stylet check` say of the same scenes: alike, but where this page says otherwise."""

import itertools
import pathlib
import tempfile
import unittest

import bench

SCENE = """\
stylet: {version}
title: {title}
tissue:
  type: half_space
  extent: {extent}
  fixed: {fixed}
  layers: {layers}
  {tissue_map}
needle:
  type: beam_column
  length: {length}
  {radii}
  youngs_modulus: 200 GPa
  ends: clamped-free
  buckling: {buckling}
effects: {effects}
device:
  type: recorded_hand
  file: {file}
  motion: {motion}
  force_limit: {force_limit}
coupling: {{contact_spacing: 5 mm}}
run: {{rate: 1 kHz, duration: 8 s}}
record: {record}
"""
GOOD = {
    "version": "1",
    "title": "Agreement",
    "extent": "[100 mm, 100 mm, 100 mm]",
    "fixed": "bottom",
    "layers": "[{name: gel, youngs_modulus: 25 kPa, poisson_ratio: 0.4}]",
    "tissue_map": "half_space: {}",
    "length": "200 mm",
    "radii": "radius: 1 mm",
    "buckling": "{type: euler}",
    "effects": "[{type: friction, per_length: 5 N/m}]",
    "file": "hand.csv",
    "motion": "[{way: insert, speed: 10 mm/s}]",
    "force_limit": "5 N",
    "record": "[depth, ledger]",
}


def with_damping(value):
    return f"lattice: {{cells: [1, 2, 3], damping: {value}}}"


def with_cells(value):
    return f"lattice: {{cells: {value}}}"


def with_bore(value):
    return f"radius: 1 mm\n  inner_radius: {value}"


def with_strut(value):
    return f"{{type: strut, strut: {value}}}"


def with_poisson_ratio(value):
    return f"[{{name: gel, youngs_modulus: 25 kPa, poisson_ratio: {value}}}]"


def with_times(value):
    return f"[{{way: hold, speed: 1 m/s, times: {value}}}]"


# Both take these. (key of GOOD, how the value stands there, values)
SOUND = [
    # more than 0 N
    ("force_limit", str, ["5 N", "5N", "+5 N", "5. N", ".5 N", "0.05 N", "00.5 N", "5e-3 N", "5E+3 N", "1e3 mN", "'  5 N '", '"5 N"',
                          "5 kg*m/s^2", "5 kg m s-2", "5 J/m", "5 µN", "2 lbf"]),
    # at least 0 1/s
    ("tissue_map", with_damping, ["0 1/s", "0.0 Hz", "2 1/s", "2 s-1", "2 s^-1", "2 1/ms"]),
    # more than -1 and less than 0.5
    ("layers", with_poisson_ratio, ["0.4", ".4", "4e-1", "+0.4", "-0.5", "0", "0.", "-0"]),
    # a whole number from 1 to 1000
    ("motion", with_times, ["1", "3", "1000"]),
    ("tissue_map", with_cells, ["[1, 2.5, -3e2]"]),
    ("extent", str, ["[1 m, 2e2 mm, .1 km]"]),
    ("title", str, ["word", "'two words'", "5", "0.5", "1e3", "true", "yes", "2024-01-01", "''", "0x10"]),
    ("fixed", str, ["sides", "'sides'", '"bottom_and_sides"']),
    ("motion", str, ["[]", "[{way: hold, speed: 1 m/s}, {way: insert, speed: 1 m/s, times: 2}]"]),
    ("record", str, ["[time]", "[ledger, ledger, depth]", "[\"depth\"]"]),
    ("effects", str, ["[]", "[{type: friction, per_length: 1 N/m}, {type: fracture, rupture_force: 1 N, toughness: 1 J/m^2}]"]),
    ("tissue_map", str, ["half_space: {}", "lattice: {cells: [1, 2, 3]}", "# nothing"]),
    ("radii", str, ["gauge: 22G", "gauge: '7G'", "radius: 0.1 mm"]),
    ("radii", with_bore, ["0.5 mm", "999 um"]),
    ("buckling", str, ["{type: euler, euler: {}}", "{type: euler, strut: {strength: 1 Pa}}"]),
    ("buckling", with_strut, ["{strength: 1 Pa}", "{strength: 1 kPa, form: printed}"]),
]

# Both refuse these.
WRONG = [
    ("version", str, ["2", "1.5", "one", "~", "[1]"]),
    ("force_limit", str, ["5", "5.0", "1e3", "'5'", "'5e3'", "N", "kN 5", "-5 N", "+-5 N", "0 N", "0.0 N", "+0e3 N", "0e N", "5 /s", "5 (N)",
                          "5 @ N", "5 -N", "5..0 N", "1.2.3 N", "5 5", "''", "nan N", "inf N", ".inf", "~", "true", "[5 N]", "{a: 5 N}",
                          "5 N" + 40 * "*N"]),
    ("tissue_map", with_damping, ["-1 1/s", "1", "0", "11/ s", "1 2/s"]),
    ("layers", with_poisson_ratio, ["0.5", "-1", "-1.5", "5e-1", "0.4 Pa", "'0.4 m'", "much", ".inf", "true", "[0.4]", "~", "''"]),
    ("motion", with_times, ["0", "-1", "1001", "2.5", "3 m", "three", "true", "~", "[1]"]),
    ("tissue_map", with_cells, ["[1, 2]", "[1, 2, 3, 4]", "[1, 2, 3 m]", "[1, 2, ~]", "5", "[]", "~", "[[1, 2, 3]]"]),
    ("extent", str, ["[1, 2, 3]", "[1 m, 2 m]", "1 m", "[1 m, 0 m, 1 m]", "[1 m, -1 m, 1 m]", "{x: 1 m}", "~"]),
    ("title", str, ["~", "null", "[a]", "{a: b}", ""]),
    ("fixed", str, ["botom", "Bottom", "5", "~", "[bottom]", "true"]),
    ("file", str, ["/etc/hostname", "''", "~", "[hand.csv]"]),
    ("motion", str, ["~", "{}", "hold", "[hold]", "[{}]", "[{way: hold}]", "[{way: hold, speed: 1 m/s, tims: 2}]", "[~]"]),
    ("record", str, ["[]", "[dpth]", "depth", "~", "{}", "[[depth]]", "[~]"]),
    ("effects", str, ["~", "{}", "friction", "[~]", "[friction]", "[{}]", "[{type: frictin}]", "[{type: [friction]}]", "[{type: euler}]",
                      "[{type: friction}]", "[{type: friction, per_length: 5 N/m, layr: a}]", "[{type: friction, per_length: 5}]",
                      "[{type: fracture, rupture_force: 1 N, toughness: 1 J/m^2, per_length: 1 N/m}]"]),
    ("buckling", str, ["~", "euler", "{}", "[]", "{type: euler, ends: 1}", "{type: friction}", "{type: ~}"]),
    ("radii", str, ["# none", "gauge: 22", "gauge: 6G", "gauge: 22g", "gauge: ~", "gauge: [22G]", "radius: ~", "gauge: 22G\n  radius: 1 mm",
                    "gauge: 22G\n  inner_radius: 1 mm", "inner_radius: 0.1 mm"]),
    ("radii", with_bore, ["0 mm", "-1 mm", "0.5", "~"]),
    ("buckling", str, ["{type: strut}", "{type: strut, strength: 1 Pa}", "{type: euler, friction: {per_length: 1 N/m}}", "{type: euler, strutt: {}}"]),
    ("buckling", with_strut, ["{}", "{strength: 1}", "{strength: 1 Pa, form: prined}", "~", "[]"]),
    ("tissue_map", str, ["half_space: ~", "half_space: []", "half_space: {cells: 1}", "lattice: {}", "friction: {}", "beam_column: {}",
                         "lattise: {}", "type_: lattice"]),
]

# Only `stylet check` refuses these: what UDUNITS-2 and a double know, a file, and spellings that YAML makes a good number of.
UNSEEN = [
    ("force_limit", str, ["5 mm", "5 Nn", "5 e", "1e999 N", "5 N @ 1", "5 N and more"]),
    ("layers", with_poisson_ratio, ["0x0", ".nan"]),
    ("motion", with_times, ["3.0", "1e2", "+3", "0x3", "0o3"]),
    ("file", str, ["nowhere.csv", "../../../../../../../../../etc/hostname"]),
    ("version", str, ["1.0", "+1", "0x1"]),
    ("radii", with_bore, ["1 mm", "2 mm"]),
    ("radii", str, ["radius: 300 mm"]),
]

# Only the schema refuses these: a number in quotes, and a zero with a minus.
STRICTER = [
    ("layers", with_poisson_ratio, ["'0.4'"]),
    ("motion", with_times, ["'3'"]),
    ("version", str, ["'1'"]),
    ("tissue_map", with_damping, ["-0 1/s"]),
]

# Parts of a scene, each with the ways in which it may be there.
PARTS = {
    "tissue": ["tissue: {type: half_space, extent: [1 m, 1 m, 1 m], fixed: bottom, layers: "
               "[{name: gel, youngs_modulus: 1 kPa, poisson_ratio: 0.4}]}"],
    "needle": ["needle: {type: beam_column, length: 1 m, radius: 1 mm, youngs_modulus: 1 GPa, ends: clamped-free}"],
    "device": ["device: {type: recorded_hand, file: hand.csv}"],
    "coupling": ["coupling: {contact_spacing: 1 cm}"],
    "run": ["run: {rate: 1 kHz}", "run: {rate: 1 kHz, duration: 1 s}"],
    "effects": ["effects: []"],
    "record": ["record: [ledger]"],
}


def scenes(table):
    """Yields (what was changed, the scene)."""
    for key, standing, values in table:
        for value in values:
            yield f"{key}: {standing(value)}", SCENE.format(**GOOD | {key: standing(value)})


class Agreement(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.editor = bench.editor(*bench.TEST_PLUGINS)

    def expect(self, named_scenes, by_check, by_schema):
        """Each of them is sound to `stylet check` and to the schema or not, as said."""
        names, texts = zip(*named_scenes)
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "hand.csv").write_text("time [s],z [m]\n0,0\n")
            for name, text, sound in zip(names, texts, bench.sound(texts, folder, *bench.TEST_PLUGINS)):
                with self.subTest(name):
                    self.assertEqual(sound, by_check(text), "of stylet check")
                    self.assertEqual(self.editor.is_valid(bench.read(text)), by_schema(text), "of the schema")

    def test_on_what_is_sound(self):
        self.expect(scenes(SOUND), by_check=lambda _: True, by_schema=lambda _: True)

    def test_on_what_is_wrong(self):
        self.expect(scenes(WRONG), by_check=lambda _: False, by_schema=lambda _: False)

    def test_but_for_what_a_schema_cannot_see(self):
        self.expect(scenes(UNSEEN), by_check=lambda _: False, by_schema=lambda _: True)

    def test_but_for_what_an_editor_is_stricter_about(self):
        self.expect(scenes(STRICTER), by_check=lambda _: True, by_schema=lambda _: False)

    def test_on_which_sections_may_be_left_out(self):
        """Every choice of sections: 192 scenes, of which some of each kind are sound."""
        choices = itertools.product(*([""] + ways for ways in PARTS.values()))
        texts = ["stylet: 1\ntitle: Parts\n" + "\n".join(choice) for choice in choices]
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "hand.csv").write_text("time [s],z [m]\n0,0\n")
            found = bench.sound(texts, folder, *bench.TEST_PLUGINS)
        self.assertTrue(any(found) and not all(found))
        for text, sound in zip(texts, found):
            self.assertEqual(self.editor.is_valid(bench.read(text)), sound, text)
        print(f"{len(texts)} choices of sections, of which {sum(found)} are scenes")


if __name__ == "__main__":
    unittest.main()
