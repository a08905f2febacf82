"""ModelOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
from __future__ import annotations

import enum  # noqa: F401
from typing import TYPE_CHECKING, Callable, NamedTuple, Sequence  # noqa: F401

import numpy  # noqa: F401
from numpy.typing import ArrayLike, DTypeLike  # noqa: F401

from ..runtime import Object as _Object  # noqa: F401
from ..runtime import Options as _Options  # noqa: F401
from ..runtime import Progress, Text  # noqa: F401
from ..runtime import Record as _Record  # noqa: F401
from ..runtime import run as _run  # noqa: F401

if TYPE_CHECKING:
    from . import *  # noqa: F401,F403


class ModelOptions(_Options):
    """mien_model_options of the C interface."""
    _name = "mien_model_options"
    #: MIEN_KERNEL_..., default GEODESIC_SE
    kernel: KernelKind | int
    #: length scale; full width for BSPLINE; > 0, default 20
    sigma_mm: float
    #: standard deviation of a displacement's coordinate; > 0, default 3
    scale_mm: float
    #: smoothness of SURFACE_MATERN, 0.1 to 20, default 2
    nu: float
    #: 1 to 12, default 1: sum of kernels with sigma, 2 sigma, 4 sigma, ...
    levels: int
    #: deformation modes at most, 3 per scalar mode; >= 3, default 999
    num_modes: int
    #: kernel_count kernels added to the one above; may be left out
    kernels: Sequence[Kernel] | None
    #: > 0: stop once this share of the variance is left; default 0
    tolerance: float
    #: default 0: max(1000, num_modes), never more than #V
    num_control_points: int
    #: 1: modes purely even or odd about the plane x = 0; default 0
    mirror_symmetric: int
    #: 0 to 1: how much both sides are expected to move alike; default 0
    mirror_correlation: float
    #: eigenvalues among the control points below this share of the largest are dropped; 0 < x < 1, default
    #: 0.0001
    eigenvalue_threshold: float
    #: heat time in units of (mean edge)^2, 0.01 to 10000, default 4
    heat_time_factor: float
    #: MIEN_HEAT_..., default NEUMANN
    heat_boundary: Heat | int
    #: default 0: as many as pca_variance asks for
    pca_modes: int
    #: UTF-8 path of a dataset of registered faces, or null: adds their mean and principal modes; the kernel then
    #: stands for what they leave over: of three people or more, for what they leave of people left out (info
    #: pca_left_out_mm of the model's JSON)
    pca_dataset: Text | None
    #: share of the faces' variance kept, 0 to 1, default 0.999
    pca_variance: float
    #: 1 (default): all faces, 0: neutral ones
    pca_all_expressions: int
    #: 1: move each face rigidly onto the template first; default 0
    pca_align: int
    #: #V x 1 factors >= 0 of scale_mm; count 0: one everywhere
    scale_per_vertex: ArrayLike
    #: landmark_count; may be left out
    landmarks: Sequence[Landmark] | None
    #: zone_count; may be left out
    zones: Sequence[Zone] | None
