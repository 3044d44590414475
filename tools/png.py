"""PNG files in and out with the standard library alone.

Reads what renderers write: grey, RGB and RGBA, 8 or 16 bits, not interlaced. Writes 8-bit RGB.
Every picture becomes a `Picture` of 8-bit RGB: alpha is dropped, 16 bits are rounded to 8.
"""

import struct
import zlib
from dataclasses import dataclass
from pathlib import Path

SIGNATURE = b"\x89PNG\r\n\x1a\n"
CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}  # colour type → samples per pixel; palettes are not read


class PngError(Exception):
    """The file is no PNG, is damaged, or is of a kind that this module does not read."""


@dataclass(frozen=True)
class Picture:
    width: int
    height: int
    rgb: bytes  # width · height · 3, top row first


def read(path: Path) -> Picture:
    """Reads a PNG file. Raises PngError or OSError."""
    return decode(Path(path).read_bytes())


def decode(data: bytes) -> Picture:
    """The picture in `data`, the bytes of a PNG file. Raises PngError."""
    if not data.startswith(SIGNATURE):
        raise PngError("not a PNG file")
    try:
        return _decode_chunks(data)
    except (struct.error, zlib.error, IndexError) as error:
        raise PngError(f"damaged PNG file: {error}") from error


def encode(picture: Picture) -> bytes:
    """The bytes of an 8-bit RGB PNG file."""
    stride = picture.width * 3
    rows = (picture.rgb[y * stride:(y + 1) * stride] for y in range(picture.height))
    header = struct.pack(">IIBBBBB", picture.width, picture.height, 8, 2, 0, 0, 0)
    return b"".join([
        SIGNATURE,
        _chunk(b"IHDR", header),
        _chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows), 9)),
        _chunk(b"IEND", b""),
    ])


def _chunk(kind: bytes, body: bytes) -> bytes:
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def _decode_chunks(data: bytes) -> Picture:
    header, packed, at, ended = None, [], len(SIGNATURE), False
    while at < len(data) and not ended:
        size, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed.append(body)
        ended = kind == b"IEND"
        at += size + 12
    if header is None or not ended:
        raise PngError("damaged PNG file: it ends too early")
    width, height, bits, colour, _, _, interlaced = header
    if colour not in CHANNELS or bits not in (8, 16) or interlaced:
        raise PngError(f"a PNG of a kind that is not read here (type {colour}, {bits} bits)")
    channels = CHANNELS[colour]
    samples = _unfilter(zlib.decompress(b"".join(packed)), width, height, channels * bits // 8)
    if bits == 16:
        samples = bytes((value + 128) // 257 for value in struct.unpack(f">{len(samples) // 2}H", samples))
    return Picture(width, height, _to_rgb(samples, channels))


def _to_rgb(samples: bytes, channels: int) -> bytes:
    if channels == 3:
        return samples
    rgb = bytearray(len(samples) // channels * 3)
    for k in range(3):
        rgb[k::3] = samples[k if channels == 4 else 0::channels]
    return bytes(rgb)


def _unfilter(raw: bytes, width: int, height: int, step: int) -> bytes:
    """Undoes the row filters [PNG specification, ch. 9]. `step`: bytes per pixel."""
    stride = width * step
    if len(raw) != (stride + 1) * height:
        raise PngError("damaged PNG file: wrong amount of pixels")
    out = bytearray()
    above = bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        row = bytearray(raw[start + 1:start + 1 + stride])
        _unfilter_row(raw[start], row, above, step)
        out += row
        above = row
    return bytes(out)


def _unfilter_row(kind: int, row: bytearray, above: bytearray, step: int) -> None:
    if kind == 1:
        for i in range(step, len(row)):
            row[i] = (row[i] + row[i - step]) & 255
    elif kind == 2:
        for i, up in enumerate(above):
            row[i] = (row[i] + up) & 255
    elif kind == 3:
        for i, up in enumerate(above):
            left = row[i - step] if i >= step else 0
            row[i] = (row[i] + (left + up) // 2) & 255
    elif kind == 4:
        for i, up in enumerate(above):
            left, corner = (row[i - step], above[i - step]) if i >= step else (0, 0)
            row[i] = (row[i] + _paeth(left, up, corner)) & 255
    elif kind != 0:
        raise PngError(f"damaged PNG file: unknown filter {kind}")


def _paeth(left: int, up: int, corner: int) -> int:
    guess = left + up - corner
    by_left, by_up, by_corner = abs(guess - left), abs(guess - up), abs(guess - corner)
    if by_left <= by_up and by_left <= by_corner:
        return left
    return up if by_up <= by_corner else corner
