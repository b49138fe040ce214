#!/usr/bin/env python3
"""What a plugin's developer does with an installed Stylet: the install is moved elsewhere, the template is copied out of it, built, tested and
run; and what is built wrongly is refused with its sentence."""

import argparse
import csv
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
given = None    # the command line
shop = None    # a Workshop


def call(*command, codes=(0,), folder=None):
    """Runs a command and returns what it printed; fails unless it ends with one of these codes."""
    environment = {name: value for name, value in os.environ.items() if name != "STYLET_PLUGIN_PATH"}
    done = subprocess.run([str(word) for word in command], cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True)
    if done.returncode not in codes:
        raise AssertionError(f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


def configure(source, build, prefix):
    # Optimised just enough: these builds are the longest part of the test.
    return call("cmake", "-S", source, "-B", build, "-G", given.generator, f"-DCMAKE_CXX_COMPILER={given.compiler}",
                f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1")


def columns(recording):
    """Of a recording, by name without unit."""
    with open(recording) as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {name.split(" [")[0]: [row[name] if name == "event" else float(row[name]) for row in rows] for name in rows[0]}


class Workshop:
    """An install that was moved, and the template built beside it."""

    def __init__(self, folder):
        call("cmake", "--install", given.build, "--prefix", folder / "first")
        self.folder = folder
        self.prefix = folder / "somewhere else"
        (folder / "first").rename(self.prefix)
        self.stylet = self.prefix / "bin/stylet"
        self.template = folder / "template"
        shutil.copytree(self.prefix / "share/stylet/template", self.template)
        configure(self.template, self.template / "build", self.prefix)
        call("cmake", "--build", self.template / "build", "--parallel", "2")
        self.plugins = self.template / "build/plugins"
        self.hold = self.template / "scenes/hold.yaml"

    def run(self, scene, *options):
        """Its recording and the ledger of its summary."""
        summary = json.loads(call(self.stylet, "run", scene, "--plugin-dir", self.plugins, "--out", self.folder / "out", "--json", "-", *options))
        return columns(self.folder / "out" / (pathlib.Path(scene).stem + ".csv")), summary["ledger"]


def setUpModule():
    global shop
    scratch = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(scratch.cleanup)
    shop = Workshop(pathlib.Path(scratch.name))


class Installed(unittest.TestCase):
    def test_the_moved_install_finds_its_own_plugins_and_scenes(self):
        scene = shop.prefix / "share/stylet/scenes/paper/fig10a_l150.yaml"
        self.assertEqual(call(shop.stylet, "check", scene), f"{scene}: sound\n")
        self.assertIn("fig10a_l150.yaml", call(shop.stylet, "scenes"))

    def test_the_package_names_no_folder_of_the_build(self):
        for file in (shop.prefix / "lib/cmake").rglob("*.cmake"):
            for folder in (given.build, str(HERE.parent.parent), str(shop.folder / "first")):
                self.assertNotIn(folder, file.read_text(), file.name)

    def test_the_template_keeps_the_contract(self):
        said = call("ctest", "--output-on-failure", folder=shop.template / "build")
        self.assertIn("TissueContract.EnergyIsTheWorkOfTheForces/Gel", said)
        print(re.search(r".*tests passed.*", said).group())

    def test_the_template_is_listed_and_its_scene_is_sound(self):
        said = call(shop.stylet, "plugins", "viscoelastic_half_space", "--plugin-dir", shop.plugins)
        for text in ("viscoelastic_half_space (tissue)", "long_term_modulus   number (Pa)", "retardation_time    number (s)"):
            self.assertIn(text, said)
        self.assertEqual(call(shop.stylet, "check", shop.hold, "--plugin-dir", shop.plugins), f"{shop.hold}: sound\n")

    def test_a_plugin_that_is_installed_is_found_without_being_looked_for(self):
        prefix = shop.folder / "with the plugin"
        shutil.copytree(shop.prefix, prefix)
        call("cmake", "--install", shop.template / "build", "--prefix", prefix)
        call(prefix / "bin/stylet", "check", shop.hold)

    def test_a_held_dent_relaxes_as_the_closed_form_says(self):
        prompt, long_term, retardation = 25e3, 10e3, 0.5    # [Pa], [Pa], [s] of the scene
        speed, push, nu, radius = 10e-3, 0.5, 0.49, 0.5e-3    # [m/s], [s], 1, [m]
        relaxation = retardation * long_term / prompt    # [s]
        stiffness = 2.0 * radius / (1.0 - nu * nu)    # [m] force over modulus and depth

        def force(t):    # of a standard linear solid that is pushed in at constant speed and then held
            begun, held = math.exp(-t / relaxation), math.exp(-max(0.0, t - push) / relaxation)
            return stiffness * speed * (long_term * min(t, push) + (prompt - long_term) * relaxation * (held - begun))

        recording, ledger = shop.run(shop.hold)
        peak = force(push)
        worst = max(abs(found - force(t)) for t, found in zip(recording["time"], recording["hand_force"])) / peak
        of_the_step = (1e-3 / relaxation) ** 2 / 4.0    # the midpoint rule's error is a twelfth of the square, on either side of the corner
        print(f"force falls from {max(recording['hand_force']):.5f} N to {recording['hand_force'][-1]:.5f} N; {worst:.1e} of the peak off")
        self.assertLess(worst, of_the_step)
        self.assert_books_close(ledger)

    def test_a_needle_in_its_track_relaxes_too(self):
        recording, ledger = shop.run(HERE / "scenes/held.yaml")
        self.assertIn("punctured", recording["event"])
        at = lambda t: recording["hand_force"][round(t * 1000) - 1]
        ratio = (at(2.4) - at(2.6)) / (at(2.2) - at(2.4))    # all contacts stick: every 0.2 s the rest falls to 1/e
        print(f"the force still to be lost falls to {ratio:.6f} of itself in 0.2 s")
        of_the_step = (1e-3 / 0.2) ** 2 / 4.0
        self.assertAlmostEqual(ratio, math.exp(-1.0), delta=of_the_step)
        self.assertGreater(ledger["damping"], 0.0)
        self.assert_books_close(ledger)

    def test_the_hand_gains_nothing_by_pumping(self):
        length, begin, period, cycles = 0.1, 0.6, 0.4, 5
        shutil.copy(HERE / "scenes/pumped.yaml", shop.folder)
        with open(shop.folder / "pumping.csv", "w") as file:
            file.write("time [s],x [m],y [m],z [m],qw,qx,qy,qz\n")
            for tick in range(round((begin + cycles * period) * 1000) + 1):
                t = tick / 1000.0
                phase = max(0.0, t - begin) % period / (0.25 * period)
                ramp = lambda start: min(max(phase - start, 0.0), 1.0)
                depth = -1e-3 + 0.1 * t if t < 0.4 else max(39e-3 - 0.1 * (t - 0.4), 29e-3)    # first 39 mm in, then back to 29 mm
                file.write(f"{t},{2e-3 * (ramp(0) - ramp(2))},0,{length - depth - 10e-3 * (ramp(1) - ramp(3))},1,0,0,0\n")
        recording, ledger = shop.run(shop.folder / "pumped.yaml")
        after = lambda name: recording[name][-1] - recording[name][round((begin + period) * 1000) - 1]    # the first cycle settles
        print(f"{cycles - 1} cycles: work {1e3 * after('hand_work'):.3f} mJ, of it lost to creep {1e3 * after('damping'):.3f} mJ, "
              f"released {1e3 * after('released'):.3f} mJ")
        self.assertGreater(after("hand_work"), 0.0)
        # What moving contact points frees is the hand's loss. A cycle's worth of made energy, where the tip is not paid for, is 3 mJ.
        self.assertGreater(after("released"), -0.01 * after("hand_work"))
        self.assert_books_close(ledger)

    def assert_books_close(self, ledger):
        print(f"residual {ledger['relative']:.1e} of the peak work")
        self.assertLess(ledger["relative"], 1e-10)    # every body here is linear: the books are exact but for some thousand roundings


class Refused(unittest.TestCase):
    """Built by a user, wrongly."""

    @classmethod
    def setUpClass(cls):
        cls.source = HERE / "refused"
        cls.build = shop.folder / "refused"
        cls.plugins = cls.build / "plugins"
        configure(cls.source, cls.build, shop.prefix)
        call("cmake", "--build", cls.build, "--parallel", "2")

    def refusal(self, name, plugins=None):
        return call(shop.stylet, "plugins", name, "--plugin-dir", plugins or self.plugins, codes=(2,)).strip()

    def test_a_plugin_of_another_sdk(self):
        prefix, build = shop.folder / "later", shop.folder / "for later"
        shutil.copytree(shop.prefix, prefix)
        header = prefix / "include/stylet/plugin.h"
        text = header.read_text()
        version = int(re.search(r"sdk_version = (\d+);", text).group(1))
        header.write_text(text.replace(f"sdk_version = {version};", f"sdk_version = {version + 1};"))
        configure(self.source, build, prefix)
        call("cmake", "--build", build, "--target", "throwing")
        self.assertEqual(self.refusal("throwing", build / "plugins"),
                         f"plugin 'throwing' was built for SDK version {version + 1}, this program has {version}: rebuild it")

    def test_a_plugin_for_another_alignment(self):
        self.assertEqual(self.refusal("for_avx"), "plugin 'for_avx' was built for an Eigen alignment of 32 bytes, this program has 16 "
                         "(compiler flags such as -mavx change it): rebuild it")

    def test_a_plugin_that_misses_a_symbol_does_not_link(self):
        said = call("cmake", "--build", self.build, "--target", "missing_symbol", codes=(1, 2))
        self.assertIn("undefined reference to `defined_nowhere(stylet::Contact const&)'", said)

    def test_a_text_file(self):
        (self.plugins / "poem.so").write_text("No library, only words.\n")
        self.assertEqual(self.refusal("poem"), "cannot open plugin 'poem': file too short")

    def test_a_constructor_that_throws(self):
        said = call(shop.stylet, "check", shop.hold, "--plugin-dir", shop.plugins, "--plugin-dir", self.plugins, "--set",
                    "effects=[{type: throwing}]", codes=(2,))
        self.assertIn("effects[0]: the plugin 'throwing' failed: a bug in its constructor", said)


if __name__ == "__main__":
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--build", required=True, help="the build to install")
    options.add_argument("--compiler", required=True)
    options.add_argument("--generator", required=True)
    given = options.parse_args()
    unittest.main(argv=sys.argv[:1], verbosity=2)
