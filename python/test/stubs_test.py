# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stubs name what the extension has, and all of it has a docstring."""
import ast
import pathlib

import pytest

import collision_monitor_core as cm
from collision_monitor_core import _core

STUB = ast.parse((pathlib.Path(cm.__file__).parent / "_core.pyi").read_text())
CLASSES = {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}
PLAIN = {"sphere", "cylinder"}  # their arguments say all


def public(names):
    return {name for name in names if not name.startswith("_")}


def test_stubs_nameAllOfTheModule():
    functions = {node.name for node in STUB.body if isinstance(node, ast.FunctionDef)}
    assert functions | set(CLASSES) == public(vars(_core))
    assert public(CLASSES) - {"Robot"} < set(cm.__all__) and set(cm.__all__) <= set(dir(cm))


@pytest.mark.parametrize("name", sorted(CLASSES))
def test_stubs_nameAllOfAClass(name):
    stub = {node.name for node in CLASSES[name].body if isinstance(node, ast.FunctionDef)}
    there = getattr(_core, name)
    assert public(stub) == public(vars(there))
    for member in public(vars(there)) - PLAIN:
        lines = (getattr(there, member).__doc__ or "").strip().splitlines()
        is_method = not isinstance(vars(there)[member], property)
        assert len(lines) > (1 if is_method else 0), member
        assert "::" not in lines[0], member  # a name of C++
    assert there.__doc__


def test_defaults_ofStubsAndLibraryAgree():
    doc = cm.Robot.check_path.__doc__.splitlines()[0]
    assert "margin: float = 0.05" in doc and "progress" in doc
