"""The conformance run as an HTML page: pictures side by side with their amplified difference."""

import html
from pathlib import Path

import pictures
import png

_STYLE = """
:root { color-scheme: light dark; font: 14px/1.4 system-ui, sans-serif; }
body { margin: 2rem; }
table { border-collapse: collapse; }
td, th { padding: .4rem .8rem; text-align: left; vertical-align: top; border-top: 1px solid #8884; }
img { image-rendering: pixelated; display: block; }
.exact, .match { color: #2a8; } .near { color: #c80; } .wrong, .fail { color: #d33; } .oracle { color: #888; }
nav label { margin-right: 1rem; }
"""

_SCRIPT = """
for (const box of document.querySelectorAll('nav input'))
  box.addEventListener('change', () => {
    for (const row of document.querySelectorAll(`tr[data-kind="${box.value}"]`)) row.hidden = !box.checked;
  });
"""


def write(folder: Path, rows: list, summary: str, regressions: list[str]) -> Path:
    """Writes `index.html` and its pictures into `folder`; returns the page's path."""
    folder.mkdir(parents=True, exist_ok=True)
    kinds = list(dict.fromkeys(row.kind for row in rows))
    boxes = "".join(f'<label><input type="checkbox" value="{html.escape(kind)}" checked> {html.escape(kind)}</label>'
                    for kind in kinds)
    worse = "".join(f"<li>{html.escape(line)}</li>" for line in regressions)
    body = "\n".join(_row(folder, row) for row in rows)
    page = folder / "index.html"
    page.write_text(f"""<!doctype html>
<html lang="en"><meta charset="utf-8"><title>Durer and POV-Ray</title><style>{_STYLE}</style>
<h1>Durer and POV-Ray</h1>
<p>{html.escape(summary)}</p>
{f"<p>Worse than the baseline:</p><ul>{worse}</ul>" if worse else ""}
<nav>{boxes}</nav>
<table>
<tr><th>scene</th><th>POV-Ray</th><th>durer</th><th>difference × 8</th></tr>
{body}
</table>
<script>{_SCRIPT}</script>
</html>
""", "utf-8")
    return page


def _row(folder: Path, row) -> str:
    apart = None
    if row.psnr is not None:
        apart = pictures.difference(row.oracle, row.durer)
    cells = "".join(f"<td>{_image(folder, row.scene, part, picture)}</td>"
                    for part, picture in (("oracle", row.oracle), ("durer", row.durer), ("difference", apart)))
    decibels = "" if row.psnr is None else f" {pictures.text(row.psnr)} dB"
    style = row.kind if " " not in row.kind else "oracle"
    return (f'<tr data-kind="{html.escape(row.kind)}"><td><strong>{html.escape(row.scene)}</strong><br>'
            f'<span class="{style}">{html.escape(row.kind)}{decibels}</span><br>'
            f"{row.oracle_time:.2f} s, {row.durer_time:.2f} s<br>{html.escape(row.note)}</td>{cells}</tr>")


def _image(folder: Path, scene: str, part: str, picture: png.Picture | None) -> str:
    if picture is None:
        return ""
    name = f"{scene.replace('/', '--').removesuffix('.pov')}.{part}.png"
    (folder / name).write_bytes(png.encode(picture))
    return f'<img src="{html.escape(name)}" alt="{part}" width="{picture.width}" height="{picture.height}">'
