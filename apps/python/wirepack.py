"""Reads result files of wirepack, with numpy and h5py alone (for Packer see wirepack_packer.py).

    run = wirepack.Run("out.h5")      # a live, killed or finished run; run.reload() for what is new
    run.history.force, run.history.force.unit
    run.frames[-1].position           # the last frame; run.frames[0.1] the one nearest to phi = 0.1
    run.frames[0.1:0.2]               # those of packing densities 0.1 to 0.2
    run.to_xyz("out.xyz"), run.to_gsd("out.gsd"), run.frames[-1].to_pyvista()

Units are powers of the configuration's base units. Frames that are not known to be in equilibrium
are refused with NotConverged, unless Run(path, unconverged=True) asks for them.
"""

import html
import io
import tomllib
from pathlib import Path

import h5py
import numpy

FORMAT_VERSIONS = (1, 2, 3)  # they differ in the checkpoint and checksums, which are not read here
FAILURES = ("no_equilibrium", "strands_passed")
FRAME_ARRAYS = {"position": "length", "quaternion": "1", "bend_energy": "force length",
                "twist_energy": "force length", "wall_force": "force",
                "contact_pairs": "1", "contact_force": "force"}
FRAME_NUMBERS = dict(increment="1", inserted_length="length", packing_density="1", force="force")


class ResultError(ValueError):
    """The file is no result of wirepack, of another version, or damaged."""


class NotConverged(ValueError):
    """A frame was asked for that is not known to be in equilibrium."""


class Quantity(numpy.ndarray):
    """An array with a unit. Parts keep the unit; what is computed from it is a plain array."""

    def __new__(cls, values, unit):
        self = numpy.asarray(values).view(cls)
        self.unit = unit
        return self

    def __array_finalize__(self, source):
        self.unit = getattr(source, "unit", None)

    def __array_ufunc__(self, function, method, *inputs, out=None, **options):
        if out is not None:
            options["out"] = tuple(numpy.asarray(array) for array in out)
        return getattr(function, method)(*map(numpy.asarray, inputs), **options)

    def __array_function__(self, function, types, arguments, options):
        result = super().__array_function__(function, types, arguments, options)
        return result.view(numpy.ndarray) if isinstance(result, Quantity) else result

    def __repr__(self):
        return f"{self.view(numpy.ndarray)!r} [{self.unit}]"


class History(dict):
    """Columns of the history by name, also as attributes: one value per increment."""

    def __init__(self, group):
        super().__init__((name, Quantity(c[()], c.attrs["unit"])) for name, c in group.items())
        if len({len(column) for column in self.values()}) != 1:
            raise ValueError("its history has columns of unequal length")

    def __getattr__(self, name):
        if name not in self:
            raise AttributeError(f"the history has no column {name}; it has {', '.join(self)}")
        return self[name]

    def __dir__(self):
        return [*super().__dir__(), *self]


class Frame:
    """One moment: position (N x 3), quaternion (N - 1 x 4, scalar first), bend_energy,
    twist_energy, wall_force, arc_length (N), contact_pairs (M x 2, edges), contact_force (M);
    increment, inserted_length, packing_density, force, with units in .units. Node 0 is the tip."""

    units = {**FRAME_ARRAYS, **FRAME_NUMBERS, "arc_length": "length"}

    def __init__(self, numbers, arrays):
        vars(self).update((name, numbers[name].item()) for name in FRAME_NUMBERS)
        vars(self).update((n, Quantity(arrays[n][()], unit)) for n, unit in FRAME_ARRAYS.items())
        steps = numpy.linalg.norm(numpy.diff(self.position, axis=0), axis=1)
        self.arc_length = Quantity(numpy.concatenate([[0.0], numpy.cumsum(steps)]), "length")

    def __len__(self):
        return len(self.position)

    def __repr__(self):
        return f"<frame {self.increment}: phi = {self.packing_density:.4g}, {len(self)} nodes>"

    def to_pyvista(self):
        """The wire as a line of pyvista; .tube(radius=run.radius) gives it its thickness."""
        import pyvista
        line = pyvista.PolyData(numpy.array(self.position))
        line.lines = numpy.concatenate([[len(self)], numpy.arange(len(self))])
        for name in ("arc_length", "bend_energy", "twist_energy", "wall_force"):
            line.point_data[name] = numpy.array(getattr(self, name))
        return line


class Frames:
    """In order. [int]: by place, [float]: nearest to a packing density; slices of both kinds."""

    def __init__(self, run, names):
        self._run, self._names = run, names

    def __len__(self):
        return len(self._names)

    def __repr__(self):
        densities = ", ".join(f"{density:.4g}" for density in self.packing_density)
        return f"{len(self)} frames of packing density {densities or '-'}"

    packing_density = property(lambda self: Quantity(
        [self._run._file["frames"][n].attrs["packing_density"] for n in self._names], "1"))

    def __getitem__(self, key):
        if isinstance(key, slice):
            if not any(isinstance(end, (float, numpy.floating)) for end in (key.start, key.stop)):
                return Frames(self._run, self._names[key])
            low, high = key.start or 0, 1 if key.stop is None else key.stop
            chosen = (self.packing_density >= low) & (self.packing_density <= high)
            return Frames(self._run, list(numpy.array(self._names)[chosen][:: key.step]))
        if isinstance(key, (float, numpy.floating)):
            distance = numpy.abs(self.packing_density - key)
            if not distance.min(initial=1) <= self._run.config["output"]["frame_every_density"]:
                raise IndexError(f"no frame near packing density {key}; there are {self}")
            key = int(distance.argmin())
        if not -len(self) <= key < len(self):
            raise IndexError(f"no frame {key}; there are {self}")
        return self._run._frame(self._names[key])


class Run:
    """A result file as it was when it was opened; reload() takes what has come since."""

    def __init__(self, path, unconverged=False):
        self.path, self.unconverged = Path(path), unconverged
        self.reload()

    def reload(self):
        data = io.BytesIO(self.path.read_bytes())  # as it is now; needs no lock, is in nobody's way
        try:
            file = h5py.File(data, "r")
            facts = dict(file.attrs)
            if facts.get("format") != "wirepack" or facts["format_version"] not in FORMAT_VERSIONS:
                raise ValueError(f"format version is none of {FORMAT_VERSIONS}")
            self.history = History(file["history"])
            self.config = tomllib.loads(facts["config"])
            self.frames = Frames(self, sorted(file["frames"], key=int))
        except (OSError, KeyError, ValueError) as error:
            raise ResultError(f"{self.path}: damaged, or no result of wirepack: {error}") from None
        self._file, self.attributes = file, facts
        return self

    finished = property(lambda self: bool(self.attributes["finished"]))
    stop_reason = property(lambda self: self.attributes["stop_reason"])  # empty unless finished
    state = property(lambda self: f"ended by {self.stop_reason}" if self.finished else "unfinished")
    radius = property(lambda self: self.config["wire"]["radius"])
    semi_axes = property(
        lambda run: numpy.full(3, (c := run.config["cavity"]).get("semi_axes") or c["radius"]))
    cavity_radius = property(lambda self: float(numpy.cbrt(self.semi_axes.prod())))
    youngs_modulus = property(lambda self: self.config["wire"]["youngs_modulus"])
    bend_stiffness = property(lambda self: self.youngs_modulus * numpy.pi * self.radius**4 / 4)

    @property
    def converged(self):
        """For every increment: its residual is within the tolerance (runs in time: always)."""
        in_time = self.config["packing"]["method"] == "dynamic"
        return in_time | (self.history.residual <= self.config["minimizer"]["tolerance"])

    def _frame(self, name):
        rows = self.converged[self.history.increment == int(name)]
        failed = self.stop_reason in FAILURES
        if not self.unconverged and (failed or not rows.any()):
            fault = f"run ended by {self.stop_reason}" if failed else f"residual of {name} is large"
            raise NotConverged(f"{self.path}: the {fault}; Run(path, unconverged=True) reads on")
        try:
            return Frame((group := self._file["frames"][name]).attrs, group)
        except (OSError, KeyError) as error:
            raise ResultError(f"{self.path}: frame {name} is damaged: {error}") from None

    def to_xyz(self, path):
        """Extended XYZ of all frames, for OVITO and ASE."""
        with open(path, "w", encoding="utf-8") as out:
            for f in self.frames:
                out.write(f"{len(f)}\nProperties=species:S:1:pos:R:3:radius:R:1:bend_energy:R:1 "
                          f"increment={f.increment} packing_density={f.packing_density}\n")
                for (x, y, z), energy in zip(f.position.tolist(), f.bend_energy.tolist()):
                    out.write(f"X {x} {y} {z} {self.radius} {energy}\n")

    def to_gsd(self, path):
        """GSD of all frames, nodes as particles and edges as bonds, for OVITO, freud and HOOMD."""
        import gsd.hoomd
        with gsd.hoomd.open(str(path), "wb") as out:
            for f in self.frames:
                shot = gsd.hoomd.Snapshot()
                shot.configuration.step = f.increment
                shot.configuration.box = [*(2 * self.semi_axes), 0, 0, 0]
                shot.particles.N, shot.bonds.N = len(f), len(f) - 1
                shot.particles.position = numpy.array(f.position)
                shot.particles.diameter = numpy.full(len(f), 2 * self.radius)
                shot.particles.types, shot.bonds.types = ["wire"], ["edge"]
                shot.bonds.group = numpy.arange(len(f) - 1)[:, None] + [0, 1]
                for name in ("bend_energy", "wall_force"):
                    shot.log["particles/" + name] = numpy.array(getattr(f, name))
                out.append(shot)

    def __repr__(self):
        return f"<run {self.path}: {len(self.converged)} increments, {self.state}, {self.frames}>"

    def _repr_html_(self):
        facts, history = self.attributes, self.history
        table = {"increments": len(history.increment), "frames": len(self.frames),
                 "state": self.state, "not converged": numpy.count_nonzero(~self.converged),
                 "saddles": numpy.count_nonzero(history.get("stable", numpy.ones(1)) == 0),
                 "packing density": f"{facts['phi_max']:.4g}", "seed": facts["seed"],
                 "program": f"{facts['program_version']}, {facts['git_commit']}"}
        rows = "".join(f"<tr><th>{k}</th><td>{html.escape(str(v))}</td>" for k, v in table.items())
        return (f"<b>{html.escape(str(self.path))}</b><table>{rows}</table>"
                + _curve(history, "scaled_force", 1, "YI/R^2")
                + _curve(history, "energy_bend", self.bend_stiffness / self.cavity_radius, "YI/R"))


def _curve(history, name, scale, unit):
    """A column against the packing density, as SVG; its top leaves out the highest 1 %."""
    if len(history.increment) < 2:
        return ""
    x, y = numpy.array(history.packing_density), numpy.array(history[name]) / scale
    top = max(numpy.quantile(y, 0.99), 1e-300)
    heights = 100 - 90 * numpy.clip(y / top, -0.1, 1.1)
    points = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(300 * x / x.max(), heights))
    label = f"{name} [{unit}] to {top:.3g} against packing density to {x.max():.3g}"
    return (f'<figure><svg width="300" height="100" role="img" aria-label="{label}">'
            f'<polyline fill="none" stroke="#2b5c8a" points="{points}"/></svg>'
            f"<figcaption>{label}</figcaption></figure>")


def __getattr__(name):
    try:
        import wirepack_packer
    except ModuleNotFoundError as error:
        raise AttributeError(f"no {name} without the compiled module: {error}") from None
    return getattr(wirepack_packer, name)
