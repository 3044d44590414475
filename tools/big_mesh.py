#!/usr/bin/env python3
"""Writes a landscape of many triangles, to see what a large mesh costs.

    tools/big_mesh.py FILE.ply [TRIANGLES]     binary, as scanners write them; 10 million by default
    tools/big_mesh.py FILE.inc [TRIANGLES]     a mesh2 as text

Both are rendered by a scene such as

    camera { location <0, 1, -1.2> look_at 0 }  light_source { <3, 5, -4> 1 }
    mesh { import "big.ply" smooth pigment { rgb .7 } }      or      #include "big.inc"

and `/usr/bin/time -v durer …` tells the memory: 10 million triangles should take less than 16 GiB.
"""

import array
import math
import struct
import sys


def heights(side: int):
    """Rows of x, y, z over the square -1…1."""
    steps = [2 * i / side - 1 for i in range(side + 1)]
    waves = [math.cos(7 * z) + 0.1 * math.sin(90 * z) for z in steps]
    for x in steps:
        rise = 0.2 * math.sin(9 * x)
        yield [(x, rise * wave, z) for z, wave in zip(steps, waves)]


def cells(side: int):
    """The two triangles of every square, row by row."""
    for i in range(side):
        first = i * (side + 1)
        yield [(c, c + 1, c + side + 1, c + 1, c + side + 2, c + side + 1)
               for c in range(first, first + side)]


def write_ply(path: str, side: int) -> None:
    with open(path, "wb") as file:
        file.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {(side + 1)**2}\n"
                   "property float x\nproperty float y\nproperty float z\n"
                   f"element face {2 * side * side}\nproperty list uchar int vertex_indices\n"
                   "end_header\n".encode())
        for row in heights(side):
            numbers = array.array("f", [v for point in row for v in point])
            if sys.byteorder == "big":
                numbers.byteswap()
            file.write(numbers.tobytes())
        pack = struct.Struct("<B3iB3i").pack
        for row in cells(side):
            file.write(b"".join(pack(3, a, b, c, 3, d, e, f) for a, b, c, d, e, f in row))


def write_mesh2(path: str, side: int) -> None:
    with open(path, "w", encoding="ascii") as file:
        file.write(f"mesh2 {{\nvertex_vectors {{ {(side + 1)**2}\n")
        for row in heights(side):
            file.write("".join(f",<{x:.6f},{y:.6f},{z:.6f}>\n" for x, y, z in row))
        file.write(f"}}\nface_indices {{ {2 * side * side}\n")
        for row in cells(side):
            file.write("".join(f",<{a},{b},{c}>,<{d},{e},{f}>\n" for a, b, c, d, e, f in row))
        file.write("}\npigment { rgb .7 }\n}\n")


def main() -> None:
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    path = sys.argv[1]
    side = math.ceil(math.sqrt(float(sys.argv[2] if len(sys.argv) == 3 else 1e7) / 2))
    (write_mesh2 if path.endswith(".inc") else write_ply)(path, side)


if __name__ == "__main__":
    main()
