# SPDX-License-Identifier: GPL-3.0-or-later
"""What is written is read by others, and is what was written."""

import os
import shutil
import subprocess

import numpy as np

from tool import Skipped, module, places, read_json, read_ply, same

ENDINGS = ("ply", "obj", "off", "stl", "glb")


def mesh_files(tool):
    """One mesh in every format, with its points and faces as our PLY has them."""
    cloud = tool.folder / "coloured.ply"
    if not cloud.exists():
        write_coloured(tool, cloud)
        for ending in ENDINGS:
            tool("reconstruct", cloud, "-o", tool.folder / f"mesh.{ending}")
    points = read_ply(tool.folder / "mesh.ply")
    return points, faces_of(tool.folder / "mesh.ply", points)


def write_coloured(tool, path):
    sample = tool.folder / "plain.ply"
    tool("sample", "hemisphere-cap", "-n", 900, "-o", sample)
    place = places(read_ply(sample))
    colours = (np.arange(3 * len(place)).reshape(-1, 3) * 7 % 256).astype(np.uint8)
    lines = [f"{x!r} {y!r} {z!r} {r} {g} {b}" for (x, y, z), (r, g, b) in zip(place.tolist(), colours.tolist())]
    kinds = [("double", n) for n in "xyz"] + [("uchar", n) for n in ("red", "green", "blue")]
    head = ["ply", "format ascii 1.0", f"element vertex {len(place)}"]
    path.write_text("\n".join(head + [f"property {k} {n}" for k, n in kinds] + ["end_header"] + lines) + "\n")


def faces_of(path, points):
    data = path.read_bytes().split(b"end_header\n", 1)[1][points.nbytes:]
    faces = np.frombuffer(data, np.dtype([("n", "u1"), ("ids", "<i4", 3)]))
    assert (faces["n"] == 3).all()
    return faces["ids"]


def corners(points, faces):
    return np.sort(np.round(points[faces], 5).reshape(-1, 9), axis=0)


def close_to(vertices, faces, points, expected, what):
    """The same triangles in space, whatever the order and numbers of the vertices."""
    assert len(faces) == len(expected), f"{what}: {len(faces)} faces for {len(expected)}"
    difference = np.abs(corners(np.asarray(vertices), np.asarray(faces)) - corners(places(points), expected)).max()
    assert difference < 2e-5, f"{what}: corners differ by {difference}"


def check_trimesh(tool):
    """trimesh reads PLY, OBJ, OFF, STL and GLB."""
    trimesh = module("trimesh")
    points, faces = mesh_files(tool)
    coloured = []
    for ending in ENDINGS:
        mesh = trimesh.load(tool.folder / f"mesh.{ending}", force="mesh", process=False)
        close_to(mesh.vertices, mesh.faces, points, faces, ending)
        colours = mesh.vertex_attributes.get("color")  # where there is a texture's place, too
        if colours is not None:
            channel = np.asarray(colours)[:, 0]
            same(np.round(255 * channel if channel.dtype.kind == "f" else channel).astype("u1"), points["red"], ending)
            coloured.append(ending)
    assert coloured[:2] == ["ply", "obj"], coloured


def check_open3d(tool):
    """Open3D reads PLY, OBJ, OFF, STL and GLB, and points."""
    module("open3d")
    import open3d
    points, faces = mesh_files(tool)
    for ending in ENDINGS:
        mesh = open3d.io.read_triangle_mesh(str(tool.folder / f"mesh.{ending}"))
        if ending == "glb":  # Open3D leaves the node's translation out
            assert len(mesh.triangles) == len(faces)
            continue
        close_to(mesh.vertices, mesh.triangles, points, faces, ending)
        if ending == "ply":
            same(np.round(np.asarray(mesh.vertex_colors)[:, 1] * 255).astype("u1"), points["green"], "green")
    cloud = open3d.io.read_point_cloud(str(tool.folder / "mesh.ply"))
    same(np.asarray(cloud.points), places(points).astype(float), "points")


def check_meshio(tool):
    """meshio reads PLY, OBJ, OFF and STL."""
    meshio = module("meshio")
    points, faces = mesh_files(tool)
    for ending in ("ply", "obj", "off", "stl"):
        mesh = meshio.read(tool.folder / f"mesh.{ending}")
        close_to(mesh.points[:, :3], mesh.cells_dict["triangle"], points, faces, ending)


def check_pcl(tool):
    """The Point Cloud Library reads PLY and OBJ."""
    if shutil.which("pcl_ply2pcd") is None:
        raise Skipped("pcl_ply2pcd is not here (Debian's pcl-tools)")
    points, _ = mesh_files(tool)
    for program, ending in (("pcl_ply2pcd", "ply"), ("pcl_obj2pcd", "obj")):
        out = tool.folder / "pcl.pcd"
        out.unlink(missing_ok=True)
        done = subprocess.run([program, tool.folder / f"mesh.{ending}", out], capture_output=True, text=True)
        assert out.exists(), f"{program}: {done.stdout} {done.stderr}"
        found = places(tool.points(out))
        assert np.abs(found - places(points)).max() < 1e-6, ending


def check_gltf(tool):
    """Khronos' glTF validator finds no error and no warning in GLB, with a texture and vertices split along seams, too."""
    modules = os.environ.get("RIMLINE_NODE_MODULES", "")
    if shutil.which("node") is None or not os.path.isdir(os.path.join(modules, "gltf-validator")):
        raise Skipped("node or the npm package gltf-validator can not be had")
    mesh_files(tool)
    script = ("const v = require('gltf-validator'), fs = require('fs');"
              "v.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1]))).then(r => {"
              "console.log(JSON.stringify(r.issues)); process.exit(r.issues.numErrors + r.issues.numWarnings)})")
    ball, coloured, textured = (tool.folder / name for name in ("ball.ply", "ball.csv", "ball.glb"))
    tool("sample", "closed-sphere", "-n", 900, "-o", ball)
    points = places(read_ply(ball))
    np.savetxt(coloured, np.hstack([points, np.round(127 * (points + 1))]), delimiter=",", header="x,y,z,red,green,blue", comments="")
    tool("reconstruct", coloured, "-o", textured, "--domain", "free", "--texture-size", 128)
    for glb in (tool.folder / "mesh.glb", textured):
        done = subprocess.run(["node", "-e", script, str(glb)], capture_output=True, text=True,
                              env={**os.environ, "NODE_PATH": modules})
        assert done.returncode == 0, f"{glb.name}: {done.stdout}{done.stderr}"


def loop_files(tool):
    cloud = tool.folder / "square-with-holes.ply"
    if not cloud.exists():
        tool("sample", "square-with-holes", "-n", 900, "-o", cloud)
        for ending in ("json", "geojson", "wkt", "dxf", "csv", "ply", "obj"):
            tool("boundary", cloud, "--loops", tool.folder / f"loops.{ending}")
    points = places(read_ply(cloud))
    loops = [points[loop["points"]] for loop in read_json(tool.folder / "loops.json")["loops"]]
    assert len(loops) >= 2
    return loops


def check_shapely(tool):
    """shapely reads GeoJSON and WKT, as closed and simple rings."""
    module("shapely")
    import shapely.geometry
    import shapely.wkt
    loops = loop_files(tool)
    geojson = [shapely.geometry.shape(f["geometry"]) for f in read_json(tool.folder / "loops.geojson")["features"]]
    wkt = [shapely.wkt.loads(line) for line in (tool.folder / "loops.wkt").read_text().splitlines()]
    for lines in (geojson, wkt):
        assert len(lines) == len(loops)
        for line, loop in zip(lines, loops):
            assert line.is_closed and line.is_simple and line.has_z
            same(np.asarray(line.coords)[:-1], loop, "ring")


def check_ezdxf(tool):
    """ezdxf reads DXF without an error, as closed polylines in space."""
    module("ezdxf")
    import ezdxf
    loops = loop_files(tool)
    drawing = ezdxf.readfile(tool.folder / "loops.dxf")
    assert not drawing.audit().errors
    lines = list(drawing.modelspace().query("POLYLINE"))
    assert len(lines) == len(loops)
    for line, loop in zip(lines, loops):
        assert line.is_closed and line.is_3d_polyline and line.dxf.layer in ("OUTER", "HOLE")
        same(np.array([list(v.dxf.location) for v in line.vertices]), loop, "polyline")




CHECKS = [check_trimesh, check_open3d, check_meshio, check_pcl, check_gltf, check_shapely, check_ezdxf]
