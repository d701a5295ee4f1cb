"""What an answer is passed on as: the same as the program would write, and the same as the object that it was made of."""

import io
import json
import warnings

import coface
import numpy as np
import pytest

SHELL = [[0, 0], [4, 0], [4, 4], [0, 4]]
HOLE = [[1, 1], [3, 1], [3, 3], [1, 3]]
RINGS = {
    "hole": (SHELL, HOLE),
    "hole that turns back": (SHELL, HOLE[::-1]),
    "first point again": ([*SHELL, SHELL[0]], HOLE),
    "hole outside": (SHELL, [[6, 0], [7, 0], [7, 1]]),
    "hole half outside": (SHELL, [[3, 1], [6, 1], [6, 2], [3, 2]]),
    "holes that overlap": (SHELL, [[1, 1], [3, 1], [3, 2], [1, 2]], [[2, 1.5], [3.5, 1.5], [3.5, 3], [2, 3]]),
    "hole in a hole": (SHELL, HOLE, [[1.5, 1.5], [2, 1.5], [2, 2], [1.5, 2]]),
    "twice around": ([*SHELL, *SHELL],),
    "pentagram": ([[0, 3], [1.8, -2.4], [-2.9, 0.9], [2.9, 0.9], [-1.8, -2.4]],),
}


@pytest.mark.parametrize("name", RINGS)
def test_a_polygon_is_the_one_of_shapely(name):
    shapely = pytest.importorskip("shapely")
    shell, *holes = RINGS[name]
    ours, theirs = coface.polygon(shell, *holes), coface.as_model(shapely.Polygon(shell, holes))
    assert [(kind, on, values.tolist()) for kind, on, values in ours.data] == [(kind, on, values.tolist()) for kind, on, values in theirs.data]
    assert coface.boolean("union", ours).measure == coface.boolean("union", theirs).measure
    assert coface.arrange(ours).measures == coface.arrange(theirs).measures
    assert coface.to_shapely(ours).wkt == coface.to_shapely(theirs).wkt
    assert ours.report().problems == theirs.report().problems
    assert ours.to_bytes("wkt") == theirs.to_bytes("wkt")
    for distance in (0.1, -0.1):
        assert coface.boolean("union", coface.maps.buffer(ours, distance=distance)).measure == coface.boolean("union", coface.maps.buffer(theirs, distance=distance)).measure


def test_rings_of_a_polygon_are_points_of_the_plane():
    assert coface.boolean("union", coface.polygon(SHELL, HOLE)).measure == 12
    with pytest.raises(coface.InvalidInputError, match="shape"):
        coface.polygon([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    with pytest.raises(coface.InvalidInputError, match="not finite"):
        coface.polygon([[0, 0], [1, 0], [1, np.nan]])
    with pytest.raises(coface.InvalidInputError, match="2 points"):
        coface.polygon([[0, 0], [1, 0]])


def written(answer, folder, name="answer.json"):
    path = folder / name
    answer.write(path)
    return coface.read(path)


def solids():
    box = coface.generate("box", boundary=True)
    sphere = coface.generate("sphere", radius=0.6, subdivisions=2)
    tetrahedra = coface.generate("box")
    yield coface.arrange(tetrahedra)
    yield coface.arrange(box, sphere)
    yield coface.arrange(box, coface.Model(np.asarray(box.vertices) + [3, 0, 0], box.faces), exact=True)
    yield coface.arrange(tetrahedra, method="congruence", tolerance=1e-6)
    yield coface.congruence(tetrahedra, coface.Model.from_arrays(np.asarray(tetrahedra.vertices) + [1, 0, 0], cells=tetrahedra.cells), tolerance=1e-6)


@pytest.mark.parametrize("number", range(5))
def test_cells_of_space_are_passed_on(number, tmp_path):
    answer = list(solids())[number]
    complex, read = answer.chain_complex(), written(answer, tmp_path)
    found = coface.homology(answer)
    assert found == complex.homology() == coface.homology(read)
    assert coface.as_chain_complex(answer).f_vector == complex.f_vector == read.f_vector == answer.cells.f_vector
    assert coface.cohomology(answer) == complex.cohomology()
    assert coface.incidence(answer, "CF", "incident").shape == complex.f_vector[:1:-1]
    assert coface.laplacian(answer, 3).shape == (complex.f_vector[3], complex.f_vector[3])
    assert coface.long_exact_sequence(answer, "boundary")
    assert coface.homology(answer, relative="boundary").betti_numbers == coface.homology(read, relative="boundary").betti_numbers
    # What is drawn are the faces.
    assert len(coface.render(answer)) > 900


def test_an_arrangement_of_tetrahedra_keeps_them(tmp_path):
    answer = coface.arrange(coface.generate("box"))
    assert answer.f_vector == [8, 19, 18, 6]
    assert str(coface.homology(answer)[0]) == "Z" and coface.homology(answer).betti_numbers == (1, 0, 0, 0)
    assert coface.as_model(answer).report().f_vector == (8, 19, 18, 6)
    assert coface.boolean("union", answer).measure == 1
    assert coface.arrange(answer).f_vector == answer.f_vector
    assert len(written(answer, tmp_path, "faces.off").faces) == 18
    with pytest.raises(coface.UnsupportedFormatError, match="holds no polygons in space"):
        answer.write(tmp_path / "faces.geojson")


def test_a_region_is_no_boundary(tmp_path):
    region = coface.boolean("difference", coface.polygon(SHELL), coface.polygon(HOLE))
    assert coface.homology(region).betti_numbers[:2] == (1, 1)
    assert coface.homology(region) == coface.homology(written(region, tmp_path))
    assert [str(group) for group in coface.pi1(region)] == ["Z"]
    assert coface.homology(coface.boolean("difference", coface.polygon(SHELL), coface.polygon(SHELL))).betti_numbers in ((), (0,), (0, 0, 0))
    arranged = coface.arrange(coface.polygon(SHELL), coface.polygon(HOLE))
    assert coface.homology(arranged) == arranged.chain_complex().homology() == coface.homology(written(arranged, tmp_path))


def test_loops_of_a_region_are_shown(tmp_path):
    region = coface.boolean("difference", coface.polygon(SHELL), coface.polygon(HOLE))
    found = coface.homology(region, generators=True)
    generator = found[1].generators[0]
    loop = generator.loop
    assert loop[0] == loop[-1] and len(loop) > 4
    # Its edges go around the hole: by the positions of the vertices the winding number is 1 or -1.
    points = np.asarray(region.cells.vertices)[loop] - 2
    angles = np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
    assert abs(round((angles[-1] - angles[0]) / (2 * np.pi))) == 1
    complex = coface.as_chain_complex(region)
    assert complex.chain(generator.chain.terms()) == generator.chain
    for shown in (found, [region, found], [region, coface.pi1(region)]):
        assert coface.view(shown, tmp_path / "region.html").stat().st_size > 10_000
        assert coface.render(shown).startswith(b"<svg")
    assert coface.cut(region).model.report().name == "disk"
    assert len(coface.extended_persistence(region, "x")["extended-"]) == 1


def test_a_set_of_the_plane_is_no_boundary():
    annulus = coface.YinSet([coface.Curve.circle([0, 0], 2)]) - coface.YinSet([coface.Curve.circle([0, 0], 1)])
    assert list(coface.homology(annulus).betti_numbers[:2]) == annulus.betti_closed == [1, 1]
    with pytest.raises(coface.InvalidInputError, match="not bounded"):
        coface.homology(~annulus)
    corners = coface.YinSet.from_rings([[[0, 0], [1, 0], [1, 1], [0, 1]], [[1, 1], [2, 1], [2, 2], [1, 2]]], rule="evenodd")
    with pytest.warns(coface.AssumptionWarning, match="closed set"):
        assert coface.homology(corners).betti_numbers[0] == 1


def test_rings_may_have_their_first_point_again():
    ring = [[0, 0], [2, 0], [2, 2], [0, 2]]
    assert coface.YinSet.from_rings([[*ring, ring[0]]]) == coface.YinSet.from_rings([ring])


def test_an_open_star_is_refused():
    star = coface.Complex([[0, 1, 2], [1, 2, 3], [2, 3, 4]]).star([2])
    with pytest.raises(coface.NotAComplexError, match="is no complex.*closure"):
        coface.homology(star)
    assert coface.homology(star.closure()).betti_numbers == (1, 0, 0)
    # The cure: a vertex within a disk, and one on its rim.
    assert coface.homology(star.closure(), relative=star.closure() - star).betti_numbers == (0, 0, 0)
    inner = coface.Complex([[0, 1, 2], [0, 2, 3], [0, 3, 1]]).star([0])
    assert coface.homology(inner.closure(), relative=inner.closure() - inner).betti_numbers == (0, 0, 1)
    assert len(coface.render(star)) > 500


def test_a_square_matrix_may_be_a_graph():
    sparse = pytest.importorskip("scipy.sparse")
    networkx = pytest.importorskip("networkx")
    adjacency = sparse.csr_array([[0, 1, 1], [1, 0, 1], [1, 1, 0]])
    for matrix in (adjacency, sparse.triu(adjacency).tocsr(), sparse.csr_array(np.ones((3, 3), int))):
        with pytest.raises(coface.InvalidInputError, match="networkx.from_scipy_sparse_array"):
            coface.homology(matrix)
    assert coface.homology(networkx.from_scipy_sparse_array(adjacency)).betti_numbers == (1, 1)
    assert str(coface.homology(coface.ChainComplex.from_boundaries([adjacency]))[0]) == "Z/2"
    # Boundaries have signs, or entries on the diagonal alone.
    assert coface.homology(sparse.csr_array([[-1, 0, 1], [1, -1, 0], [0, 1, -1]])).betti_numbers == (1, 1)
    assert str(coface.homology(sparse.csr_array([[2]]))[0]) == "Z/2"


def test_rows_of_four_may_be_tetrahedra():
    spatial = pytest.importorskip("scipy.spatial")
    points = np.random.default_rng(0).random((40, 3))
    rows = spatial.Delaunay(points).simplices
    for given in (rows, rows.tolist()):
        with pytest.raises(coface.InvalidInputError, match="tetra.*quad"):
            coface.Model(points, given)
    assert coface.homology(coface.Model.from_arrays(points, cells={"tetra": rows})).betti_numbers == (1, 0, 0, 0)
    assert coface.homology(spatial.Delaunay(points)).betti_numbers == (1, 0, 0, 0)
    hull = coface.as_model(spatial.ConvexHull(points)).report()
    assert hull.name == "sphere" and hull.coherently_oriented
    assert hull.signed_volume == pytest.approx(spatial.ConvexHull(points).volume)
    flat = coface.as_model(spatial.Delaunay(points[:, :2]))
    assert flat.report().name == "disk"
    # Quadrangles that are bent, those of a twisted band, are quadrangles.
    t = np.linspace(0, 2, 20)
    band = np.concatenate([np.column_stack([np.cos(t), np.sin(t), t]), np.column_stack([-np.cos(t), -np.sin(t), t])])
    quads = [[i, i + 1, i + 21, i + 20] for i in range(19)]
    assert coface.Model(band, quads).report().name == "disk"
    assert len(coface.Model([[0, 0, 0], [1, 0, 0], [1, 1, 0.1], [0, 1, 0]], [[0, 1, 2, 3]]).faces) == 1
    with pytest.warns(coface.AssumptionWarning, match="quadrangles"):
        assert len(coface.Model([[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]], [[0, 1, 2, 3]]).faces) == 1


def test_damaged_meshes_are_read_as_their_files(tmp_path):
    trimesh = pytest.importorskip("trimesh")
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])
    mesh = trimesh.Trimesh(corners, [[0, 1, 2], [0, 2, 3], [1, 2, 2]], process=False)
    mesh.export(tmp_path / "mesh.off")
    with pytest.warns(coface.AssumptionWarning):
        ours = coface.as_model(mesh)
    with pytest.warns(coface.AssumptionWarning):
        assert ours.report().f_vector == coface.read(tmp_path / "mesh.off").report().f_vector
    unplaced = trimesh.Trimesh(corners * [1, 1, np.nan], [[0, 1, 2]], process=False)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert coface.as_model(unplaced).report().f_vector == (4, 3, 1)


def test_whole_numbers_may_be_floats():
    corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]
    for faces in (np.array([[0.0, 1.0, 2.0]]), [[0.0, 1.0, 2.0]]):
        assert coface.Model(corners, faces).faces.tolist() == [[0, 1, 2]]
        with pytest.raises(coface.InvalidInputError, match="0.5"):
            coface.Model(corners, np.asarray(faces) / 2)
    assert coface.ChainComplex.from_boundaries([np.array([[2.0, 0.0]])]).homology() == coface.ChainComplex.from_boundaries([[[2, 0]]]).homology()
    with pytest.raises(coface.InvalidInputError, match="0.5 in row 0, column 1"):
        coface.ChainComplex.from_boundaries([np.array([[1.0, 0.5]])])
    with pytest.raises(coface.InvalidInputError, match="beyond 32 bits"):
        coface.invariant_factors([[10**20, 0], [0, 3]])
    with pytest.raises(coface.InvalidInputError, match="beyond 32 bits"):
        coface.invariant_factors([[10**10, 0], [0, 3]])


def test_cells_of_lar_are_taken():
    lar = coface.LarModel(coface.generate("csaszar"))
    assert coface.homology(lar).betti_numbers == (1, 2, 1)
    assert coface.as_model(lar).f_vector == (7, 21, 14)
    assert coface.incidence(lar, "FE", "incident").shape == (14, 21)
    assert coface.render(lar).startswith(b"<svg")
    with pytest.raises(coface.Error) as fault:
        coface.LarModel([[[0, 1]], [[0, 1, 2]]]).chain_complex()
    assert "::" not in str(fault.value)


def test_files_that_are_open_are_read_and_written(tmp_path):
    sphere = coface.generate("sphere")
    path = tmp_path / "sphere.off"
    sphere.write(path)
    with open(path, "rb") as file:
        assert coface.read(file) == coface.read(path)
    with open(path) as file:
        assert coface.read(file) == coface.read(path)
    assert coface.read(io.BytesIO(path.read_bytes())).faces.tolist() == sphere.faces.tolist()
    content = io.BytesIO()
    sphere.write(content, "off")
    assert content.getvalue() == path.read_bytes()
    text = io.StringIO()
    sphere.write(text, format="off")
    assert text.getvalue().encode() == path.read_bytes()
    with open(tmp_path / "named.ply", "wb") as file:
        sphere.write(file)
    assert coface.read(tmp_path / "named.ply").faces.tolist() == sphere.faces.tolist()
    with pytest.raises(coface.InvalidInputError, match="format="):
        sphere.write(io.BytesIO())
    with pytest.raises(coface.InvalidTypeError, match="nothing to write to"):
        sphere.write(7, "off")
    with pytest.raises(coface.InvalidTypeError, match="is no file"):
        coface.read(7)
    region = coface.boolean("union", coface.polygon(SHELL))
    content = io.BytesIO()
    region.write(content, "wkt")
    assert content.getvalue() == region.to_bytes("wkt")


def test_what_a_format_does_not_keep_is_a_warning(tmp_path):
    grouped = coface.generate("csaszar").with_group("all", [0, 1], "faces")
    with pytest.warns(coface.AssumptionWarning, match="does not keep groups"):
        grouped.write(tmp_path / "grouped.off")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        grouped.write(tmp_path / "grouped.obj")
        coface.to_trimesh(grouped)


def test_repaired_models_are_models():
    pinched = coface.as_model(coface.Complex([[0, 1, 2], [0, 2, 3], [0, 3, 1], [0, 4, 5], [0, 5, 6], [0, 6, 4]]))
    repaired = pinched.repaired(split_edges="pairs", split_vertices=True)
    model, sources = repaired
    assert repaired.model is model and repaired.vertex_sources is sources
    assert coface.homology(repaired) == coface.homology(model)
    assert len(coface.cut(repaired).components) == 2
    assert coface.as_surface(pinched.repaired_surface()).component_count == 2
    assert coface.homology(coface.Model.from_halfedges([2, 3, 1, 0]).subdivided()).betti_numbers == (1, 2, 1)
    box = coface.generate("box", boundary=True)
    opened = coface.Model(box.vertices, np.asarray(box.faces)[1:])
    assert coface.boolean("union", opened.repaired_surface(closed=True)).measure == 1
    assert coface.render(repaired) == coface.render(model)


def test_chains_have_sums_and_values():
    torus = coface.generate("torus", columns=5, rows=4)
    complex = coface.as_chain_complex(torus)
    first, second = complex.homology(generators=True)[1].generators
    a, b = first.chain, second.chain
    assert a - a == 0 and a != 0 and hash(a - a) == hash(0)
    assert a + b == b + a and 2 * a == a + a == a * 2 and -a == 0 - a
    assert sum([a, b]) == a + b == first + second
    assert complex.is_cycle(a + b) if hasattr(complex, "is_cycle") else True
    zero = (a + b - a) - b
    assert zero.terms() == [] and not len(zero)
    cocycles = [one.chain for one in complex.cohomology(generators=True)[1].generators]
    table = np.array([[cocycle @ cycle for cycle in (a, b)] for cocycle in cocycles])
    assert abs(round(np.linalg.det(table))) == 1
    # The second method: vectors.
    for cocycle in cocycles:
        assert cocycle.value(a + 3 * b) == (cocycle.as_vector().T @ (a + 3 * b).as_vector()).toarray().item()
    with pytest.raises(coface.InvalidTypeError, match="no sum"):
        a + cocycles[0]
    with pytest.raises(coface.InvalidTypeError, match="no values"):
        a @ b
    with pytest.raises(coface.InvalidInputError, match="one complex"):
        a + coface.as_chain_complex(coface.generate("torus", columns=4, rows=5)).homology(generators=True)[1].generators[0]
    with pytest.raises(coface.InvalidInputError, match="degrees"):
        a + complex.homology(generators=True)[2].generators[0]
    assert coface.is_exact(torus, cocycles[0])["exact"] is False


def test_halfedges_around_cells():
    surface = coface.as_surface(coface.generate("torus", columns=5, rows=4))
    sides = np.arange(len(surface.next))
    assert (surface.previous[surface.next] == sides).all()
    for face in range(surface.f_vector[2]):
        around = surface.halfedges_of_face(face)
        assert (surface.next[around] == np.roll(around, -1)).all() and (surface.face[around] == face).all()
    for edge in range(surface.f_vector[1]):
        assert sorted(surface.halfedges_of_edge(edge)) == np.flatnonzero(surface.edge == edge).tolist()
    for vertex in range(surface.f_vector[0]):
        around = surface.halfedges_from_vertex(vertex)
        assert sorted(around) == np.flatnonzero(surface.vertex == vertex).tolist()
        # Each is beside the one before it.
        turned = surface.twin[surface.previous[around]]
        assert (turned == np.roll(around, -1)).all() or (turned == np.roll(around, 1)).all()
    with pytest.raises(IndexError):
        surface.halfedges_of_face(1000)
    dual = surface.dual()
    assert dual.f_vector == surface.f_vector[::-1]
    assert coface.homology(surface.dual_graph()).betti_numbers == (1, surface.f_vector[1] - surface.f_vector[2] + 1)


def test_questions_in_the_words_of_the_program():
    torus = coface.generate("torus", columns=5, rows=4)
    assert coface.persistence(torus, "z") == coface.persistence(torus, np.asarray(torus.vertices)[:, 2])
    with pytest.raises(coface.InvalidInputError, match='"x", "y" or "z"'):
        coface.persistence(torus, "height")
    with pytest.raises(coface.InvalidInputError, match="no coordinate"):
        coface.persistence([[0, 1]], "x")
    walks = [list(loop) for loop in coface.cocycles(torus).loops]
    assert [walk["contractible"] for walk in coface.homotopic(torus, walks)] == [False, False]


def test_faults_are_faults_of_the_package():
    square = coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 2], [0, 2]]], order=4, kinks="all")
    torus = coface.generate("torus")
    for ask in (
        lambda: square.kinks[-1],
        lambda: "x" in square,
        lambda: square.insert_kink(0, -1),
        lambda: coface.check(True),
        lambda: coface.persistence([[0, 1], [1, 2]], 3),
        lambda: coface.view(coface.harmonic(torus), "never.html"),
        lambda: coface.is_exact(torus, [(1, [0, 1])]),
        lambda: coface.render([torus, coface.ChainComplex.from_boundaries([[[0]]])]),
    ):
        with pytest.raises(coface.Error) as fault:
            ask()
        assert "JSON serializable" not in str(fault.value) and "inhomogeneous" not in str(fault.value)
    assert coface.render([torus, coface.as_chain_complex(torus)]) == coface.render(torus)


def test_json_of_answers_is_what_the_program_reads(tmp_path):
    region = coface.boolean("difference", coface.polygon(SHELL), coface.polygon(HOLE))
    facts = json.loads(region.to_bytes("json"))
    assert "boundaries" in facts


def test_edges_of_an_interface_are_there_once():
    left, right = (coface.YinSet.from_rings([[[x, 0], [x + 1, 0], [x + 1, 1], [x, 1]]]) for x in (0, 1))
    assert coface.homology(coface.interface([left, right])).betti_numbers == (1, 2)
    assert coface.homology(coface.interface([coface.YinSet([coface.Curve.circle([0, 0], 1)])])).betti_numbers == (1, 1)


def test_graphs_and_extended_persistence_are_shown(tmp_path):
    cube = coface.generate("box", boundary=True)
    graph = coface.arrange(cube, coface.Model(np.asarray(cube.vertices) + 0.5, cube.faces)).graph()
    assert coface.homology(graph).betti_numbers == (1, 0)
    assert coface.view(graph, tmp_path / "graph.html").stat().st_size > 10_000
    found = coface.extended_persistence([[0, 1], [1, 2], [2, 3], [3, 0]], [0.0, 2.0, 1.0, 3.0])
    assert "extended+" in coface.view(found, tmp_path / "extended.html").read_text()
    pytest.importorskip("matplotlib")
    assert coface.plot(found).get_xlabel() == "birth"
    assert coface.plot(graph) is not None


def test_what_is_assumed_of_inputs_is_a_warning():
    bow = coface.polygon([[0, 0], [2, 2], [2, 0], [0, 2]])
    for ask in (coface.arrange, lambda x: coface.boolean("union", x)):
        with pytest.warns(coface.AssumptionWarning, match="crosses itself"):
            ask(bow)
    with pytest.warns(coface.AssumptionWarning, match="not inside of its outer ring"):
        coface.boolean("union", coface.polygon(SHELL, [[6, 0], [7, 0], [7, 1]]))
    bent = coface.Model([[0, 0, 0], [1, 0, 0], [1, 1, 0.1], [0, 1, 0]], [[0, 1, 2, 3]])
    with pytest.warns(coface.AssumptionWarning):
        coface.arrange(bent)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        coface.boolean("union", coface.polygon(SHELL, HOLE))
        coface.arrange(coface.generate("box", boundary=True))


def test_lines_that_nearly_meet_bound_faces_within_a_tolerance():
    # The third side ends short of the first.
    lines = coface.Model.from_bytes(b"MULTILINESTRING ((0 0, 4 0), (4 0, 0 3), (0 3, 0 0.0000001))", "wkt")

    def area(**options):
        return coface.boolean("union", coface.maps.polygonize(lines, **options)).measure

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert coface.maps.polygonize(lines).__geo_interface__["features"] == []
        assert area(tolerance=0.001) == area(grid=0.5) == 6
        assert len(coface.maps.node(lines, tolerance=0.001).__geo_interface__["features"]) == 3
        assert len(coface.maps.node(lines, snap=True).__geo_interface__["features"]) == 3
    with pytest.raises(coface.InvalidInputError, match="two ways"):
        coface.maps.node(lines, tolerance=0.1, grid=0.1)
