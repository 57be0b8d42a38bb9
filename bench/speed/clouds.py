"""The clouds that whole processes are timed on."""
import array
import pathlib
import struct
import subprocess

FORMAT = {"float": "f", "float32": "f", "double": "d", "float64": "d", "uchar": "B", "uint8": "B", "char": "b",
          "int8": "b", "short": "h", "ushort": "H", "int": "i", "int32": "i", "uint": "I", "uint32": "I"}


def sheet(tool, folder, points):
    """A wavy saddle, sampled uniformly at random, in random order."""
    path = pathlib.Path(folder) / f"sheet-{points}.ply"
    if not path.exists():
        subprocess.run([str(tool), "sample", "wavy-saddle", "-n", str(points), "--sampling", "random", "--seed", "7",
                        "-o", str(path), "-q"], check=True)
    return path


def for_peers(ply):
    """The coordinates of a binary PLY file as bench/peers/protocol.h wants them, beside the sheets."""
    out = pathlib.Path(__file__).resolve().parents[2] / "bench/out/speed" / (pathlib.Path(ply).stem + ".peers")
    if out.exists():
        return out
    data = pathlib.Path(ply).read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    count, layout, names = 0, "<", []
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[:2] == ["element", "vertex"]:
            count = int(words[2])
        elif words[:1] == ["property"] and words[1] != "list":
            layout += FORMAT[words[1]]
            names.append(words[2])
    step, at = struct.calcsize(layout), [names.index(axis) for axis in "xyz"]
    coordinates = array.array("d")
    for row in struct.iter_unpack(layout, data[end:end + count * step]):
        coordinates.extend((row[at[0]], row[at[1]], row[at[2]]))
    with open(out, "wb") as file:
        file.write(struct.pack("<q", count))
        coordinates.tofile(file)
    return out
