"""Faults are exceptions that say the place, the fault and the cure, and carry the cells as data."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import coface


def test_classes_are_faults_of_python_too() -> None:
    assert issubclass(coface.FileError, OSError)
    assert issubclass(coface.ParseError, ValueError)
    assert issubclass(coface.NotInComplexError, LookupError)
    assert issubclass(coface.TooLargeError, OverflowError)
    for name in dir(coface):
        found = getattr(coface, name)
        if isinstance(found, type) and issubclass(found, Exception) and not issubclass(found, Warning):
            assert issubclass(found, coface.Error), name
            assert name in coface.__all__


def test_a_missing_file_is_named(tmp_path) -> None:
    with pytest.raises(coface.FileError) as caught:
        coface.read(tmp_path / "nothing.off")
    assert caught.value.file is not None and caught.value.file.endswith("nothing.off")
    assert caught.value.kind == "File"
    with pytest.raises(OSError):
        coface.read(tmp_path / "nothing.off")


def test_a_fault_in_a_file_has_a_line(tmp_path) -> None:
    path = tmp_path / "broken.off"
    path.write_text("OFF\n3 1 0\n0 0 0\n1 0 abc\n0 1 0\n3 0 1 2\n")
    with pytest.raises(coface.ParseError) as caught:
        coface.read(path)
    error = caught.value
    assert error.line == 4
    assert "abc" in error.message
    assert str(error).startswith(f"{path}:4: ")
    assert error.cells == []


def test_cells_are_data() -> None:
    with pytest.raises(coface.NotInComplexError) as caught:
        coface.Complex([[0, 1, 2]]).link([[0, 7]])
    assert caught.value.cells == [[0, 7]]
    # Three triangles at one edge are no surface.
    with pytest.raises(coface.NonManifoldError) as caught:
        coface.as_surface([[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    assert [0, 1] in [sorted(cell) for cell in caught.value.cells]


def test_errors_can_be_pickled() -> None:
    with pytest.raises(coface.NotInComplexError) as caught:
        coface.Complex([[0, 1, 2]]).link([[0, 7]])
    again = pickle.loads(pickle.dumps(caught.value))
    assert type(again) is coface.NotInComplexError
    assert (str(again), again.cells, again.cure) == (str(caught.value), caught.value.cells, caught.value.cure)


SQUARE = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]


@pytest.mark.parametrize(
    ("vertices", "faces"),
    [
        (SQUARE, [[0, 1, 4]]),
        (SQUARE, [[0, 1, -1]]),
        (SQUARE, [[0, 1, 1]]),
        (SQUARE, [[0.0, 1.0, 2.5]]),
        (SQUARE, np.array([[0.0, 1.0, 2.5]])),
        (SQUARE, np.array([[0.0, 1.0, np.nan]])),
        (SQUARE, np.array([[0.0, 1.0, 1e300]])),
        (SQUARE, [["a", "b", "c"]]),
        (SQUARE, "faces"),
        (SQUARE, 7),
        (SQUARE, np.zeros((2, 2, 3), int)),
        (SQUARE, [[0, 1]]),
        (SQUARE, np.array([[0, 1, 2**40]])),
        ([[0.0, np.nan, 0.0], *SQUARE[1:]], [[0, 1, 2]]),
        ([[0.0, np.inf, 0.0], *SQUARE[1:]], [[0, 1, 2]]),
        ([[0.0, 0.0], [1.0]], [[0, 1, 0]]),
        (np.zeros(4), [[0, 1, 2]]),
        ([["x", "y", "z"]] * 4, [[0, 1, 2]]),
        (np.zeros((4, 3), complex), [[0, 1, 2]]),
    ],
)
def test_wrong_arrays_are_refused(vertices, faces) -> None:
    with pytest.raises(coface.InvalidInputError) as caught:
        coface.Model.from_arrays(vertices, faces)
    assert caught.value.message and str(caught.value)


@pytest.mark.parametrize("x", [None, 3, 2.5, object(), (1, 2, "x"), {"nothing": 1}, b"\x00\x01", lambda: 0])
def test_what_is_no_space_is_refused(x) -> None:
    with pytest.raises(coface.Error):
        coface.as_model(x)


def test_wrong_words_are_refused() -> None:
    circle = [[0, 1], [1, 2], [0, 2]]
    with pytest.raises(coface.Error):
        coface.homology(circle, "f4")
    with pytest.raises(coface.Error):
        coface.homology(circle, relative="rim")
    with pytest.raises(coface.Error):
        coface.generate("no such family")
    with pytest.raises(coface.Error):
        coface.homology(circle, progress=3)
    with pytest.raises(coface.Error):
        coface.boolean("both", circle)
    with pytest.raises(coface.Error):
        coface.incidence(circle, "XY")


def test_boundaries_that_are_none_are_refused() -> None:
    from scipy.sparse import csc_array

    edges = csc_array(np.array([[-1], [1]]))
    with pytest.raises(coface.BoundaryOfBoundaryError):
        coface.ChainComplex.from_boundaries([edges, csc_array(np.array([[1]]))])
    with pytest.raises(coface.Error):
        coface.ChainComplex.from_boundaries([csc_array(np.array([[0.5]]))])
    with pytest.raises(coface.Error):
        coface.ChainComplex.from_boundaries([edges, csc_array(np.zeros((3, 1), int))])


REPEATED = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2 2\n"


def test_assumptions_are_warnings_or_with_strict_faults() -> None:
    with pytest.warns(coface.AssumptionWarning, match="repeat"):
        model = coface.Model.from_bytes(REPEATED)
    assert len(model.warnings) == 1 and model.f_vector == (3, 3, 1)
    with pytest.raises(coface.InvalidInputError) as caught:
        coface.Model.from_bytes(REPEATED, strict=True)
    assert caught.value.cure is not None and "leave out strict, " in caught.value.cure and "--" not in str(caught.value)


def test_a_cut_file_is_read_up_to_its_fault(tmp_path) -> None:
    path = tmp_path / "cut.off"
    path.write_text("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    with pytest.raises(coface.ParseError, match="partial"):
        coface.read(path)
    with pytest.warns(coface.AssumptionWarning):
        assert coface.read(path, partial=True).f_vector == (3, 3, 1)


def test_one_of_several_models_is_chosen(tmp_path) -> None:
    path = tmp_path / "models.jsonl"
    path.write_text('{"name": "disk", "facets": [[0, 1, 2]]}\n[[0, 1]]\n')
    assert coface.entries(path) == ["disk", "2"]
    with pytest.warns(coface.AssumptionWarning, match="2 models"):
        assert coface.read(path).f_vector == (3, 3, 1)
    assert coface.read(f"{path}#2").f_vector == (2, 1)
    rows = coface.batch(path)
    assert [row["path"] for row in rows] == [f"{path}#disk", f"{path}#2"]
    assert [row["error"] for row in coface.batch(path, strict=True)] == [None, None]


def test_raw_messages_are_in_words() -> None:
    torus = coface.generate("torus", columns=5, rows=4)
    with pytest.raises(coface.InvalidTypeError, match=r"'a' is no degree; give an integer: homology\[1\]"):
        getattr(coface.homology(torus), "__getitem__")("a")
    with pytest.raises(coface.InvalidInputError, match="is no step of a zigzag; give"):
        coface.zigzag([("i",)])
    with pytest.raises(coface.InvalidInputError, match="is no step of a zigzag"):
        coface.zigzag([3])
    with pytest.raises(coface.InvalidInputError, match=r"give a dictionary \{vertex: image\}"):
        coface.induced_map(torus, torus, [0] * 20)
    with pytest.raises(coface.InvalidInputError, match="genus is -1; give an integer from 0 on"):
        coface.generate("genus", genus=-1)
    with pytest.warns(coface.AssumptionWarning, match="9 landmarks were asked for, and there are 5"):
        coface.witness(np.arange(10.0).reshape(5, 2), 9)
