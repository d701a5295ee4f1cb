"""Docstrings: everything public has one, and every example in them runs."""

from __future__ import annotations

import doctest
import importlib
import inspect
import pkgutil
import re
from pathlib import Path

import pytest

import coface

OPTIONS = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS


def documented():
    """Names and docstrings of what is public, members of classes too, and of the modules behind."""
    yield "coface", coface.__doc__
    for name in coface.__all__:
        thing = getattr(coface, name)
        if not (inspect.isclass(thing) or callable(thing)):
            continue
        yield name, thing.__doc__
        if inspect.isclass(thing):
            for member, value in vars(thing).items():
                if not member.startswith("_") and (callable(value) or inspect.isdatadescriptor(value) or hasattr(value, "__func__")):
                    yield f"{name}.{member}", getattr(value, "__func__", value).__doc__
    for name, value in vars(coface._coface).items():
        if not name.startswith("_") and inspect.isbuiltin(value):
            yield f"_coface.{name}", value.__doc__


def private():
    for package in ["coface", "coface.interop"]:
        for module in pkgutil.iter_modules(importlib.import_module(package).__path__, package + "."):
            if module.name == "coface._coface":
                continue
            try:
                found = importlib.import_module(module.name)
            except ImportError as error:
                # Too large for everybody to have them.
                assert (module.name, error.name) in {("coface.ray", "ray"), ("coface.interop.sklearn", "sklearn")}
                continue
            for name, value in vars(found).items():
                if getattr(value, "__module__", None) == module.name and getattr(value, "__doc__", None):
                    if name not in coface.__all__:
                        yield f"{module.name}.{name}", value.__doc__, vars(found)


PUBLIC = dict(documented())
EXAMPLES = [(name, text, {}) for name, text in PUBLIC.items() if text and ">>>" in text]
EXAMPLES += [(name, text, names) for name, text, names in private() if ">>>" in text]


@pytest.mark.parametrize(("name", "text", "names"), EXAMPLES, ids=[name for name, _, _ in EXAMPLES])
def test_examples_run(name, text, names, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # Some write files.
    monkeypatch.chdir(tmp_path)
    parsed = doctest.DocTestParser().get_doctest(text, {**names, "coface": coface}, name, None, 0)
    said: list[str] = []
    runner = doctest.DocTestRunner(optionflags=OPTIONS, verbose=False)
    try:
        runner.run(parsed, out=said.append, clear_globs=True)
    except doctest.UnexpectedException as error:
        raise error.exc_info[1] from None
    assert runner.failures == 0, "".join(said)


def test_everything_public_is_documented() -> None:
    missing = [name for name, text in PUBLIC.items() if not (text or "").strip()]
    assert missing == []


def test_signatures_are_told() -> None:
    missing = []
    for name in coface.__all__:
        thing = getattr(coface, name)
        members = [(name, thing)] if inspect.isroutine(thing) else []
        if inspect.isclass(thing) and not issubclass(thing, Exception):
            members = [(f"{name}.{m}", v) for m, v in vars(thing).items() if not m.startswith("_") and inspect.isroutine(v)]
        for where, value in members:
            try:
                inspect.signature(value.__func__ if isinstance(value, (staticmethod, classmethod)) else value)
            except (TypeError, ValueError):
                missing.append(where)
    assert missing == []


DOCS = Path(__file__).resolve().parents[3] / "docs"
PAGE = DOCS / "python.md"
SNIPPETS = [
    (f"{page.name}-{i}", snippet)
    for page in sorted((DOCS / "book" / "src").glob("*.md"))
    for i, snippet in enumerate(re.findall(r"^```python(?:,data)?\n(.*?)^```$", page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE))
]


@pytest.mark.parametrize("snippet", [text for _, text in SNIPPETS], ids=[name for name, _ in SNIPPETS])
def test_the_book_has_python_that_runs(snippet: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "data").symlink_to(DOCS.parent / "data", target_is_directory=True)
    exec(compile(snippet, "<book>", "exec"), {})


def test_the_book_has_python() -> None:
    assert len(SNIPPETS) >= 4


def test_the_page_of_names_has_names_that_exist() -> None:
    text = PAGE.read_text(encoding="utf-8")
    right = [row.split("|")[2] for row in text.splitlines() if row.startswith("| ") and "---" not in row]
    calls = re.findall(r"`([^`]*)`", " ".join(right) + text.partition("## In all")[0])
    seen = 0
    for call in calls:
        for path in re.findall(r"\bcoface\.([A-Za-z][\w.]*)", call):
            thing: object = coface
            for name in path.split("."):
                if name == "interop":
                    importlib.import_module("coface.interop.trimesh")
                assert hasattr(thing, name), call
                thing = getattr(thing, name)
            seen += 1
    assert seen > 50
    for name in re.findall(r"`?\bmodel\.([a-z_]+)", " ".join(right)):
        assert hasattr(coface.Model, name), name
    for name in re.findall(r"report\(\)\.([a-z_]+)", " ".join(right)):
        assert hasattr(coface.Report, name), name


def test_the_example_of_the_page_of_names_runs(tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    block = PAGE.read_text(encoding="utf-8").partition("```python\n")[2].partition("```")[0]
    names: dict[str, object] = {}
    exec(block, names)
    assert repr(names["found"]) == "Homology(Z, Z^2, Z)" and (tmp_path / "torus.html").is_file()
    assert getattr(names["loop"], "order") is None and len(getattr(names["loop"], "loop")) > 3


STUDIO = DOCS.parent / "viewer" / "studio" / "questions.ts"
QUESTIONS = re.findall(r"python: [\"`](.*)[\"`],$", STUDIO.read_text(encoding="utf-8"), re.MULTILINE)
OPERATIONS = ["union", "intersection", "difference", "xor"]


@pytest.mark.parametrize("question", QUESTIONS)
def test_the_studio_copies_python_that_runs(question: str, tmp_path: Path) -> None:
    curve = tmp_path / "blob.json"
    curve.write_text('{"order":4,"curves":[{"points":[[4,2],[2,3],[1,1],[3,-0.4]]}]}', encoding="utf-8")
    spaces = {"coface": coface, "x": coface.generate("torus"), "y": coface.generate("sphere")}
    for operation in OPERATIONS if "${operation}" in question else [""]:
        text = question.replace("${operation}", operation).replace("\\", "").replace("path", repr(str(curve)))
        exec(compile(text, "<studio>", "exec"), dict(spaces))


def test_the_studio_has_questions() -> None:
    assert len(QUESTIONS) >= 10
