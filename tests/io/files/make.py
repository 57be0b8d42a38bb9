# SPDX-License-Identifier: GPL-3.0-or-later
"""make.py FOLDER: the small files that scan_formats_test.cpp reads; needs laspy with lazrs, and pye57.
spherical.e57 is of src/io/scan_formats/examples/spherical.rs."""

import pathlib
import sys

import laspy
import numpy as np
import pye57

folder = pathlib.Path(sys.argv[1])
count = 20
i = np.arange(count)


def las(point_format, version, name):
    header = laspy.LasHeader(point_format=point_format, version=version)
    header.scales, header.offsets = [0.001, 0.01, 0.1], [500000, 5400000, 0]
    points = laspy.LasData(header)
    points.X, points.Y, points.Z = 7 * i, -i, i
    points.intensity, points.classification = 100 * i, i % 5
    points.return_number, points.number_of_returns = 1 + i % 2, 1 + (i + 1) // 2 % 2 + i % 2
    points.gps_time = 1e8 + i / 8
    points.red, points.green, points.blue = 1000 * i, 2000 * i, 3000 * i
    points.write(folder / name)


def extra(point_format, version, name):
    header = laspy.LasHeader(point_format=point_format, version=version)
    header.scales, header.offsets = [0.01] * 3, [0, 0, 0]
    header.add_extra_dims([
        laspy.ExtraBytesParams("width", np.uint16, scales=np.array([0.25]), offsets=np.array([10.0])),
        laspy.ExtraBytesParams("deviation", np.int8), laspy.ExtraBytesParams("sum", np.float32),
        laspy.ExtraBytesParams("beam", "3u1")])
    points = laspy.LasData(header)
    points.X, points.Y, points.Z = 7 * i, -i, i
    points["width"], points["deviation"], points["sum"] = 10 + 0.25 * i, -3 * i, 0.5 * i
    points["beam"] = np.stack([i, 2 * i, 3 * i], axis=1)
    points.scan_direction_flag, points.edge_of_flight_line = i % 2, i // 2 % 2
    points.synthetic, points.key_point, points.withheld = i // 4 % 2, i // 8 % 2, i // 16 % 2
    if point_format >= 6:
        points.overlap, points.scanner_channel = i % 3 == 0, i % 4
    points.write(folder / name)


def e57(name):
    file = pye57.E57(str(folder / name), mode="w")
    for scan in range(2):
        data = {"cartesianX": i / 4.0, "cartesianY": -i / 2.0, "cartesianZ": 0.0 * i + scan,
                "intensity": (i / 32).astype(np.float32), "colorRed": (3 * i).astype(np.uint8),
                "colorGreen": (4 * i).astype(np.uint8), "colorBlue": (5 * i).astype(np.uint8)}
        # A quarter turn about z for the second, and a step along x.
        turn = [np.array([1.0, 0, 0, 0]), np.array([0.5**0.5, 0, 0, 0.5**0.5])][scan]
        file.write_scan_raw(data, rotation=turn, translation=np.array([100.0 * scan, 0, 0]))
    file.close()


las(3, "1.2", "points_1.2.las")
las(3, "1.2", "points_1.2.laz")
las(7, "1.4", "points_1.4.las")
las(7, "1.4", "points_1.4.laz")
extra(3, "1.2", "extra_1.2.las")
extra(7, "1.4", "extra_1.4.laz")
e57("two_scans.e57")
