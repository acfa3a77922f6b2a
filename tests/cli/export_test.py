"""wirepack export: what it writes is read by other people's programs, with the right numbers."""

import csv
import ctypes
import math
import os
import resource
import unittest
import xml.etree.ElementTree as xml
import zipfile
from pathlib import Path

import gemmi
import h5py
import meshio
import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from known_wire import arc_wire, replace_last_frame, straight_wire
from support import SMALL_RUN, ProgramTest

SERIES = {"vtk": ".pvd", "xdmf": ".xdmf", "xyz": ".xyz"}
SINGLE = {"stl": ".stl", "ply": ".ply", "3mf": ".3mf", "mhd": ".mhd", "mmcif": ".cif"}
ENDINGS = {**SERIES, **SINGLE, "csv": ".csv"}


def read_vtk(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def tube_volume(surface):
    """By the divergence theorem: negative if the triangles face inwards."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    corners = points[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    return numpy.linalg.det(corners).sum() / 6


def open_edges(surface):
    """Edges of a surface that do not belong to exactly two triangles."""
    clean = vtk.vtkCleanPolyData()
    clean.SetInputData(surface)
    edges = vtk.vtkFeatureEdges()
    edges.SetInputConnection(clean.GetOutputPort())
    edges.FeatureEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


class Beam(ctypes.Structure):
    _fields_ = [
        ("node", ctypes.c_uint32 * 2),
        ("radius", ctypes.c_double * 2),
        ("cap", ctypes.c_int * 2),  # 0: sphere, 2: butt
    ]


def read_3mf(path):
    """Vertices and beams, as lib3mf reads them."""
    library = ctypes.CDLL("lib3MF.so.1")

    def call(name, *arguments):
        status = getattr(library, "lib3mf_" + name)(*arguments)
        assert status == 0, f"{name}: {status & 0xFFFFFFFF:x}"

    def handle(name, *arguments):
        result = ctypes.c_void_p()
        call(name, *arguments, ctypes.byref(result))
        return result

    def number(name, owner):
        result = ctypes.c_uint32()
        call(name, owner, ctypes.byref(result))
        return result.value

    model = handle("createmodel")
    reader = handle("model_queryreader", model, b"3mf")
    call("reader_readfromfileutf8", reader, str(path).encode())
    assert number("reader_getwarningcount", reader) == 0
    objects = handle("model_getmeshobjects", model)
    assert number("resourceiterator_movenext", objects) == 1
    wire = handle("resourceiterator_getcurrent", objects)
    vertices = []
    for i in range(number("meshobject_getvertexcount", wire)):
        vertex = (ctypes.c_float * 3)()
        call("meshobject_getvertex", wire, i, ctypes.byref(vertex))
        vertices.append(list(vertex))
    beams = []
    for i in range(number("meshobject_getbeamcount", wire)):
        beam = Beam()
        call("meshobject_getbeam", wire, i, ctypes.byref(beam))
        beams.append((*beam.node, *beam.radius, *beam.cap))
    return numpy.array(vertices), beams


class Export(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        maker = cls("make_result")
        ProgramTest.setUp(maker)
        cls.addClassCleanup(maker.doCleanups)
        cls.original = maker.make_result().read_bytes()

    def setUp(self):
        super().setUp()
        self.write("run.h5", self.original)
        with h5py.File(self.folder / "run.h5") as file:
            self.frames = [
                {
                    **{name: data[()] for name, data in frame.items()},
                    **frame.attrs,
                }
                for _, frame in sorted(file["frames"].items())
            ]

    def make_result(self):
        self.write("scenario.toml", SMALL_RUN)
        code, _, err = self.run_program("run", "scenario.toml", "-o", "run.h5")
        self.assertEqual(code, 0, err)
        return self.folder / "run.h5"

    def export(self, name, *arguments, result="run.h5", to=None):
        target = to or "out" + ENDINGS[name]
        code, out, err = self.run_program(
            "export", result, "--format", name, "-o", target, *arguments
        )
        self.assertEqual(code, 0, err)
        self.assertEqual(out, f"{target}\n")
        return self.folder / target

    def refused(self, code, *arguments):
        before = self.names()
        found, out, err = self.run_program("export", *arguments)
        self.assertEqual(found, code, err)
        self.assertEqual(out, "")
        self.assertEqual(len(err.strip().splitlines()), 1, err)
        self.assertEqual(self.names(), before)
        return err

    def test_vtk_reads_every_frame_with_its_numbers_and_units(self):
        collection = xml.parse(self.export("vtk")).getroot()
        sets = collection.findall("Collection/DataSet")
        self.assertEqual(len(sets), len(self.frames))
        for entry, frame in zip(sets, self.frames):
            self.assertEqual(float(entry.get("timestep")), frame["inserted_length"])
            line = read_vtk(vtk.vtkXMLPolyDataReader(), self.folder / entry.get("file"))
            points = vtk_to_numpy(line.GetPoints().GetData())
            numpy.testing.assert_array_equal(points, frame["position"])
            self.assertEqual(line.GetNumberOfLines(), 1)
            order = vtk_to_numpy(line.GetLines().GetConnectivityArray())
            numpy.testing.assert_array_equal(order, numpy.arange(len(points)))
            for name, unit in (("bend_energy", "force length"), ("wall_force", "force")):
                array = line.GetPointData().GetArray(name)
                label = array.GetInformation().Get(vtk.vtkDataArray.UNITS_LABEL())
                self.assertEqual(label, unit)
                numpy.testing.assert_allclose(vtk_to_numpy(array), frame[name], rtol=1e-6)
            number = line.GetFieldData().GetArray("packing_density").GetValue(0)
            self.assertEqual(number, frame["packing_density"])

    def test_each_contact_gives_half_its_force_to_the_nodes_of_both_edges(self):
        nodes = straight_wire(6, 12)
        replace_last_frame(self.folder / "run.h5", nodes, [(0, 5, 3.0), (5, 9, 1.0)])
        path = self.export("xyz", "--frame", self.frames[-1]["increment"])
        lines = path.read_text().splitlines()
        columns = lines[1].split()[0].split("=")[1].split(":")[::3]
        self.assertEqual(columns[-1], "contact_force")
        force = [float(line.split()[-1]) for line in lines[2:]]
        self.assertEqual(force, [1.5, 1.5, 0, 0, 0, 2, 2, 0, 0, 0.5, 0.5, 0, 0])
        at = columns.index("scaled_bend_energy") + 2  # position is three words
        scaled = [float(line.split()[at]) for line in lines[2:]]
        # node 3 has the energy 3 and the length 1/2, YI = 5 pi / 4, R = 4
        self.assertAlmostEqual(scaled[3], 3 / 0.5 / (5 * math.pi / 4 / (2 * 4**2)), places=5)

    def test_xdmf_leads_meshio_to_the_data_inside_of_the_result(self):
        (self.folder / "a&b <1>").mkdir()
        path = self.export("xdmf", to="a&b <1>/out.xdmf")
        os.chdir(path.parent)  # meshio looks for the data from where it is
        self.addCleanup(os.chdir, "/")
        with meshio.xdmf.TimeSeriesReader("out.xdmf") as reader:
            self.assertEqual(reader.num_steps, len(self.frames))
            points, (line,) = reader.read_points_cells()
            numpy.testing.assert_array_equal(points, self.frames[0]["position"])
            self.assertEqual(line.data.tolist(), [list(range(len(points)))])
            for k, frame in enumerate(self.frames):
                time, values = reader.read_data(k)[:2]
                self.assertEqual(time, frame["inserted_length"])
                numpy.testing.assert_array_equal(values["bend_energy"], frame["bend_energy"])
        grids = xml.parse(path).findall(".//Grid[@GridType='Uniform']")
        self.assertEqual(len(grids), len(self.frames))
        for grid, frame in zip(grids, self.frames):
            self.assertEqual(float(grid.find("Time").get("Value")), frame["inserted_length"])
            n = len(frame["position"])
            order = grid.find("Topology/DataItem").text.split()
            self.assertEqual([int(i) for i in order], list(range(n)))
            self.assertEqual(grid.find("Topology").get("NodesPerElement"), str(n))
            for item in grid.findall("*/DataItem[@Format='HDF']"):
                name, dataset = item.text.strip().split(":")
                with h5py.File(path.parent / name) as file:
                    shape = tuple(int(k) for k in item.get("Dimensions").split())
                    self.assertEqual(file[dataset].shape, shape)
                    numpy.testing.assert_array_equal(
                        file[dataset], frame[dataset.rsplit("/", 1)[1]]
                    )

    def test_extended_xyz_has_a_block_of_all_numbers_per_frame(self):
        lines = self.export("xyz").read_text().splitlines()
        for frame in self.frames:
            n = int(lines[0])
            self.assertEqual(n, len(frame["position"]))
            self.assertIn(f"increment={frame['increment']} ", lines[1])
            rows = numpy.array([line.split()[1:] for line in lines[2 : 2 + n]], float)
            numpy.testing.assert_array_equal(rows[:, :3], frame["position"])
            numpy.testing.assert_array_equal(rows[:, 3], 1)
            numpy.testing.assert_allclose(rows[:, 5], frame["bend_energy"], rtol=1e-8)
            lines = lines[2 + n :]
        self.assertEqual(lines, [])

    def test_surface_of_a_straight_wire_is_closed_and_has_the_volume_of_the_wire(self):
        replace_last_frame(self.folder / "run.h5", straight_wire(6, 12))
        for name, reader in (("stl", vtk.vtkSTLReader()), ("ply", vtk.vtkPLYReader())):
            surface = read_vtk(reader, self.export(name))
            self.assertAlmostEqual(
                tube_volume(surface), math.pi * 6, delta=1e-4
            )  # single precision
            self.assertEqual(open_edges(surface), 0)

    def test_surface_of_an_arc_has_the_volume_of_a_torus(self):
        replace_last_frame(self.folder / "run.h5", arc_wire(3, 1.5 * math.pi, 60))
        surface = read_vtk(vtk.vtkSTLReader(), self.export("stl"))
        exact = math.pi * 3 * 1.5 * math.pi
        # 180 straight parts: each is shorter than its arc by 1e-4
        self.assertAlmostEqual(tube_volume(surface) / exact, 1, delta=3e-4)

    def test_colours_of_the_surface_follow_the_bending_energy(self):
        replace_last_frame(self.folder / "run.h5", straight_wire(6, 12))
        surface = read_vtk(vtk.vtkPLYReader(), self.export("ply"))
        colours = vtk_to_numpy(surface.GetPointData().GetArray("RGB"))
        self.assertEqual(colours[0].tolist(), [0x2B, 0x5C, 0x8A])  # no energy at the tip
        self.assertEqual(colours[-1].tolist(), [0xB5, 0x34, 0x2C])
        mesh = meshio.read(self.folder / "out.ply")
        self.assertEqual(mesh.point_data["scaled_bend_energy"][0], 0)

    def test_lib3mf_reads_nodes_and_beams_that_fill_joints_and_end_flat(self):
        vertices, beams = read_3mf(self.export("3mf"))
        position = self.frames[-1]["position"]
        numpy.testing.assert_allclose(vertices, position, atol=1e-6)
        last = len(position) - 2
        for j, beam in enumerate(beams):
            caps = (2 if j == 0 else 0, 2 if j == last else 0)
            self.assertEqual(beam, (j, j + 1, 1.0, 1.0, *caps))
        self.assertEqual(len(beams), last + 1)

    def voxels(self, *arguments):
        reader = vtk.vtkMetaImageReader()
        image = read_vtk(reader, self.export("mhd", "--force", *arguments))
        size = image.GetSpacing()[0]
        values = vtk_to_numpy(image.GetPointData().GetScalars())
        shape = image.GetDimensions()[::-1]
        return values.reshape(shape) / 255.0, size, image.GetOrigin()

    def test_voxels_of_known_wires_have_their_volume(self):
        for nodes, length, beyond in (
            (straight_wire(6, 12), 6, 1),
            (
                straight_wire(5, 50),
                5,
                1,
            ),  # edges much shorter than the radius: flat ends all the same
            # of a part of a torus, the centre of mass is further out than that of its axis
            (arc_wire(2.8, 1.5 * math.pi, 60), 2.8 * 1.5 * math.pi, 1 + 1 / (2 * 2.8) ** 2),
        ):
            replace_last_frame(self.folder / "run.h5", nodes)
            solid, size, origin = self.voxels("--voxel", 0.2)
            self.assertAlmostEqual(size, 0.2)
            self.assertAlmostEqual(origin[0], -4 + size / 2)
            # probed at 20 points to the radius
            self.assertAlmostEqual(solid.sum() * size**3 / (math.pi * length), 1, delta=2e-3)
            z, y, x = numpy.meshgrid(
                *3 * [origin[0] + size * numpy.arange(len(solid))], indexing="ij"
            )
            weights = solid / solid.sum()
            centre = [(weights * axis).sum() for axis in (x, y, z)]
            numpy.testing.assert_allclose(centre, nodes_centre(nodes) * beyond, atol=5e-3)

    def test_voxels_of_a_packing_have_its_density(self):
        solid, size, _ = self.voxels()
        density = solid.sum() * size**3 / (4 / 3 * math.pi * 4**3)
        length = numpy.linalg.norm(numpy.diff(self.frames[-1]["position"], axis=0), axis=1).sum()
        # strands overlap by a few per cent of a where they touch, joints are as bent as the wire
        self.assertAlmostEqual(density / (3 * length / (4 * 4**3)), 1, delta=0.01)
        self.assertEqual(solid.max(), 1)

    def test_gemmi_reads_a_chain_of_bonded_beads(self):
        path = self.export("mmcif")
        structure = gemmi.read_structure(str(path))
        atoms = [cra.atom for cra in structure[0].all()]
        found = [atom.pos.tolist() for atom in atoms]
        numpy.testing.assert_allclose(found, self.frames[-1]["position"], atol=1e-6)
        self.assertEqual(len(structure.connections), len(atoms) - 1)
        self.assertEqual([chain.name for chain in structure[0]], ["A"])
        self.assertGreater(max(atom.b_iso for atom in atoms), 0)

    def test_csv_is_the_history(self):
        lines = self.export("csv").read_text().splitlines()
        notes = [line for line in lines if line.startswith("#")]
        rows = list(csv.DictReader(lines[len(notes) :]))
        units = notes[-1].removeprefix("# units: ").split(",")
        with h5py.File(self.folder / "run.h5") as file:
            self.assertEqual(set(rows[0]), set(file["history"]))
            for name, unit in zip(rows[0], units):
                column = file["history"][name]
                self.assertEqual(column.attrs["unit"], unit)
                self.assertEqual([float(row[name]) for row in rows], column[()].tolist())

    def test_every_format_names_its_origin(self):
        with h5py.File(self.folder / "run.h5") as file:
            commit = file.attrs["git_commit"]
        for name, ending in ENDINGS.items():
            path = self.export(name)
            if name == "3mf":
                with zipfile.ZipFile(path) as archive:
                    data = archive.read("3D/3dmodel.model")
            else:
                data = path.read_bytes()
            start = commit[:12] if name == "stl" else commit  # a header of 80 characters
            self.assertIn(start.encode(), data[:4000], name)

    def test_bytes_of_a_name_that_are_no_text_are_in_no_text(self):
        name = b"odd\xff\x1b\n.h5"
        os.link(self.folder / "run.h5", os.fsencode(self.folder) + b"/" + name)
        text = self.export("mmcif", result=os.fsdecode(name)).read_bytes().decode()
        self.assertIn("# from odd???.h5, a run", text)
        self.assertNotIn("\x1b", text)

    def test_equal_calls_give_equal_bytes(self):
        for name in ENDINGS:
            first = self.export(name).read_bytes()
            self.assertEqual(self.export(name, "--force").read_bytes(), first)

    def test_frames_are_chosen_by_increment_and_by_density(self):
        middle = self.frames[len(self.frames) // 2]
        for choice in (
            ("--frame", middle["increment"]),
            ("--density", middle["packing_density"] + 1e-3),
        ):
            lines = self.export("xyz", "--force", *choice).read_text().splitlines()
            self.assertEqual(int(lines[0]) + 2, len(lines))
            self.assertIn(f"increment={middle['increment']} ", lines[1])

    def test_wrong_wishes_are_refused_with_what_is_allowed(self):
        wishes = [
            ("stl,ply", "run.h5", "--format", "obj", "-o", "out.obj"),
            (".stl", "run.h5", "--format", "stl", "-o", "out.ply"),
            ("no such frame", "run.h5", "--format", "stl", "-o", "out.stl", "--frame", "100000"),
            (
                "its frames are from",
                "run.h5",
                "--format",
                "stl",
                "-o",
                "out.stl",
                "--density",
                "0.99",
            ),
            ("--density", "run.h5", "--format", "stl", "-o", "out.stl", "--density", "7"),
            ("no frames", "run.h5", "--format", "csv", "-o", "out.csv", "--frame", "1"),
            ("mhd", "run.h5", "--format", "stl", "-o", "out.stl", "--voxel", "1"),
            ("at least", "run.h5", "--format", "mhd", "-o", "out.mhd", "--voxel", "1e-6"),
            ("at most 8", "run.h5", "--format", "mhd", "-o", "out.mhd", "--voxel", "9"),
        ]
        for expected, *arguments in wishes:
            self.assertIn(expected, self.refused(2, *arguments))

    def test_what_exists_stays_unless_told_otherwise(self):
        self.write("out.stl", "mine")
        err = self.refused(2, "run.h5", "--format", "stl", "-o", "out.stl")
        self.assertIn("--force", err)
        self.assertEqual((self.folder / "out.stl").read_text(), "mine")
        self.export("stl", "--force")
        self.assertNotEqual((self.folder / "out.stl").read_bytes(), b"mine")
        (self.folder / "out").mkdir()
        kept = self.write(f"out/{self.frames[0]['increment']:06}.vtp", "mine")
        self.refused(2, "run.h5", "--format", "vtk", "-o", "out.pvd")
        self.assertEqual(kept.read_text(), "mine")
        (self.folder / "run.h5").rename(self.folder / "run.csv")
        self.assertIn(
            "input of this command",
            self.refused(2, "run.csv", "--format", "csv", "-o", "run.csv", "--force"),
        )

    def test_bad_results_and_full_places_are_file_errors(self):
        with h5py.File(self.folder / "other.h5", "w") as file:
            file["data"] = [1.0]
        with h5py.File(self.write("empty.h5", self.original), "r+") as file:
            for name in list(file["frames"]):
                del file["frames"][name]
        self.write("cut.h5", self.original[: len(self.original) // 2])
        for result in ("other.h5", "cut.h5", "missing.h5", "empty.h5"):
            for name in ("vtk", "mhd"):
                err = self.refused(5, result, "--format", name, "-o", "out" + ENDINGS[name])
                self.assertIn(result, err)
        self.write("file", "")
        self.refused(5, "run.h5", "--format", "stl", "-o", "file/out.stl")
        self.refused(5, "run.h5", "--format", "vtk", "-o", "/proc/out.pvd")

    def test_a_disk_that_fills_up_keeps_no_part_of_a_series(self):
        frame = self.export("vtk").with_name("out") / f"{self.frames[-1]['increment']:06}.vtp"
        limit = frame.stat().st_size - 1  # the last frame is the largest
        before = self.names()
        code, _, err = self.run_program(
            "export", "run.h5", "--format", "vtk", "-o", "new.pvd",
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)),
        )  # fmt: skip
        self.assertEqual(code, 5, err)
        self.assertIn("File too large", err)
        self.assertEqual(self.names(), before)

    def test_a_colon_in_the_name_of_the_result_is_refused_for_xdmf(self):
        (self.folder / "run.h5").rename(self.folder / "a:b.h5")
        self.assertIn("colon", self.refused(2, "a:b.h5", "--format", "xdmf", "-o", "out.xdmf"))


def nodes_centre(nodes):
    """Centre of mass of the polygon through nodes."""
    middle = (nodes[1:] + nodes[:-1]) / 2
    weights = numpy.linalg.norm(numpy.diff(nodes, axis=0), axis=1)
    return (middle * weights[:, None]).sum(axis=0) / weights.sum()


if __name__ == "__main__":
    unittest.main()
