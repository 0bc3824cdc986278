"""Stubs and pages agree with the package, and the module knows the public headers alone."""
import ast
import doctest
import inspect
import os
import re

from conftest import ROOT

import gapcheck


def test_only_public_headers_are_included():
    names = set()
    for path in sorted((ROOT / "python/core").iterdir()):
        for kind, name in re.findall(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', path.read_text(), re.M):
            names.add(name)
            own = (ROOT / "python/core" / name).exists() if kind == '"' else False
            public = name.startswith("gapcheck/") and (ROOT / "lib/api" / name).exists()
            standard = re.fullmatch("[a-z_]+", name) or name in ("malloc.h", "sys/mman.h")  # of the C library
            assert own or public or name.startswith("pybind11/") or standard, f"{path}: {name}"
    assert "gapcheck/audit.hpp" in names and "pybind11/numpy.h" in names


def test_stubs_name_what_there_is():
    stub = ast.parse((ROOT / "python/gapcheck/_core.pyi").read_text())
    stated = {}
    for node in stub.body:
        if isinstance(node, ast.ClassDef):
            stated[node.name] = {each.target.id for each in node.body if isinstance(each, ast.AnnAssign)} | {
                each.name for each in node.body if isinstance(each, ast.FunctionDef)}
        elif isinstance(node, ast.FunctionDef):
            stated[node.name] = None
        elif isinstance(node, ast.AnnAssign):
            stated[node.target.id] = None
    public = {name: value for name, value in vars(gapcheck._core).items() if not name.startswith("__")}
    assert set(stated) == set(public)
    for name, value in public.items():
        if isinstance(value, type):
            methods = {each for each in vars(value) if not each.startswith("_")}
            assert stated[name] == methods | {"_fields"}, name
            assert value.__doc__ and set(value._fields) <= methods


def test_everything_public_says_what_it_is():
    for name in gapcheck.__all__:
        value = getattr(gapcheck, name)
        if name == "__version__":
            continue
        assert value.__doc__, name
        if isinstance(value, type):
            for attribute, member in vars(value).items():
                if not attribute.startswith("_") and (inspect.isfunction(member) or hasattr(member, "__get__")):
                    assert member.__doc__, f"{name}.{attribute}"


def test_audits_share_their_options():
    """audit_text() and audit_arrays() pass on what audit() lists."""
    from gapcheck.audits import audit_options
    listed = inspect.signature(gapcheck.audit).parameters
    shared = inspect.signature(audit_options).parameters
    assert {name: each.default for name, each in listed.items() if name != "deck"} == \
        {name: each.default for name, each in shared.items()}
    for name in shared:
        assert f"{name}:" in gapcheck.audit.__doc__ or f"{name}," in gapcheck.audit.__doc__, name


def test_the_page_shows_what_is_printed(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "data").symlink_to(ROOT / "data")
    page = ROOT / "docs/python.md"
    result = doctest.testfile(str(page), module_relative=False, optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    assert result.failed == 0 and result.attempted > 20
    for name in gapcheck.__all__:
        assert name in page.read_text(), name
    assert os.path.isdir("out")
