#!/usr/bin/env python3
"""Pictures that stand in for those of POV-Ray's packages, which scenes name and which are not ours to give.

    tools/stand_ins.py    writes them to stdlib/stand-ins

They have the names, sizes and kinds of the originals and show something of the same sort, made by formula.
"""

import math
import struct
import sys
import zlib
from collections.abc import Callable
from pathlib import Path

import png
import programs

FOLDER = programs.ROOT / "stdlib" / "stand-ins"
SIXTEEN = [(0, 0, 0), (0, 0, 170), (0, 150, 60), (0, 160, 170), (170, 30, 30), (150, 40, 150), (170, 100, 30), (190, 190, 190),
           (80, 80, 80), (70, 90, 255), (110, 230, 110), (110, 240, 240), (250, 90, 90), (250, 120, 240), (250, 240, 100), (255, 255, 255)]
Pixel = Callable[[int, int], int]


# ---- formulas ----------------------------------------------------------------------------------

def lattice(x: int, y: int, seed: int) -> float:
    """A number from 0 to 1 for a lattice point, always the same."""
    h = (x * 374761393 + y * 668265263 + seed * 2246822519) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 1274126177) & 0xFFFFFFFF
    return (h ^ (h >> 16)) / 0xFFFFFFFF


def noise(x: float, y: float, seed: int) -> float:
    """Values of the lattice, smoothly joined."""
    i, j = math.floor(x), math.floor(y)
    u, v = x - i, y - j
    u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
    low = lattice(i, j, seed) * (1 - u) + lattice(i + 1, j, seed) * u
    high = lattice(i, j + 1, seed) * (1 - u) + lattice(i + 1, j + 1, seed) * u
    return low * (1 - v) + high * v


def clouds(x: float, y: float, seed: int, octaves: int = 6) -> float:
    """Noise of several sizes, 0 to 1."""
    return sum(noise(x * 2**k, y * 2**k, seed + k) / 2**k for k in range(octaves)) / (2 - 2 ** (1 - octaves))


def ridges(x: float, y: float, seed: int) -> float:
    """Mountains: sharp crests, 0 to 1."""
    return sum((1 - abs(2 * noise(x * 2**k, y * 2**k, seed + k) - 1)) ** 2 / 2**k for k in range(6)) / 1.97


def escape(x: float, y: float) -> float:
    """How soon the iteration of z² + c leaves the plane: 0 never, near 1 at once; smooth."""
    z, c = 0j, complex(x, y)
    for n in range(200):
        z = z * z + c
        if abs(z) > 50:
            return 1 / (1 + 0.09 * (n + 1 - math.log(math.log(abs(z)) / math.log(50), 2)))
    return 0.0


def card(x: int, y: int) -> int:
    """A test card: quarters of four colours, a grid, a ring, an arrow that points up and a bar on the left."""
    u, v = x - 160, 100 - y
    if 84 < math.hypot(u, v) < 90:
        return 15
    if abs(u) < 8 and -50 < v < 30 or 30 <= v < 60 and abs(u) < 60 - v:
        return 14
    if 20 < x < 36 and 30 < y < 170:
        return 1 + (y - 30) // 10
    if x % 40 in (0, 39) or y % 40 in (0, 39):
        return 8
    return (12 if u < 0 else 10) if v > 0 else (9 if u < 0 else 7)


# ---- files -------------------------------------------------------------------------------------

def indexed(width: int, height: int, palette: list[tuple[int, int, int]], pixel: Pixel) -> bytes:
    """A PNG file with a palette; of 4 bits where 16 colours do."""
    bits = 4 if len(palette) <= 16 else 8
    rows = bytearray()
    for y in range(height):
        line = [pixel(x, y) for x in range(width)]
        rows += b"\0" + (bytes(line) if bits == 8 else bytes(a << 4 | b for a, b in zip(line[::2], line[1::2])))
    return _png(width, height, bits, 3, bytes(rows), bytes(c for entry in palette for c in entry))


def grey(width: int, height: int, pixel: Pixel) -> bytes:
    rows = b"".join(b"\0" + bytes(pixel(x, y) for x in range(width)) for y in range(height))
    return _png(width, height, 8, 0, rows, b"")


def _png(width: int, height: int, bits: int, kind: int, rows: bytes, palette: bytes) -> bytes:
    def chunk(name: bytes, body: bytes) -> bytes:
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
    header = struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, 0)
    return b"".join([png.SIGNATURE, chunk(b"IHDR", header), chunk(b"PLTE", palette) if palette else b"",
                     chunk(b"IDAT", zlib.compress(rows, 9)), chunk(b"IEND", b"")])


def gif(width: int, height: int, pixel: Pixel) -> bytes:
    """A grey GIF file of 8 bits: every pixel a code of its own, the table cleared before codes would grow."""
    codes = []
    for k in range(width * height):
        if k % 250 == 0:
            codes.append(256)
        codes.append(pixel(k % width, k // width))
    packed = packed_codes(codes + [257], 9)
    blocks = b"".join(bytes([len(packed[k:k + 255])]) + packed[k:k + 255] for k in range(0, len(packed), 255))
    return (b"GIF87a" + struct.pack("<HHBBB", width, height, 0xF7, 0, 0) + bytes(v for v in range(256) for _ in range(3))
            + b"," + struct.pack("<HHHHB", 0, 0, width, height, 0) + b"\x08" + blocks + b"\0;")


def packed_codes(codes: list[int], width: int) -> bytes:
    """Codes of so many bits, the lowest bit first."""
    out, held, count = bytearray(), 0, 0
    for code in codes:
        held |= code << count
        count += width
        while count >= 8:
            out.append(held & 255)
            held, count = held >> 8, count - 8
    return bytes(out) + (bytes([held]) if count else b"")


def potential(width: int, height: int) -> bytes:
    """The height over the Mandelbrot set as pictures of 16 bits are kept: high bytes on the left, low ones on the right."""
    heights = [[round(65535 * (1 - escape(*place(x, y, width, height)))) for x in range(width)] for y in range(height)]
    return gif(2 * width, height, lambda x, y: heights[y][x] >> 8 if x < width else heights[y][x - width] & 255)


def place(x: int, y: int, width: int, height: int) -> tuple[float, float]:
    return -2.1 + 3 * x / width, 1.2 - 2.4 * y / height


def spiral() -> bytes:
    """Two arms, thickest at the centre and in the middle layer."""
    def density(x: int, y: int, z: int) -> int:
        u, v = (x - 24.5) / 25, (y - 24.5) / 25
        r = math.hypot(u, v)
        arms = 0.5 + 0.5 * math.cos(2 * (math.atan2(v, u) - 3 * math.log(r + 0.08)))
        return round(255 * max(0.0, 1 - r) * arms**2 * (1, 0.7, 0.3)[abs(z - 2)])
    return struct.pack(">HHH", 50, 50, 5) + bytes(density(x, y, z) for z in range(5) for y in range(50) for x in range(50))


def rainbow(turns: float, low: int) -> list[tuple[int, int, int]]:
    """256 colours around the wheel; no channel is below `low`."""
    def channel(k: int, shift: float) -> int:
        return round(low + (255 - low) * (0.5 + 0.5 * math.cos(2 * math.pi * (turns * k / 255 - shift))))
    return [(channel(k, 0), channel(k, 1 / 3), channel(k, 2 / 3)) for k in range(256)]


def made() -> dict[str, bytes]:
    """File → its bytes."""
    def level(value: float) -> int:
        return min(255, max(0, int(256 * value)))
    return {
        "test.png": indexed(320, 200, SIXTEEN, card),
        "povmap.png": indexed(320, 200, SIXTEEN, lambda x, y: min(15, int(16 * clouds(x / 80, y / 80, 31, 4)))),
        "mtmandj.png": indexed(320, 200, rainbow(2, 60), lambda x, y: level(1 - escape(*place(x, y, 320, 200)))),
        "mtmand.pot": potential(160, 100),
        "bumpmap_.png": indexed(320, 200, [(k, k, k) for k in range(256)], lambda x, y: level(
            0.5 + 0.5 * math.sin(x / 6.3662) * math.sin(y / 6.3662))),
        "fract003.png": indexed(320, 200, rainbow(1, 40), lambda x, y: level(1.7 * clouds(x / 60, y / 60, 3) - 0.35)),
        "plasma2.png": indexed(100, 100, rainbow(1, 0), lambda x, y: level(1.7 * clouds(x / 40, y / 40, 2) - 0.35)),
        "plasma3.png": indexed(100, 100, rainbow(1, 0), lambda x, y: level(1.7 * clouds(x / 25, y / 25, 9) - 0.35)),
        "Mount1.png": grey(250, 250, lambda x, y: level(ridges(x / 90, y / 90, 5) * math.sin(math.pi * (x + 0.5) / 250) * math.sin(math.pi * (y + 0.5) / 250))),
        "Mount2.png": grey(250, 250, lambda x, y: level(ridges(x / 60, y / 60, 17))),
        "spiral.df3": spiral(),
    }


def main() -> int:
    FOLDER.mkdir(exist_ok=True)
    for name, data in made().items():
        (FOLDER / name).write_bytes(data)
    return 0


if __name__ == "__main__":
    sys.exit(main())
