"""Inputs of benchmark scenes that are too large to keep: written once into build/bench.

A scene of bench/ names what it needs by a line `// input: NAME`.
"""

import math
from pathlib import Path

import programs

FOLDER = programs.ROOT / "build" / "bench"


def literal_mesh(path: Path) -> None:
    """A mesh2 with vertices, normals and faces as numbers: 30 MB, as modellers export them."""
    side = 460
    steps = range(side + 1)
    with open(path, "w", encoding="ascii") as text:
        text.write(f"mesh2 {{\n  vertex_vectors {{\n    {(side + 1)**2},\n")
        for i in steps:
            for k in steps:
                x, z = 2 * i / side - 1, 2 * k / side - 1
                text.write(f"    <{x:.9f}, {0.2 * math.sin(9 * x) * math.cos(7 * z):.9f}, {z:.9f}>,\n")
        text.write(f"  }}\n  normal_vectors {{\n    {(side + 1)**2},\n")
        for i in steps:
            for k in steps:
                x, z = 2 * i / side - 1, 2 * k / side - 1
                slope_x = 1.8 * math.cos(9 * x) * math.cos(7 * z)
                slope_z = -1.4 * math.sin(9 * x) * math.sin(7 * z)
                length = math.sqrt(1 + slope_x**2 + slope_z**2)
                text.write(f"    <{-slope_x / length:.9f}, {1 / length:.9f}, {-slope_z / length:.9f}>,\n")
        text.write(f"  }}\n  face_indices {{\n    {2 * side * side},\n")
        for i in range(side):
            for k in range(side):
                corner = i * (side + 1) + k
                text.write(f"    <{corner}, {corner + 1}, {corner + side + 1}>,\n"
                           f"    <{corner + 1}, {corner + side + 1}, {corner + side + 2}>,\n")
        text.write("  }\n  pigment { rgb <0.4, 0.7, 0.3> }\n}\n")


def bench_map(path: Path) -> None:
    """A picture of 1024x512 pixels with waves and small tiles in it."""
    width, height = 1024, 512
    pixels = bytearray()
    for y in range(height):
        for x in range(width):
            wave = math.sin(x / 40) * math.cos(y / 25) + 0.5 * math.sin(x * y / 3000)
            tile = 40 if (x // 16 + y // 16) % 2 else 0
            pixels += bytes((int(128 + 60 * wave), int(160 - 50 * wave + tile / 2), 100 + tile))
    path.write_bytes(b"P6\n%d %d\n255\n" % (width, height) + pixels)


WRITERS = {"bench_map.ppm": bench_map, "literal_mesh.inc": literal_mesh}


def provide(name: str) -> None:
    """Writes the input `name` unless it is there; raises KeyError if there is no such input."""
    write = WRITERS[name]
    path = FOLDER / name
    if path.exists():
        return
    FOLDER.mkdir(parents=True, exist_ok=True)
    part = path.with_suffix(".part")
    write(part)
    part.rename(path)
