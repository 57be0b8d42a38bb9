# SPDX-License-Identifier: GPL-3.0-or-later
"""Files written by others are read as they read them."""

import gzip
import struct

import numpy as np

from tool import Skipped, module, places, same

ORIGIN = np.array([500000.0, 5400000.0, 100.0])
SCALE = 0.001


def surface(tool):
    """Points of a sample, where maps put them."""
    path = tool.folder / "sample.ply"
    tool("sample", "half-tunnel", "-n", 1200, "-o", path)
    return places(tool.points(path)) * 10 + ORIGIN


def needs_scan_formats(tool):
    if "LAS" not in tool("boundary", "--help"):
        raise Skipped("the tool was built without RIMLINE_SCAN_FORMATS")


FLAGS = ("scan_direction_flag", "edge_of_flight_line", "synthetic", "key_point", "withheld", "overlap",
         "scanner_channel")


def make_las(laspy, points, point_format, version):
    random = np.random.default_rng(7)
    header = laspy.LasHeader(point_format=point_format, version=version)
    header.scales, header.offsets = [SCALE] * 3, ORIGIN
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T
    count = len(points)
    las.intensity = random.integers(0, 65536, count)
    las.classification = random.integers(0, 20, count)
    las.return_number = random.integers(1, 4, count)
    las.number_of_returns = np.maximum(random.integers(1, 4, count), las.return_number)
    las.point_source_id = random.integers(0, 65536, count)
    las.user_data = random.integers(0, 256, count)
    names = list(las.point_format.dimension_names)
    if "gps_time" in names:
        las.gps_time = random.uniform(0, 1e9, count)
    for name in ("red", "green", "blue", "nir"):
        if name in names:
            las[name] = random.integers(0, 65536, count)
    for name in FLAGS:
        if name in names:
            las[name] = random.integers(0, 2, count)
    las.add_extra_dim(laspy.ExtraBytesParams("width", np.int32, scales=np.array([0.125]), offsets=np.array([7.0])))
    las.add_extra_dim(laspy.ExtraBytesParams("amplitude", np.float64))
    las["width"], las["amplitude"] = random.integers(-1000, 1000, count) * 0.125 + 7, random.normal(size=count)
    return las


def compare_las(tool, las, path, *options, chosen=slice(None)):
    found = tool.points(path, *options)
    for axis in "xyz":
        raw = getattr(las, axis.upper())[chosen]
        index = "xyz".index(axis)
        same(found[axis], raw * las.header.scales[index] + las.header.offsets[index], f"{path.name}: {axis}")
    names = set(las.point_format.dimension_names)
    for name in ("intensity", "classification", "return_number", "number_of_returns", "point_source_id",
                 "user_data", "gps_time", "red", "green", "blue", "nir", "width", "amplitude", *FLAGS):
        assert (name in names) == (name in found.dtype.names), f"{path.name}: {name}"
        if name in names:
            same(found[name], np.asarray(las[name])[chosen], f"{path.name}: {name}")


def check_las(tool):
    """LAS 1.2 to 1.4 and LAZ of all point formats, as laspy reads them."""
    laspy = module("laspy")
    needs_scan_formats(tool)
    points = surface(tool)
    for number in (0, 1, 2, 3, 6, 7, 8):
        versions = ("1.4",) if number >= 6 else ("1.2", "1.3", "1.4")
        for version in versions:
            las = make_las(laspy, points, number, version)
            for ending in ("las", "laz"):
                path = tool.folder / f"{version}_{number}.{ending}"
                las.write(path)
                compare_las(tool, laspy.read(path), path)


def check_old_las(tool):
    """LAS 1.0 and 1.1, which are 1.2 but for the number in the header."""
    laspy = module("laspy")
    needs_scan_formats(tool)
    las = make_las(laspy, surface(tool), 1, "1.2")
    for minor in (0, 1):
        path = tool.folder / f"old_{minor}.las"
        las.write(path)
        data = bytearray(path.read_bytes())
        data[25] = minor
        path.write_bytes(data)
        compare_las(tool, las, path)


def check_choice(tool):
    """Classes and returns are chosen as laspy's masks choose them."""
    laspy = module("laspy")
    needs_scan_formats(tool)
    las = make_las(laspy, np.repeat(surface(tool), 4, axis=0) + np.tile(np.arange(4), 1)[:, None].repeat(
        len(surface(tool)), 1).T.reshape(-1, 1) * [[0.003, 0.002, 0.001]], 7, "1.4")
    path = tool.folder / "choice.laz"
    las.write(path)
    kind, number, count = (np.asarray(las[n]) for n in ("classification", "return_number", "number_of_returns"))
    for options, chosen in ((("--class", "2,3,4,5,6"), (kind >= 2) & (kind <= 6)),
                            (("--returns", "first"), number == 1), (("--returns", "last"), number == count),
                            (("--returns", "only"), count == 1)):
        compare_las(tool, las, path, *options, chosen=chosen)


def check_copc(tool):
    """COPC as copclib writes it: the same points, in the order of its chunks."""
    copc = module("copclib")
    needs_scan_formats(tool)
    points = surface(tool)
    path = tool.folder / "cloud.copc.laz"
    config = copc.CopcConfigWriter(7, copc.Vector3(SCALE, SCALE, SCALE), copc.Vector3(*ORIGIN))
    config.copc_info.spacing = 10
    writer = copc.FileWriter(str(path), config)
    for level, part in ((0, points[::2]), (1, points[1::2])):
        chunk = copc.Points(writer.copc_config.las_header)
        for x, y, z in part:
            point = chunk.CreatePoint()
            point.x, point.y, point.z = float(x), float(y), float(z)
            chunk.AddPoint(point)
        writer.AddNode(copc.VoxelKey(level, 0, 0, 0), chunk)
    writer.Close()
    found = places(tool.points(path))
    expected = np.concatenate([points[::2], points[1::2]])
    assert found.shape == expected.shape and np.abs(found - expected).max() < 0.51 * SCALE
    assert "COPC" in tool("info", path)


def check_e57(tool):
    """E57 of two scans with poses, as pye57 reads them."""
    pye57 = module("pye57")
    needs_scan_formats(tool)
    points = surface(tool) - ORIGIN
    random = np.random.default_rng(7)
    path = tool.folder / "scans.e57"
    turn = np.array([0.5, -0.5, 0.5, 0.5]), np.array([0.8, 0.0, 0.6, 0.0])
    file = pye57.E57(str(path), mode="w")
    halves = (points[: len(points) // 2], points[len(points) // 2:])
    for half, rotation in zip(halves, turn):
        data = {f"cartesian{axis.upper()}": half[:, i].copy() for i, axis in enumerate("xyz")}
        data["intensity"] = random.uniform(0, 1, len(half)).astype(np.float32)
        for name in ("Red", "Green", "Blue"):
            data["color" + name] = random.integers(0, 256, len(half)).astype(np.uint8)
        data["rowIndex"] = random.integers(0, 1000, len(half)).astype(np.int32)
        data["columnIndex"] = random.integers(0, 1000, len(half)).astype(np.int32)
        file.write_scan_raw(data, rotation=rotation, translation=np.array([10.0, -20.0, 30.0]))
    file.close()
    file = pye57.E57(str(path))
    scans = [file.read_scan(i, ignore_missing_fields=True, intensity=True, colors=True, row_column=True)
             for i in range(2)]
    found = tool.points(path)
    together = {key: np.concatenate([scan[key] for scan in scans]) for key in scans[0]}
    for axis in "xyz":
        difference = np.abs(found[axis] - together["cartesian" + axis.upper()]).max()
        assert difference < 1e-12 * np.abs(points).max() * 100, f"{axis} differs by {difference}"
    for ours, theirs in (("intensity", "intensity"), ("red", "colorRed"), ("green", "colorGreen"),
                         ("blue", "colorBlue"), ("row", "rowIndex"), ("column", "columnIndex")):
        same(found[ours], together[theirs].astype(found[ours].dtype), ours)
    same(found["scan"], np.repeat([0, 1], [len(halves[0]), len(halves[1])]).astype("u2"), "scan")


def check_e57_invalid(tool):
    """Points that an E57 of pye57 marks invalid have no place."""
    pye57 = module("pye57")
    needs_scan_formats(tool)
    points = surface(tool) - ORIGIN
    cartesian = {f"cartesian{axis}": points[:, i].copy() for i, axis in enumerate("XYZ")}
    cartesian["cartesianInvalidState"] = (np.arange(len(points)) % 50 == 0).astype(np.uint8) * 2
    path = tool.folder / "invalid.e57"
    file = pye57.E57(str(path), mode="w")
    file.write_scan_raw(cartesian)
    file.close()
    same(np.isnan(tool.points(path)["x"]), cartesian["cartesianInvalidState"] != 0, "invalid points")


def check_units(tool):
    """The unit of a LAS file is that of its reference system, as WKT or as GeoTIFF keys."""
    laspy = module("laspy")
    needs_scan_formats(tool)
    las = make_las(laspy, surface(tool), 7, "1.4")
    degrees = 'GEOGCS["a",UNIT["degree",0.017]]'
    keys = (1, 1, 0, 2, 1024, 0, 1, 1, 3076, 0, 1)
    for record, data, unit in ((2112, f'PROJCS["b",{degrees},UNIT["metre",1]]'.encode(), "m"),
                               (2112, f'PROJCS["b",{degrees},UNIT["US survey foot",0.3]]'.encode(), "US survey ft"),
                               (2112, degrees.encode(), "degrees"), (34735, struct.pack("<12H", *keys, 9002), "ft")):
        las.header.vlrs = [laspy.VLR("LASF_Projection", record, "", data)]
        path = tool.folder / "unit.las"
        las.write(path)
        told = dict(line.split(maxsplit=1) for line in tool("info", path).splitlines() if " " in line)
        assert told["unit"].strip() == unit, (told["unit"], unit)


def check_npy(tool):
    """NPY as numpy writes it, and any file in gzip."""
    points = surface(tool)
    path = tool.folder / "points.npy"
    for array in (points, np.asfortranarray(points), points.astype(">f8"), points.reshape(-1, 1, 3)):
        np.save(path, array)
        same(places(tool.points(path)), points, "NPY")
    packed = tool.folder / "points.npy.gz"
    packed.write_bytes(gzip.compress(path.read_bytes()))
    same(places(tool.points(packed)), points, "NPY in gzip")
    names = ["x", "y", "z", "t"]
    records = np.zeros(len(points), [(name, "<f8") for name in names])
    for i, name in enumerate("xyz"):
        records[name] = points[:, i]
    records["t"] = np.arange(len(points))
    np.save(path, records)
    found = tool.points(path)
    for name in names:
        same(found[name], records[name], name)


def check_damage(tool):
    """LAS, LAZ and E57 that are cut short or changed are refused or read, and nothing else happens."""
    import subprocess
    needs_scan_formats(tool)
    random = np.random.default_rng(11)
    for name in ("1.4_7.laz", "1.2_3.laz", "1.2_3.las", "scans.e57", "cloud.copc.laz"):
        whole = tool.folder / name
        if not whole.exists():
            continue
        data = whole.read_bytes()
        for trial in range(12):
            bad = bytearray(data)
            if trial % 3 == 0:
                bad = bad[: random.integers(1, len(bad))]
            else:
                for _ in range(random.integers(1, 6)):
                    bad[random.integers(0, 400 if trial % 3 == 1 else len(bad))] = random.integers(0, 256)
            path = tool.folder / "damaged.bin"
            path.write_bytes(bad)
            done = subprocess.run([tool.path, "info", path, "--memory-limit", "1G"], capture_output=True, text=True)
            assert done.returncode in (0, 2, 4), f"{name}, trial {trial}: status {done.returncode}: {done.stderr}"
            assert done.returncode == 0 or done.stderr.count("\n") == 1, done.stderr


CHECKS = [check_las, check_old_las, check_choice, check_copc, check_e57, check_e57_invalid, check_units, check_npy, check_damage]
