"""Mesh. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Mesh(_Object):
    """A triangle mesh or point cloud, checked: finite coordinates, indices in range. Millimetres. Immutable: share
    freely between threads.
    """
    _release = "mien_mesh_release"
    _retain = "mien_mesh_retain"

    def share(self) -> Mesh:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def create(session: Session, arrays: MeshArrays) -> Mesh:
        """Makes a mesh from the host's arrays, which are copied.
        arrays: see the fields for shapes and units.
        Fails with MIEN_E_INVALID_ARGUMENT (null, misaligned, stride, dtype), MIEN_E_INVALID_MESH (no vertex,
        value not finite, index out of range), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_mesh_create()
        """
        return _run("mien_mesh_create", {"session": session, "arrays": arrays})[0]

    @staticmethod
    def load(session: Session, path: Text) -> Mesh:
        """Reads a mesh file: see mien_mesh_format_extension(). What the file holds tells its format, its name only
        where that leaves it open. Polygons become triangle fans; colours, texture coordinates, materials and images
        (of this file and beside it) are kept. Points that are not numbers and part of no triangle are dropped, with
        a warning in the session's log. The file is treated as hostile.
        Fails with MIEN_E_IO, MIEN_E_INVALID_ARGUMENT (unknown extension), MIEN_E_BAD_FORMAT,
        MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_mesh_load()
        """
        return _run("mien_mesh_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a mesh file by extension: see mien_mesh_format_writes(). Coordinates are float32 or nine digits where
        that steps by at most 0.001 mm, else double; STL, which cannot, is refused then. Materials and images are
        written beside OBJ and PLY files and into GLB files, each image's bytes as they were read. Atomic: a full
        disk or a crash leaves an old file whole.
        Fails with MIEN_E_IO, MIEN_E_INVALID_ARGUMENT (unknown extension, a format that is read only),
        MIEN_E_INVALID_MESH (STL far from the origin), MIEN_E_UNSUPPORTED_OPTION (pixels, in a build without
        image coders), MIEN_E_NO_MEMORY.
        C: mien_mesh_save()
        """
        _run("mien_mesh_save", {"session": session, "path": path, "mesh": self})

    def counts(self) -> MeshCounts:
        """Numbers of vertices and triangles.
        vertex_count: may be left out; #V.
        triangle_count: may be left out; #F.
        C: mien_mesh_get_counts()
        """
        return MeshCounts(*_run("mien_mesh_get_counts", {"mesh": self}))

    def positions(self, dtype: DTypeLike = numpy.float64) -> numpy.ndarray:
        """Copies the positions, #V x 3 tightly packed, mm. With dst null and capacity 0: writes the count only.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_get_positions()
        """
        return _run("mien_mesh_get_positions", {"mesh": self}, dtype=dtype)[0]

    def triangles(self) -> numpy.ndarray:
        """Copies the triangles, #F x 3 uint32 tightly packed.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_get_triangles()
        """
        return _run("mien_mesh_get_triangles", {"mesh": self})[0]

    def colors(self) -> numpy.ndarray:
        """Copies the vertex colours, #V x 3 uint8; the count is 0 when the mesh has none.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_get_colors()
        """
        return _run("mien_mesh_get_colors", {"mesh": self})[0]

    @staticmethod
    def format_count() -> int:
        """The number of mesh formats, counted by file extension.
        C: mien_mesh_format_count()
        """
        return _run("mien_mesh_format_count", {})

    @staticmethod
    def format_extension(format: int) -> str:
        """The extension of a mesh format: lower case, without its dot, e.g. "ply".
        format: 0 to mien_mesh_format_count() - 1; null is returned for others.
        C: mien_mesh_format_extension()
        """
        return _run("mien_mesh_format_extension", {"format": format})

    @staticmethod
    def format_description(format: int) -> str:
        """What a mesh format is called, for people, e.g. "Stanford PLY".
        format: 0 to mien_mesh_format_count() - 1; null is returned for others.
        C: mien_mesh_format_description()
        """
        return _run("mien_mesh_format_description", {"format": format})

    @staticmethod
    def format_writes(format: int) -> int:
        """1 for a format that mien_mesh_save() writes, 0 for one that is only read.
        format: 0 to mien_mesh_format_count() - 1; 0 is returned for others.
        C: mien_mesh_format_writes()
        """
        return _run("mien_mesh_format_writes", {"format": format})

    def texture(self) -> numpy.ndarray:
        """Copies the texture coordinates, #T x 2 float32: (0, 0) is the lower left corner of the image, (1, 1) the
        upper right. The count is 0 when the mesh has none.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_get_texture()
        """
        return _run("mien_mesh_get_texture", {"mesh": self})[0]

    def texture_triangles(self) -> numpy.ndarray:
        """Copies for each corner of each triangle the number of its texture coordinate, #F x 3 uint32. The count is 0
        when the mesh has none.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_get_texture_triangles()
        """
        return _run("mien_mesh_get_texture_triangles", {"mesh": self})[0]

    def triangle_materials(self) -> numpy.ndarray:
        """Copies the number of each triangle's material, #F uint32. The count is 0 when the mesh has no material, or a
        single one that all triangles have.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_get_triangle_materials()
        """
        return _run("mien_mesh_get_triangle_materials", {"mesh": self})[0]

    def material_counts(self) -> MeshMaterialCounts:
        """Numbers of materials and of images.
        material_count: may be left out.
        image_count: may be left out.
        C: mien_mesh_get_material_counts()
        """
        return MeshMaterialCounts(*_run("mien_mesh_get_material_counts", {"mesh": self}))

    def material(self, material: int) -> MeshMaterial:
        """A material: its base colour and the number of its base colour's image.
        material: 0 to the number of materials - 1.
        image: may be left out; -1: none.
        red: may be left out; 0 to 1.
        green: may be left out; 0 to 1.
        blue: may be left out; 0 to 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such material).
        C: mien_mesh_get_material()
        """
        return MeshMaterial(*_run("mien_mesh_get_material", {"material": material, "mesh": self}))

    def material_name(self, material: int) -> str:
        """Copies a material's name, UTF-8 with its terminating zero.
        material: 0 to the number of materials - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such material).
        C: mien_mesh_get_material_name()
        """
        return _run("mien_mesh_get_material_name", {"material": material, "mesh": self})[0]

    def image_name(self, image: int) -> str:
        """Copies an image's file name without a folder, UTF-8 with its terminating zero.
        image: 0 to the number of images - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image).
        C: mien_mesh_get_image_name()
        """
        return _run("mien_mesh_get_image_name", {"image": image, "mesh": self})[0]

    def image_file(self, image: int) -> numpy.ndarray:
        """Copies the bytes of an image's file as they were read. The count is 0 for pixels of a host's.
        image: 0 to the number of images - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image).
        C: mien_mesh_get_image_file()
        """
        return _run("mien_mesh_get_image_file", {"image": image, "mesh": self})[0]

    def image_size(self, image: int) -> MeshImageSize:
        """The width and height of an image in pixels, from its header.
        image: 0 to the number of images - 1.
        width: may be left out; pixels.
        height: may be left out; pixels.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image), MIEN_E_BAD_FORMAT (damaged),
        MIEN_E_UNSUPPORTED_OPTION (neither JPEG nor PNG, or above 134 million pixels).
        C: mien_mesh_get_image_size()
        """
        return MeshImageSize(*_run("mien_mesh_get_image_size", {"image": image, "mesh": self}))

    def image_pixels(self, session: Session, image: int, row_stride_bytes: int) -> numpy.ndarray:
        """Decodes an image into height rows of width x 3 red green blue bytes, from the top.
        image: 0 to the number of images - 1.
        row_stride_bytes: bytes from row to row of dst, at least 3 * width; 0: tightly packed.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image, stride below a row),
        MIEN_E_BAD_FORMAT (damaged), MIEN_E_UNSUPPORTED_OPTION (another kind, or a build without image
        decoders), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_mesh_get_image_pixels()
        """
        return _run("mien_mesh_get_image_pixels", {"session": session, "image": image, "row_stride_bytes": row_stride_bytes, "mesh": self})[0]

    def save_targets(self, session: Session, targets: Sequence[Mesh], names: Sequence[str], path: Text) -> None:
        """Writes a GLB file of a mesh and named changes of it (glTF's morph targets): an expression model's
        blendshapes in one file. Each target is the whole changed mesh, with the vertices of `mesh`.
        targets: target_count meshes, unless target_count is 0.
        names: target_count UTF-8 names, unless target_count is 0.
        path: ends with .glb.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (another extension), MIEN_E_MISMATCH (vertex
        counts), MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_mesh_save_targets()
        """
        _run("mien_mesh_save_targets", {"session": session, "targets": targets, "names": names, "path": path, "mesh": self})

    @staticmethod
    def load_target(session: Session, path: Text, name: Text) -> Mesh:
        """Reads a glTF file with one of its morph targets at full weight.
        path: .glb or .gltf.
        name: UTF-8 name of the target
        Fails with MIEN_E_NOT_FOUND (no such target; the message names some), otherwise as mien_mesh_load().
        C: mien_mesh_load_target()
        """
        return _run("mien_mesh_load_target", {"session": session, "path": path, "name": name})[0]

    def positions_view(self) -> numpy.ndarray:
        """The positions in place: *data points to #V x 3 float64, tightly packed, mm.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_mesh_positions_view()
        """
        return _run("mien_mesh_positions_view", {"mesh": self})[0]

    def inspect(self, session: Session) -> str:
        """What a mesh is and what is wrong with it, as JSON text: counts, box, extent and the units in which that is a
        face, a head or a body, pieces, borders, windings, doubled and unused parts, and "faults": a list of
        sentences that say what is wrong and what to do.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_mesh_inspect()
        """
        return _run("mien_mesh_inspect", {"session": session, "mesh": self})[0]

    def clean(self, session: Session, min_triangles: int) -> Mesh:
        """Merges vertices of equal coordinates, drops degenerate, doubled and unused parts and pieces of fewer than
        min_triangles triangles, and winds all triangles of a piece alike. Order and coordinates of what stays are
        kept.
        min_triangles: 0: all pieces stay.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_mesh_clean()
        """
        return _run("mien_mesh_clean", {"session": session, "min_triangles": min_triangles, "mesh": self})[0]

    def transform(self, session: Session, matrix: ArrayLike) -> Mesh:
        """Moves every vertex by a row-major 4 x 4 matrix: scales, turns, shifts. When it mirrors (negative
        determinant), the triangles are wound the other way, so that outside stays outside.
        matrix: 16 values, last row 0 0 0 1, invertible.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_mesh_transform()
        """
        return _run("mien_mesh_transform", {"session": session, "matrix": matrix, "mesh": self})[0]

    def turn_over(self, session: Session) -> Mesh:
        """Winds every triangle the other way: inside becomes outside.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_mesh_turn_over()
        """
        return _run("mien_mesh_turn_over", {"session": session, "mesh": self})[0]

    def decimate(self, session: Session, vertex_count: int) -> Mesh:
        """Collapses edges of least quadric error until vertex_count vertices are left or no collapse is legal. Every
        vertex that stays is one of the input with its place and colour; texture coordinates are dropped. Vertices
        in which fans of triangles merely touch are split first; triangles that fit into no manifold go.
        vertex_count: at least 4.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_mesh_decimate()
        """
        return _run("mien_mesh_decimate", {"session": session, "vertex_count": vertex_count, "mesh": self})[0]

    def check_same_unit(self, second: Mesh) -> None:
        """Fails when one of two meshes of the same face is so many times larger that they cannot be in one unit (7
        times; mm and cm differ by 10). The message names the unit that would explain it.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (not in one unit), MIEN_E_NO_MEMORY.
        C: mien_mesh_check_same_unit()
        """
        _run("mien_mesh_check_same_unit", {"second": second, "first": self})
