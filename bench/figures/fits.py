# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""How well shapes fit their links: what they miss, how far they stick out, their volumes against a
long search, the time it takes, and published models of the same links. docs/fitting.md explains the
figures."""
import argparse
import csv
import pathlib
import statistics
import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree

from figure import Figures, shared_data, shared_robots, stay_on_one_core
from fits_models import MODELS, WITHOUT_MESHES, read_links, write_urdf

PROGRAM = ("rosrun", "collision_monitor", "collision_monitor_fits_figures")
# [mm] Limits of the maximum overshoot of one shape on each link of panda_moveit.
PANDA_SINGLE = {
    "panda_link0": 106, "panda_link1": 31, "panda_link2": 31, "panda_link3": 41,
    "panda_link4": 39, "panda_link5": 38, "panda_link6": 60, "panda_link7": 29, "panda_hand": 26,
    "panda_leftfinger": 10, "panda_rightfinger": 10}
LARGE_MESH = 40000  # triangles
SMALL_MESH = 1500  # triangles of meshes that are measured by brute force
ENCLOSES = 1.0  # [mm] a published model that misses no more than this counts as enclosing


class Robots:
    """URDFs of the shared data as the program takes them."""

    def __init__(self, wanted, scratch):
        self.wanted = wanted
        self.arguments = {}  # by label: URDF, folder of relative names, folder of package://
        for label, folder, urdf, _, missing in shared_robots():
            directory = str(urdf.parent)
            if missing:
                urdf = without(urdf, missing, scratch / (label + ".urdf"))
            if not wanted or wanted in label:
                self.arguments[label] = [str(urdf), directory, str(folder)]

    def tables(self, command, *options):
        """(label, row) of a table of every robot."""
        for label, arguments in self.arguments.items():
            for row in table(command, *arguments, *options):
                yield label, row


def without(urdf, missing, file):
    """The URDF without the elements whose meshes are not in the shared data."""
    tree = ElementTree.parse(urdf)
    for link in tree.getroot().findall("link"):
        for collision in link.findall("collision"):
            mesh = collision.find("geometry/mesh")
            if mesh is not None and mesh.get("filename") in missing:
                link.remove(collision)
    tree.write(file)
    return file


def table(*arguments):
    """The rows that the program prints, each a dict."""
    run = subprocess.run([*PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                         check=False)
    if run.returncode != 0:
        raise SystemExit(run.stderr.strip())
    return list(csv.DictReader(run.stdout.splitlines(), delimiter="\t"))


def enclosure(robots, figures):
    rows = list(robots.tables("links"))
    for shapes in (1, 8):
        for name, all_of in (("outside", "vertices"), ("points_outside", "points")):
            outside = sum(int(row[f"{name}_{shapes}"]) for _, row in rows)
            count = sum(int(row[all_of]) for _, row in rows)
            what = "vertices" if name == "outside" else "points of surfaces"
            figures.add(f"{what} outside, {shapes} a link", outside, f"of {count}", "0",
                        outside == 0)
    widening = 1e-3 * max(float(row[f"widening_{n}"]) for _, row in rows for n in (1, 8))
    figures.add("widening at padding 0", f"{widening:.1e} m", "-", "< 1e-9 m", widening < 1e-9)
    panda = {row["link"]: row for label, row in rows if label == "panda_moveit"}
    for link, most in PANDA_SINGLE.items():
        if link in panda:
            ours = float(panda[link]["overshoot_1"])
            figures.add(f"{link}: overshoot of one shape", f"{ours:.1f} mm", f"{most} mm",
                        "no worse", round(ours) <= most)
    if panda:
        worst = max(float(row["overshoot_8"]) for row in panda.values())
        figures.add("panda_moveit: worst overshoot, 8 a link", f"{worst:.1f} mm", "-", "< 40 mm",
                    worst < 40.0)
    if not robots.wanted:  # some of the robots have other medians than all
        meshes = [row for row in rows if int(row[1]["meshes"]) > 0]
        for what, some in (("links", rows), ("links with meshes", meshes)):
            one, eight = medians(some)
            figures.add(f"all {len(some)} {what}: median overshoot, 8", f"{eight:.1f} mm",
                        f"{one:.1f} mm of one", "<= half and < 12 mm",
                        eight <= 0.5 * one and eight < 12.0)


def medians(rows):
    return [statistics.median(float(row[f"overshoot_{n}"]) for _, row in rows) for n in (1, 8)]


def brute(robots, figures):
    """The reported overshoot of fits against other samples and brute force."""
    table_rows = list(robots.tables("brute", SMALL_MESH))
    for shapes in (1, 8):
        rows = [[float(row[name]) for name in ("ours", "brute", "spacing")]
                for _, row in table_rows if int(row["max_shapes"]) == shapes]
        if rows:
            ours, other, spacing = max(
                rows, key=lambda row: (row[1] - row[0]) / max(row[2], 1e-3))
            figures.add(f"overshoot by brute force, {shapes} a link, {len(rows)} fits",
                        f"{ours:.1f} mm", f"{other:.1f} mm",
                        f"no more than a spacing ({spacing:.1f} mm) larger",
                        other <= ours + spacing)


def volumes(robots, starts, figures):
    rows = [row for _, row in robots.tables("ratios", starts) if row["box"] != "nan"]
    for kind in ("capsule", "box"):
        worst = max((float(row[kind]) for row in rows), default=0.0)
        figures.add(f"{kind}: volume over {starts} starts', {len(rows)} meshes", f"{worst:.4f}", "1",
                    "<= 1.01", worst <= 1.01)
    worst = max((float(row["rounded_over_others"]) for row in rows), default=0.0)
    figures.add("rounded box: volume over the least other's", f"{worst:.6f}", "1", "<= 1",
                worst <= 1.0 + 1e-9)


def times(robots, figures):
    stay_on_one_core()
    rows = [("", row) for row in table("times", "-", "", "", 0)]
    rows += robots.tables("times", LARGE_MESH)
    for label, row in rows:
        name = f"{label}/{row['mesh']}" if label else row["mesh"]
        for what in ("fit", "sphere_tree", "inner_shapes"):
            if what == "inner_shapes" and row["has_inside"] == "0":
                continue
            figures.add(f"{name}: {what.replace('_', ' ')}", f"{float(row[what]):.0f} ms",
                        f"{row['triangles']} tris", "< 100 ms", float(row[what]) < 100.0)
    if "stretch" in robots.arguments:
        row = table("load", *robots.arguments["stretch"])[0]
        seconds = 1e-3 * float(row["time"])
        figures.add("stretch: read and fitted, no cache", f"{seconds:.2f} s",
                    f"{row['shapes']} shapes", "< 3 s", seconds < 3.0)


def published(robots, with_table, scratch, figures):
    for model, (file, robot) in MODELS.items():
        if robot not in robots.arguments:
            continue
        urdf = scratch / "model.urdf"
        write_urdf(read_links(shared_data() / "reference_models" / file), urdf)
        rows = [{key: value if key == "link" else float(value) for key, value in row.items()}
                for row in table("published", *robots.arguments[robot], urdf)]
        enclosing = [row for row in rows if row["miss_points"] <= ENCLOSES]
        for name, some in (("where it encloses", enclosing), ("grown to hold vertices", rows)):
            tighter = sum(row["ours_max"] <= row["grown_max"] for row in some)
            means = sum(row["ours_mean"] <= row["grown_mean"] for row in some)
            if some:
                figures.add(f"{model}, {name}", f"{tighter} of {len(some)}",
                            f"mean {means} of {len(some)}", "ours tighter in all",
                            tighter == len(some))
        if with_table:
            print_table(rows)
    if with_table:
        print("published without meshes here: " + "; ".join(WITHOUT_MESHES))


def print_table(rows):
    print("| link | shapes | ours | vertices, surface outside | max, mean | grown | ours |")
    print("|---|---|---|---|---|---|---|")
    for row in rows:
        print(f"| {row['link']} | {row['shapes']:.0f} | {row['ours_shapes']:.0f} "
              f"| {row['miss_vertices']:.1f}, {row['miss_points']:.1f} "
              f"| {row['max']:.1f}, {row['mean']:.1f} "
              f"| {row['grown_max']:.1f}, {row['grown_mean']:.1f} "
              f"| {row['ours_max']:.1f}, {row['ours_mean']:.1f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", choices=("enclosure", "brute", "volumes", "times", "published"),
                        help="a part of the figures; else all")
    parser.add_argument("--robot", default="", help="only robots whose name holds this")
    parser.add_argument("--starts", type=int, default=300, help="of the long search for volumes")
    parser.add_argument("--table", action="store_true",
                        help="each link of each published model, in millimetres")
    arguments = parser.parse_args()
    figures = Figures()
    with tempfile.TemporaryDirectory() as folder:
        scratch = pathlib.Path(folder)
        robots = Robots(arguments.robot, scratch)
        parts = {
            "enclosure": lambda: enclosure(robots, figures),
            "brute": lambda: brute(robots, figures),
            "volumes": lambda: volumes(robots, arguments.starts, figures),
            "published": lambda: published(robots, arguments.table, scratch, figures),
            "times": lambda: times(robots, figures)}
        for name, measure in parts.items():
            if arguments.only in (None, name):
                measure()
    figures.finish()


if __name__ == "__main__":
    main()
