#!/usr/bin/env python3
"""The headers' parser: it understands what the headers say, in either wording, and refuses what is unclear.

  header_parser_test.py PROJECT_DIR
"""
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT = Path(sys.argv.pop(1))
sys.path.insert(0, str(PROJECT / "abi"))
from interface import as_data  # noqa: E402
from read_headers import HeaderError, read_interface  # noqa: E402

COMMENT = """/**
 * Does what is tested.
 *
 * @param session [in] not null.
{parameters} * @param error [out] may be null.
 * @errors {errors}
 * @owner  {owner}
 * @thread externally synchronized by session
 * @cancel no
 * @cost   O(1)
 * @since  0.2
 */
MIEN_API mien_status MIEN_CALL mien_tested(mien_session* session, {declared}, mien_error* error);
"""


class HeaderParser(unittest.TestCase):
    def read(self, declared, *parameters, errors="MIEN_E_IO", owner="nothing"):
        """The interface with one more function, and what is said about it."""
        with tempfile.TemporaryDirectory() as folder:
            include = Path(folder) / "mien"
            shutil.copytree(PROJECT / "include/mien", include)
            words = "".join(f" * @param {p}\n" for p in parameters)
            text = COMMENT.format(declared=declared, parameters=words, errors=errors, owner=owner)
            mesh = include / "mesh.h"
            mesh.write_text(mesh.read_text().replace("#ifdef __cplusplus\n}\n", text + "\n#ifdef __cplusplus\n}\n"))
            return read_interface(include, strict=False)

    def parameters(self, *arguments, **named):
        interface, problems = self.read(*arguments, **named)
        self.assertEqual(problems, [])
        function = next(f for f in interface.functions if f.name == "mien_tested")
        return {p.name: p for p in function.parameters}

    def refused(self, word, *arguments, **named):
        _, problems = self.read(*arguments, **named)
        self.assertTrue(any("mien_tested" in p and word in p for p in problems), problems)
        self.assertTrue(all("mesh.h:" in p for p in problems), "the place is missing: " + str(problems))

    def test_the_headers_are_clear(self):
        interface, problems = read_interface(PROJECT / "include/mien", strict=False)
        self.assertEqual(problems, [])
        self.assertGreater(len(interface.functions), 160)
        roles = {p.role for f in interface.functions for p in f.parameters}
        self.assertNotIn("", roles)

    def test_either_wording_of_nullability_means_the_same(self):
        for words in ("may be null: none", "null allowed", "of the person, or null"):
            self.assertTrue(self.parameters("const mien_mesh* face", f"face [in] {words}.")["face"].nullable, words)
        self.assertFalse(self.parameters("const mien_mesh* face", "face [in] not null.")["face"].nullable)

    def test_a_list_of_handles_is_an_input(self):
        made = self.parameters("const mien_mesh* const* faces, uint32_t face_count", "faces [in] not null; face_count faces.",
                               "face_count [in] 1 to 9.")
        self.assertEqual((made["faces"].role, made["faces"].count, made["face_count"].role), ("handles", ["face_count"], "count"))
        self.refused("[in]", "const mien_mesh* const* faces, uint32_t face_count", "faces [out] not null; face_count faces.",
                     "face_count [in] 1 to 9.")

    def test_unclear_nullability_is_refused(self):
        self.refused("not null", "const mien_mesh* face", "face [in] the face.")
        self.refused("one of", "const mien_mesh* face", "face [in] not null; may be null.")

    def test_an_array_without_a_count_is_refused(self):
        self.refused("how many", "const double* values, uint64_t value_count", "values [in] not null; some values.", "value_count [in] any.")
        made = self.parameters("const double* values, uint64_t value_count", "values [in] not null; value_count x 3 values.",
                               "value_count [in] any.")
        self.assertEqual(made["values"].count, ["value_count", 3])
        made = self.parameters("const double* values", "values [in,count=3] not null; a place.")
        self.assertEqual(made["values"].count, [3])

    def test_an_unknown_factor_of_a_count_is_refused(self):
        self.refused("how many", "const double* values, uint64_t row_count", "values [in] not null; row_count x c values.", "row_count [in] any.")

    def test_a_capacity_needs_its_array_and_count(self):
        self.refused("count", "double* dst, uint64_t capacity", "dst [out] room for capacity values, or null.", "capacity [in] values.")

    def test_ownership_names_the_release(self):
        self.refused("mien_mesh_release", "mien_mesh** out", "out [out] not null; the mesh.")
        self.parameters("mien_mesh** out", "out [out] not null; the mesh, or null on failure.",
                        owner="the caller releases *out with mien_mesh_release()")

    def test_unknown_statuses_fields_and_constants_are_refused(self):
        self.refused("MIEN_E_NONSENSE", "int32_t number", "number [in] any.", errors="MIEN_E_NONSENSE")
        self.refused("MIEN_NONSENSE", "int32_t number", "number [in] MIEN_NONSENSE_*.")
        self.refused("@returns", "int32_t number", "number [in] any.\n * @returns a number")

    def test_a_struct_field_is_held_to_the_same_rules(self):
        with tempfile.TemporaryDirectory() as folder:
            include = Path(folder) / "mien"
            shutil.copytree(PROJECT / "include/mien", include)
            mesh = include / "mesh.h"
            mesh.write_text(mesh.read_text().replace("/** A named set", "typedef struct mien_planted {\n    const double* values;\n"
                                                     "} mien_planted;\n\n/** A named set"))
            _, problems = read_interface(include, strict=False)
            self.assertTrue(any("mien_planted.values" in p and "null" in p for p in problems), problems)
            self.assertTrue(any("mien_planted.values" in p and "how many" in p for p in problems), problems)
            mesh.write_text(mesh.read_text().replace("const double* values;", "const double* (*values)(void);"))
            with self.assertRaises(HeaderError):
                read_interface(include)

    def test_a_comment_without_a_declaration_is_named_and_the_rest_read(self):
        with tempfile.TemporaryDirectory() as folder:
            include = Path(folder) / "mien"
            shutil.copytree(PROJECT / "include/mien", include)
            mesh = include / "mesh.h"
            mesh.write_text(mesh.read_text().replace("MIEN_API mien_mesh* MIEN_CALL mien_mesh_retain(const mien_mesh* mesh);", ""))
            interface, problems = read_interface(include, strict=False)
            self.assertNotIn("mien_mesh_retain", [f.name for f in interface.functions])
            self.assertTrue(any("mesh.h:" in p and "belongs to no declaration" in p for p in problems), problems)

    def test_the_data_say_what_a_binding_needs(self):
        data = as_data(read_interface(PROJECT / "include/mien"))
        register = next(f for f in data["functions"] if f["name"] == "mien_register")
        self.assertEqual(register["makes"], {"out": "mien_registration_release"})
        self.assertEqual(register["locks"], ["session"])
        self.assertTrue(register["cancel"])
        self.assertIn("MIEN_E_CANCELLED", register["statuses"])
        lent = next(f for f in data["functions"] if f["name"] == "mien_registration_mesh")
        self.assertEqual(lent["lends"], {"owner": "registration", "retain": "mien_mesh_retain"})


if __name__ == "__main__":
    unittest.main()
