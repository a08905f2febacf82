"""The command's defaults are the library's: each option that prints one in its help is compared with the options that
the library initialises, or is named here as the command's own.

  defaults_test.py MIEN LIBRARY PYTHON_PACKAGE_FOLDER
"""
import ctypes
import functools
import importlib.util
import re
import subprocess
import sys
import unittest

MIEN, LIBRARY, PACKAGE = sys.argv[1:4]
described = importlib.util.spec_from_file_location("abi", PACKAGE + "/mien/abi.py")
abi = importlib.util.module_from_spec(described)
described.loader.exec_module(abi)
library = ctypes.CDLL(LIBRARY)
KERNELS = {"none": 0, "euclidean-se": 1, "geodesic-se": 2, "bspline": 3, "surface-matern": 4}
HEAT = {"neumann": 1, "dirichlet": 2, "average": 3}
FITS = {"mixture": 0, "map": 1, "exact": 2, "alternating": 3}
# What its own caller gives or leaves out: nothing of the kind is an option of the library, or the command passes it on only
# when it was given.
OWN = None

# Per command and option: the field of the library's options that must hold the same, and what the command's words stand for.
# Names of the form function:value are what a function of the library does for 0.
EVERYWHERE = {"--threads": "mien_session_options.num_threads"}
REGISTER = {
    "--landmark-sigma": "mien_register_options.landmark_sigma_mm",
    "--weights": ("mien_register_options.skin_weights", {"none": 0, "skin": 1}),
    "--growth": ("mien_register_options.growth", {"constant": 0, "linear": 1, "exponential": 2, "cubic": 3}),
    "--units": ("mien_register_options.units", {"detect": 0, "refuse": 1}),
    "--start": ("mien_register_options.start", {"automatic": 0, "landmarks": 1, "search": 3}),
    "--max-modes": "mien_register_options.max_scalar_modes", "--max-pca-modes": "mien_register_options.max_pca_modes",
    "--iterations": "mien_register_options.iterations", "--max-distance": "mien_register_options.max_distance_mm",
    "--mutual": "mien_register_options.mutual_mm", "--soft": "mien_register_options.soft_mm", "--max-angle": OWN}
TABLE = {
    "model build": {
        "--kernel": ("mien_model_options.kernel", KERNELS), "--sigma": "mien_model_options.sigma_mm",
        "--scale": "mien_model_options.scale_mm", "--nu": "mien_model_options.nu", "--levels": "mien_model_options.levels",
        "--modes": "mien_model_options.num_modes", "--tolerance": "mien_model_options.tolerance",
        "--control-points": "mien_model_options.num_control_points",
        "--mirror-correlation": "mien_model_options.mirror_correlation",
        "--boundary": ("mien_model_options.heat_boundary", HEAT), "--pca-modes": "mien_model_options.pca_modes",
        "--pca-variance": "mien_model_options.pca_variance", "--seed": OWN},
    "model tune": {
        "--kernel": ("mien_tune_options.kernel", KERNELS), "--scale": "mien_tune_options.scale_mm", "--nu": "mien_tune_options.nu",
        "--levels": "mien_tune_options.levels", "--modes": "mien_tune_options.num_modes", "--rho": "mien_tune_options.rho",
        "--subjects": "mien_tune_options.max_subjects"},
    "register": REGISTER, "batch": REGISTER,
    "transfer": {"--what": OWN, "--max-distance": 0.0},  # 0 is the library's own limit
    "train": {
        "--method": ("mien_train_options.method", {"jpca": 0, "qojpca": 1}),
        "--identity-modes": "mien_train_options.identity_modes", "--expression-modes": "mien_train_options.expression_modes",
        "--lambda": ("mien_train_options.lambda", {"auto": 0}), "--shard-rank": "mien_shard_options.max_rank"},
    "neutralize": {
        "--fit": ("mien_neutralize_options.method", FITS), "--sweeps": "mien_neutralize_options.max_sweeps",
        "--pose": ("mien_neutralize_options.pose", {"auto": 0, "keep": 1, "rigid": 2}),
        "--margin": "mien_neutralize_options.treated_margin_mm", "--max-distance": 0.0},
    "evaluate neutralization": {
        "--fit": ("mien_evaluate_options.method", FITS), "--sweeps": "mien_evaluate_options.max_sweeps",
        "--against-fit": ("mien_evaluate_options.against_method", FITS),
        "--against-sweeps": "mien_evaluate_options.against_max_sweeps"},
    "measure volume": {
        "--correlation": "mien_measure_options.correlation_length_mm", "--bias": "mien_measure_options.common_bias_mm",
        "--limit-of-detection": "mien_measure_options.limit_of_detection_ml",
        "--max-distance": "mien_measure_options.max_distance_mm", "--sd-before": OWN, "--sd-after": OWN, "--direction": OWN},
    "measure distance": {"--max-distance": "mien_measure_options.max_distance_mm"},
    "measure curvature": {"--radius": OWN, "--what": OWN},
    "measure anthropometry": {"--sd": OWN},
    "measure asymmetry": {"--sd": OWN, "--plane": ("mien_asymmetry_options.plane", {"surface": 0, "landmarks": 1})},
    "measure geodesic": {
        "--boundary": ("mien_geodesic_options.heat_boundary", HEAT), "--time-factor": "mien_geodesic_options.heat_time_factor"},
    "score train": {
        "--method": ("mien_score_options.method", {"nipals": 0, "simpls": 1}),
        "--components": "mien_score_options.num_components", "--max-components": "mien_score_options.max_components",
        "--folds": "mien_score_options.folds", "--curvature": "mien_score_options.curvature_share",
        "--features": ("mien_score_options.features", {"basic": 0, "all": 1}),
        "--curvature-radius": "mien_score_options.curvature_radius_mm", "--range": OWN,
        "--seed": ("mien_score_options.seed", {"0": 1})},  # the command's seeds begin at 0, the library's at 1
    "report": {
        "--sd": OWN, "--margin": "mien_study_options.margin_mm", "--correlation": "mien_study_options.correlation_length_mm",
        "--bias": "mien_study_options.common_bias_mm", "--expression-share": "mien_study_options.untrained_share",
        "--language": OWN},
    "spectral basis": {
        "--modes": "mien_spectral_basis_options.mode_count",
        "--mass": ("mien_spectral_basis_options.mass", {"voronoi": 0, "barycentric": 1, "none": 2}),
        "--cotangents": ("mien_spectral_basis_options.cotangents", {"delaunay": 0, "clamp": 1, "keep": 2})},
    "network sample": {"--seed": OWN, "--number": OWN, "--spread": OWN},
    "model sample": {"--count": OWN, "--strength": OWN, "--mode": OWN, "--sigma": OWN, "--format": OWN, "--seed": OWN},
    "model fit": {"--ridge": "mien_model_fit_options.ridge_mm2", "--scalar-modes": "mien_model_fit_options.scalar_modes",
                  "--trained-modes": "mien_model_fit_options.vector_modes"},
    "model condition": {"--noise": OWN},
    "mesh clean": {"--min-triangles": OWN}, "mesh scale": {"--factor": OWN}, "mesh turn": {"--rotate": OWN},
    "mesh decimate": {"--vertices": OWN, "--share": OWN},
    "expression sample": {"--seed": OWN, "--count": OWN, "--format": OWN},
    "expression synthesize": {"--identity": OWN, "--expression": OWN},
    "render": {"--min": OWN, "--max": OWN, "--size": OWN},
    "score agreement": {"--grade-count": OWN},
    "spectral split": {"--k": OWN}, "spectral merge": {"--k": OWN}, "spectral features": {"--kind": OWN},
    "spectral hierarchy": {"--sampling": OWN, "--levels": OWN, "--factor": OWN, "--stride": OWN, "--radius": OWN, "--level": OWN,
                           "--direction": OWN},
    "spectral coefficients": {"--modes": OWN}, "spectral synthesize": {"--first": OWN},
    "transfer-expression": {"--ridge": "mien_blendshape_options.ridge", "--k": OWN, "--candidates": OWN},
}


@functools.lru_cache(None)
def help_of(*command):
    return subprocess.run([MIEN, *command, "--help"], capture_output=True, text=True, check=True).stdout


def commands(*above):
    """All commands that have no commands below them."""
    text = help_of(*above)
    names = []
    if re.search(r"\bSUBCOMMAND\b", text):
        heading = ""
        for line in text.splitlines():
            if line and not line.startswith(" "):
                heading = line
            elif heading not in ("Options:", "Positionals:") and re.match(r"  [a-z][a-z0-9-]+(  |$)", line):
                names.append(line.split()[0])
    if not names:
        return [above]
    return [command for name in names for command in commands(*above, name)]


def printed_defaults(command):
    """{option: default} of what the help prints as NAME TYPE=DEFAULT; numeric options without one map to None."""
    found = {}
    for line in help_of(*command).splitlines():
        spec = re.split(r"\s{2,}", line.strip())[0]
        option = re.match(r"(?:-\w,)?(--[a-z0-9-]+)(?:,\S+)? (TEXT|FLOAT|INT|UINT)", spec)
        if not line.startswith("  -") or not option:
            continue
        spec = spec.split(" Needs:")[0]  # of options that are about another one
        default = spec.rpartition("=")[2] if "=" in spec else None
        if default is not None or (option[2] != "TEXT" and "REQUIRED" not in spec):
            found[option[1]] = default
    return found


def number_of(text, words):
    return float(words[text]) if words else float(text)


def library_default(place):
    struct, field = place.split(".")
    options = getattr(abi, "".join(part.title() for part in struct.split("_")[1:]))()
    getattr(library, struct + "_init")(ctypes.byref(options), ctypes.c_size_t(ctypes.sizeof(options)))
    return float(getattr(options, field))


class Defaults(unittest.TestCase):
    def test_every_default_is_the_librarys_or_named_as_the_commands_own(self):
        compared = 0
        for command in commands():
            name = " ".join(command)
            for option, default in printed_defaults(command).items():
                with self.subTest(command=name, option=option):
                    place = {**EVERYWHERE, **TABLE.get(name, {})}.get(option, "unnamed")
                    if default is None and place == "unnamed":
                        continue  # nothing when it is not given
                    self.assertNotEqual(place, "unnamed", "which option of the library is this the default of? Say so in TABLE")
                    if place is OWN:
                        continue
                    self.assertIsNotNone(default, "the help must print the default: capture_default_str()")
                    if isinstance(place, float):
                        self.assertEqual(float(default), place)
                    else:
                        place, words = place if isinstance(place, tuple) else (place, None)
                        self.assertEqual(number_of(default, words), library_default(place), place)
                    compared += 1
        self.assertGreater(compared, 80)

    def test_every_named_option_is_there(self):
        for name, options in TABLE.items():
            there = help_of(*name.split())
            for option in options:
                with self.subTest(command=name, option=option):
                    self.assertIn(option + " ", there)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
