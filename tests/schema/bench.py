"""What the tests here share: `stylet` as a user runs it, and a scene as an editor reads it."""

import json
import os
import pathlib
import re
import subprocess

import jsonschema
import yaml

SOURCE = pathlib.Path(os.environ["SOURCE"])
TEST_PLUGINS = ["--plugin-dir", os.environ["TEST_PLUGINS"]]  # those of tests/loading, on which tests/bad_scenes are written


def stylet(*arguments, folder=None):
    """Runs the command without the user's own plugins."""
    environment = {name: value for name, value in os.environ.items() if name != "STYLET_PLUGIN_PATH"}
    return subprocess.run([os.environ["STYLET"], *map(str, arguments)], cwd=folder, env=environment, capture_output=True, text=True)


def schema(*arguments):
    return json.loads(stylet("schema", *arguments).stdout)


class EditorLoader(yaml.SafeLoader):
    """YAML 1.2's core schema, as language servers read it: `1e3` is a number and `yes` is text, unlike in PyYAML's 1.1."""

    yaml_implicit_resolvers = {}


def _whole(loader, node):
    text = node.value
    return int(text[2:], 8) if text.startswith("0o") else int(text, 16) if text.startswith("0x") else int(text)


for _tag, _pattern in (
    ("null", r"~|null|Null|NULL|"),
    ("bool", r"true|True|TRUE|false|False|FALSE"),
    ("int", r"[-+]?[0-9]+|0o[0-7]+|0x[0-9a-fA-F]+"),
    ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?|[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)"),
):
    EditorLoader.add_implicit_resolver(f"tag:yaml.org,2002:{_tag}", re.compile(f"^({_pattern})$"), None)
EditorLoader.add_constructor("tag:yaml.org,2002:int", _whole)


def read(text):
    """The scene as an editor has it; raises yaml.YAMLError where it has none."""
    return yaml.load(text, EditorLoader)


def complaints(scene, validator):
    """What an editor marks, one `path: message` each."""
    return [f"{'.'.join(map(str, error.absolute_path)) or 'scene'}: {error.message}" for error in validator.iter_errors(scene)]


def editor(*arguments):
    """A validator of the scenes that these plugins make."""
    return jsonschema.Draft7Validator(schema(*arguments))


def sound(texts, folder, *arguments):
    """For each text, whether `stylet check` has no complaint of the scene that it is. Files are looked for in `folder`."""
    names = [f"scene_{number}.yaml" for number in range(len(texts))]
    for name, text in zip(names, texts):
        (pathlib.Path(folder) / name).write_text(text)
    found = stylet("check", *names, *arguments, folder=folder).stdout.splitlines()
    return [f"{name}: sound" in found for name in names]
