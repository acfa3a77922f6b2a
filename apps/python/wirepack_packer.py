"""What `import wirepack` has beside result files: packing, energies and observables, computed by
the compiled module _wirepack. Not imported by name: wirepack.Packer, wirepack.writhe, ..."""

import functools
import json
import logging
import operator
import os
import shutil
import tempfile
import warnings
import weakref
from pathlib import Path

import _wirepack
import numpy
import wirepack
from _wirepack import NumericalFailure  # noqa: F401


class NoEquilibrium(RuntimeError):
    """The next increment found no equilibrium, or only by strands that pass through each other."""


def _rows(values, name, columns, least):
    """An array of at least so many rows of finite numbers."""
    try:
        rows = numpy.asarray(values)
        real = rows.dtype.kind in "biuf"
    except ValueError:  # rows of unequal length
        real = False
    if not real:
        raise ValueError(f"{name}: is no array of real numbers")
    if rows.ndim != 2 or rows.shape[1] != columns or len(rows) < least:
        raise ValueError(f"{name}: has the shape {rows.shape}; "
                         f"must be N x {columns}, N at least {least}")
    if not numpy.isfinite(rows).all():
        row = numpy.flatnonzero(~numpy.isfinite(rows).all(axis=1))[0]
        raise ValueError(f"{name}[{row}]: is not finite")
    return rows


def _observable(function):
    @functools.wraps(function)
    def observable(position, *arguments, **options):
        position = _rows(position, "position", 3, 3)
        try:
            return function(position, *arguments, **options)
        except TypeError as error:  # without all numbers of all arguments
            raise TypeError(str(error).split("\nInvoked with")[0].strip()) from None
    return observable


OBSERVABLES = ("writhe", "average_crossings", "twist", "knot_type", "coils", "coil_axes",
               "tangent_order", "local_curvatures", "loop_lengths", "strand_spacing",
               "radial_density", "order_by_shell")
globals().update((name, _observable(getattr(_wirepack, name))) for name in OBSERVABLES)


def _toml(value):
    if isinstance(value, (numpy.ndarray, numpy.generic)):
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(map(_toml, value))}]"
    if isinstance(value, (int, float)):
        return str(value).lower()
    return json.dumps(str(value), ensure_ascii=False)


def _assignments(values, path=""):
    """"section.key = value" of a dict of sections, of keys, or of both."""
    if not isinstance(values, dict):
        raise TypeError(f"{values!r}: must be a dict")
    for key, value in values.items():
        if isinstance(value, dict):
            yield from _assignments(value, f"{path}{key}.")
        else:
            yield f"{path}{key} = {_toml(value)}"


class Energy:
    """Energy of a wire and its derivatives.

    terms: stretch, bend, twist, wall and contact [force length]; total: their sum.
    gradient: by the positions, at the quaternions that were given (N x 3) [force].
    moment: by the turning of each edge about itself (N - 1) [force length].
    force: by the length of the wire at the nozzle, the injection force [force].
    """

    def __init__(self, terms, gradient, moment, force):
        self.terms, self.force = terms, force
        self.gradient = wirepack.Quantity(gradient, "force")
        self.moment = wirepack.Quantity(moment, "force length")

    total = property(lambda self: sum(self.terms.values()))

    def __repr__(self):
        return f"<energy {self.total:.6g} of {self.terms}>"


def _configuration(config, changes):
    if isinstance(config, dict):
        return _wirepack._parse("", list(_assignments(config)), changes)
    if isinstance(config, str) and "\n" in config:
        return _wirepack._parse(config, [], changes)
    return _wirepack._read(Path(config), changes)


class Packer(wirepack.Run):
    """A run that goes on when it is told to, and the Run of what it has found so far.

    config: a TOML file; its text, which has line breaks; or its sections as a dict.
    set: values that take the place of those, such as {"cavity.radius": 5}.
    output: the result file, kept up to date meanwhile; without, it is a temporary one. resume goes
    on from what is there, replace begins anew.
    threads: to compute with; their number never changes a result.

    Errors have the messages of the program: ValueError for what it refuses, OSError for trouble
    with files, NumericalFailure and NoEquilibrium, which are RuntimeErrors. Warnings are
    UserWarnings.
    """

    def __init__(self, config, set=None, output=None, resume=False, replace=False, threads=1):
        self._configuration = _configuration(config, list(_assignments(set or {})))
        if resume and replace:
            raise ValueError("resume and replace exclude each other")
        if output is None:
            folder = tempfile.mkdtemp(prefix="wirepack-")
            weakref.finalize(self, shutil.rmtree, folder, ignore_errors=True)
            output = Path(folder, "result.h5")
        self.path, self.unconverged, self.threads = Path(output), False, threads
        _wirepack._output_file(self.path, self._configuration.inputs, resume or replace,
                               "resume=True goes on from it, replace=True begins anew")
        for warning in self._configuration.warnings:
            warnings.warn(warning, stacklevel=2)
        self._run("Packer()", {}, 0, "go_on" if resume else "replace" if replace else "refuse")
        self.path = self.path.absolute()
        self.reload()

    def advance(self, increments=None, density=None, length=None, force=None, scaled_force=None):
        """Goes on until the first of these limits, and by at most so many increments.

        Limits are those of [stop] in a configuration, and take their place: length [length], force
        over Y a^2, scaled_force over YI/R^2. Without any, the configuration's hold. Returns the
        name of the limit that was reached, None after `increments`. The increment that reaches a
        limit may be cut short: what goes on from there repeats it as a whole. Ctrl-C stops between
        two increments, with all of them kept.
        """
        limits = dict(density=density, length=length, force=force, scaled_force=scaled_force)
        limits = {name: float(value) for name, value in limits.items() if value is not None}
        call = [f"{name}={value}" for name, value in limits.items()]
        if increments is not None:
            if operator.index(increments) < 1:
                raise ValueError(f"increments = {increments}: must be 1 or more")
            call.insert(0, f"increments={increments}")
        os.stat(self.path)  # a result that has vanished must not be begun anew
        try:
            reached = self._run(f"advance({', '.join(call)})", limits, increments, "go_on")
        finally:
            self.reload()
        if reached in wirepack.FAILURES:
            raise NoEquilibrium(f"{reached}: the next increment fails even in its smallest part; "
                                "all before it is kept. Other values of [minimizer] and "
                                "[insertion] may help: Packer(..., output=..., resume=True)")
        return reached

    def _run(self, call, limits, increments, existing):
        reached, found, said = _wirepack._run(
            self._configuration, self.path, _wirepack._Existing.__members__[existing],
            f"wirepack.py: {call}", limits, increments, self.threads)
        for message in said:
            logging.getLogger("wirepack").info(message)
        for warning in found:
            warnings.warn(warning, stacklevel=3)
        return reached

    def frame(self):
        """The wire as it is now; .frames are those that are saved on the way."""
        return self._as_frame(_wirepack._frame(self._configuration, self.path))

    def energy(self, position=None, quaternion=None, inserted_length=None):
        """The Energy of a wire in this cavity and nozzle: as it is, of a frame, or at positions.

        position: N x 3, from the tip to the nozzle; or a Frame. quaternion: frames of the edges
        (N - 1 x 4, scalar first), carried onto the edges by the smallest rotations; without, there
        is no twist from the nozzle on. inserted_length: of the unstretched wire; without, that of
        N - 1 whole edges.
        """
        if position is None:
            return Energy(*_wirepack._energies_now(self._configuration, self.path))
        wire = self._wire(position, quaternion, inserted_length)
        return Energy(*_wirepack._energies_at(self._configuration, *wire))

    def relax(self, position, quaternion=None, inserted_length=None):
        """The Frame of the minimum that a wire comes to without friction, at this length.

        Arguments are those of energy(): a Frame or positions, which end in the nozzle of this
        scenario. The wire goes downhill from there, and strands do not pass through each other.
        NoEquilibrium where that ends before a minimum. The run stays as it is.
        """
        wire = self._wire(position, quaternion, inserted_length)
        values, fault = _wirepack._relaxed(self._configuration, *wire, self.threads)
        if fault:
            raise NoEquilibrium(fault)
        return self._as_frame(values)

    def spool_energy(self, density, spacing=2.81):
        """Bending energy of a straight wire coiled to hexagonal hoops, from the wall inwards.

        The inverse-spool model (Purohit, Kondev, Phillips 2003) at a packing density. spacing:
        between neighbouring hoops, in wire radii; 2: they touch.
        """
        return _wirepack._spool_energy(self._configuration, density, spacing)

    @classmethod
    def _wire(cls, position, quaternion, inserted_length):
        """Positions, quaternions and length of a frame, or those that are given."""
        if isinstance(position, wirepack.Frame):
            frame = position
            return cls._wire(frame.position, frame.quaternion, frame.inserted_length)
        position = _rows(position, "position", 3, 3)
        if quaternion is not None:
            quaternion = _rows(quaternion, "quaternion", 4, 2)
        return position, quaternion, None if inserted_length is None else float(inserted_length)

    @staticmethod
    def _as_frame(values):
        values = {name: numpy.asarray(value) for name, value in values.items()}
        return wirepack.Frame(values, values)

    def save(self, path, replace=False):
        """Copies the result so far to a file. replace: in place of one that is there."""
        inputs = [*self._configuration.inputs, self.path]
        target = _wirepack._output_file(path, inputs, replace, "replace=True replaces it")
        partial = target.with_name(f".wirepack-{os.getpid()}.tmp")
        lock = _wirepack._ResultLock(target)  # OSError where a run writes it
        try:
            shutil.copyfile(self.path, partial)
            os.replace(partial, target)
        except OSError as error:
            raise OSError(error.errno, error.strerror, str(target)) from None
        finally:
            partial.unlink(missing_ok=True)
            del lock
