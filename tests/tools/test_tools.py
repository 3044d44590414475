"""The tools that judge pictures must be right themselves."""

import math
import os
import struct
import sys
import tempfile
import unittest
import zlib
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

import conformance  # noqa: E402
import golden  # noqa: E402
import pictures  # noqa: E402
import png  # noqa: E402
import programs  # noqa: E402
import report  # noqa: E402

NOISE = png.Picture(7, 5, bytes((i * 73 + i * i * 11) % 256 for i in range(7 * 5 * 3)))


def chunk(kind: bytes, body: bytes) -> bytes:
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def png_file(width: int, height: int, bits: int, colour: int, raw: bytes) -> bytes:
    header = struct.pack(">IIBBBBB", width, height, bits, colour, 0, 0, 0)
    return png.SIGNATURE + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b"")


class Png(unittest.TestCase):
    def test_what_is_written_reads_back(self):
        self.assertEqual(png.decode(png.encode(NOISE)), NOISE)

    def test_every_row_filter_is_undone(self):
        # One row per filter, each predicting from left, above, both, or the nearest of three.
        raw = bytes([0, 10, 20, 30, 40, 50, 60,
                     1, 1, 2, 3, 4, 5, 6,
                     2, 1, 1, 1, 1, 1, 1,
                     3, 9, 9, 9, 9, 9, 9,
                     4, 1, 2, 3, 4, 5, 6])
        expected = bytes([10, 20, 30, 40, 50, 60,
                          1, 2, 3, 5, 7, 9,
                          2, 3, 4, 6, 8, 10,
                          10, 10, 11, 17, 18, 19,
                          11, 12, 14, 21, 23, 25])
        self.assertEqual(png.decode(png_file(2, 5, 8, 2, raw)).rgb, expected)

    def test_alpha_is_dropped_and_grey_is_spread(self):
        self.assertEqual(png.decode(png_file(1, 1, 8, 6, bytes([0, 1, 2, 3, 99]))).rgb, bytes([1, 2, 3]))
        self.assertEqual(png.decode(png_file(2, 1, 8, 0, bytes([0, 7, 9]))).rgb, bytes([7, 7, 7, 9, 9, 9]))

    def test_sixteen_bits_are_rounded_to_eight(self):
        raw = bytes([0]) + struct.pack(">3H", 257 * 200, 257 * 3 + 128, 65535)
        self.assertEqual(png.decode(png_file(1, 1, 16, 2, raw)).rgb, bytes([200, 3, 255]))

    def test_damaged_files_are_refused(self):
        whole = png.encode(NOISE)
        for data in (b"", b"not a picture", whole[:40], whole[:-20], whole[:60] + b"xx" + whole[62:]):
            with self.assertRaises(png.PngError):
                png.decode(data)


class Pictures(unittest.TestCase):
    def test_identical_pictures_have_infinite_psnr(self):
        self.assertEqual(pictures.psnr(NOISE, NOISE), math.inf)

    def test_psnr_of_a_known_error(self):
        black = png.Picture(10, 10, bytes(300))
        one = png.Picture(10, 10, bytes([255] * 3) + bytes(297))
        self.assertAlmostEqual(pictures.psnr(black, one), 20.0)
        grey = png.Picture(10, 10, bytes([1] * 300))
        self.assertAlmostEqual(pictures.psnr(black, grey), 48.1308, 4)

    def test_classes_begin_at_their_limits(self):
        names = [pictures.class_of(value) for value in (math.inf, 50, 49.99, 38, 37.9, 28, 27.9, 0)]
        self.assertEqual(names, ["exact", "exact", "match", "match", "near", "near", "wrong", "wrong"])

    def test_difference_is_amplified_and_clipped(self):
        a, b = png.Picture(1, 1, bytes([10, 100, 0])), png.Picture(1, 1, bytes([12, 0, 0]))
        self.assertEqual(pictures.difference(a, b, 8).rgb, bytes([16, 255, 0]))


class Programs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def durer(self, script: str):
        """Renders a scene whose path has blanks and letters beyond ASCII with a stand-in for durer."""
        program = self.folder / "durer"
        program.write_text(f"#!/bin/sh\n{script}\n")
        program.chmod(0o755)
        scenes = self.folder / "mein Ordner é"
        scenes.mkdir(exist_ok=True)
        scene = scenes / "a b.pov"
        scene.touch()
        with mock.patch.dict(os.environ, DURER=str(program)):
            return programs.render_with_durer(scene, ["+W7"], 2)

    def test_a_picture_is_read(self):
        (self.folder / "made.png").write_bytes(png.encode(NOISE))
        result = self.durer(f'[ "$1" = "+Ia b.pov" ] && [ -e "a b.pov" ] && cp {self.folder}/made.png "${{2#+O}}"')
        self.assertEqual((result.picture, result.error), (NOISE, ""))

    def test_a_crash_is_told_from_an_error(self):
        self.assertEqual(self.durer("kill -SEGV $$").error, "crashed (signal 11)")
        self.assertEqual(self.durer("echo 'a warning' >&2; echo 'error[D0220]: no fog' >&2; exit 1").error,
                         "error[D0220]: no fog")

    def test_success_without_a_picture_is_a_failure(self):
        self.assertEqual(self.durer("exit 0").error, "exit code 0, but no picture")

    def test_a_program_that_hangs_is_ended(self):
        result = programs.run(["sh", "-c", "sleep 60 & wait"], self.folder, 0.2)
        self.assertTrue(result.timed_out)
        self.assertLess(result.wall, 5)


class Conformance(unittest.TestCase):
    def row(self, scene, kind, decibels=None):
        return conformance.Row(scene, kind, decibels, "", 2.0, 1.0)

    def test_only_a_worse_class_is_a_regression(self):
        rows = [self.row("a", "match", 40.0), self.row("b", "fail"), self.row("c", "exact", 51.0),
                self.row("new", "fail")]
        before = {"a": ("exact", "60.0"), "b": ("fail", "-"), "c": ("near", "30.0")}
        self.assertEqual(conformance.changes(rows, before, worse=True), ["a: exact → match"])
        self.assertEqual(conformance.changes(rows, before, worse=False), ["c: near → exact"])

    def test_the_baseline_reads_back_and_keeps_what_did_not_run(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "baseline.tsv"
            conformance.write_baseline(path, [self.row("b", "exact", math.inf)], {"a": ("fail", "-")})
            self.assertEqual(conformance.read_baseline(path), {"a": ("fail", "-"), "b": ("exact", "inf")})

    def test_filters_are_parts_of_names_or_patterns(self):
        scenes = ["lights/spot.pov", "objects/box.pov", "objects/blob.pov"]
        self.assertEqual(conformance.choose(scenes, ["spot"], None), ["lights/spot.pov"])
        self.assertEqual(len(conformance.choose(scenes, ["objects/b*.pov"], None)), 2)

    def test_the_summary_counts_classes_and_times(self):
        rows = [self.row("a", "exact", 60.0), self.row("b", "fail")]
        self.assertEqual(conformance.summary(rows),
                         "2 scenes: 1 exact, 0 match, 0 near, 0 wrong, 1 fail, 0 the oracle fails; "
                         "the 1 that both render: oracle 2.0 s, durer 1.0 s, 2.0 times as fast")

    def test_the_page_shows_three_pictures_per_compared_scene(self):
        row = conformance.Row("a/<b>.pov", "near", 30.0, "", 1, 1, False, NOISE, NOISE)
        with tempfile.TemporaryDirectory() as folder:
            page = report.write(Path(folder), [row], "one scene", []).read_text()
        self.assertEqual(page.count("<img"), 3)
        self.assertNotIn("<b>", page)


class Golden(unittest.TestCase):
    def test_every_scene_says_how_to_judge_it_and_has_its_picture(self):
        for scene in golden.scenes([]):
            with self.subTest(scene=scene.name):
                self.assertTrue(golden.load(scene).picture.exists())


if __name__ == "__main__":
    unittest.main()
