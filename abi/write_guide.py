"""docs/guides/functions.md: every public function by task, from the headers' own words."""
import re

# Headers in the order of the work, each with the task that it serves.
TASKS = (("session.h", "Start, limit, cancel"), ("error.h", "Errors and versions"), ("mesh.h", "Meshes in and out"),
         ("geodesic.h", "Distances along the skin"),
         ("mesh_tools.h", "Look at meshes and mend them"), ("landmarks.h", "Landmarks and zones"),
         ("template_check.h", "Check a template"), ("model.h", "Deformation models"),
         ("model_fit.h", "Coefficients of faces in a deformation model"), ("registration.h", "Fit a template to a scan"),
         ("batch.h", "Fit a scan often, or many scans at a time"), ("follow.h", "Follow a moving face"),
         ("dataset.h", "Collect faces for training"), ("training.h", "Train expression models"),
         ("expression.h", "Expression models"), ("neutralization.h", "Take the expression off"),
         ("study.h", "Compare a person's visits"), ("measure.h", "Volumes, areas, distances"),
         ("anthropometry.h", "Anthropometry"), ("asymmetry.h", "Left against right"), ("score.h", "Scores, raters, repeatability"),
         ("evaluation.h", "Judge an expression model"), ("blendshapes.h", "Carry expressions over"),
         ("representation.h", "Faces as numbers for learning"), ("spectral.h", "Frequency bands and metrics"),
         ("hierarchy.h", "Coarser levels of a template"), ("network.h", "Trained networks"),
         ("visits.h", "Visits, the older way (deprecated: use the study)"),
         ("series.h", "Series, the older way (deprecated: use the study)"))
HEAD = """# Functions by task

Written by `abi/generate_bindings.py` from the headers; each function's parameters, errors and ownership stand in the reference. What has
`retain` or `release` in its name keeps an object or gives it back; `init` writes an options struct's defaults.
"""


def brief(function):
    """The first sentence of the comment, safe in a table."""
    text = re.split(r"(?<=[.)]) (?=[A-Z])", " ".join(function.purpose.split()))[0].rstrip(".")
    return re.sub(r"([|*<>_])", r"\\\1", text)


def page(interface):
    left = {f.header for f in interface.functions} - {header for header, _ in TASKS}
    if left:
        raise SystemExit(f"abi/write_guide.py: name the task of {', '.join(sorted(left))} in TASKS")
    lines = [HEAD]
    for header, task in TASKS:
        rows = [f for f in interface.functions if f.header == header]
        if rows:
            lines += [f"## {task}", "", f"`mien/{header}`", "", "| function | what it does |", "|---|---|"]
            lines += [f"| `{f.name}()` | {brief(f)} |" for f in rows] + [""]
    return "\n".join(lines)
