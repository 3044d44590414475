#!/usr/bin/env python3
"""Regenerates internals.tsv: values of the internal functions as the reference program prints them.

Run it in its own folder, with `povray` on the path. One line of the table:
number, parameters, x, y, z, value, separated by tabs; parameters by spaces."""
import pathlib
import re
import subprocess
import tempfile

HERE = pathlib.Path(__file__).parent
POINTS = ["0.3, -0.7, 1.1", "-1.25, 0.4, 0.6", "0, 0, 0", "0, 0.8, 0", "0.05, 0.35, -0.62",
          "2.4, -1.9, -3.3", "-0.41, -0.13, 0.02"]
SETS = [
    ("f_algbr_cyl1", "0.7, 3, 0, 0.3, 20"),
    ("f_algbr_cyl1", "0.7, 3, 1, 0.3, 20"),
    ("f_algbr_cyl2", "0.7, 3, 0, 0.3, 20"),
    ("f_algbr_cyl2", "0.7, 3, 1, 0.3, 20"),
    ("f_algbr_cyl3", "0.7, 3, 0, 0.3, 20"),
    ("f_algbr_cyl3", "0.7, 3, 1, 0.3, 20"),
    ("f_algbr_cyl4", "0.7, 3, 0, 0.3, 20"),
    ("f_algbr_cyl4", "0.7, 3, 1, 0.3, 20"),
    ("f_bicorn", "0.5, 1"),
    ("f_bicorn", "2, 1.3"),
    ("f_bifolia", "1, 3"),
    ("f_bifolia", "0.3, 2"),
    ("f_blob", "1, 1.2, 0.8, 1.5, 0.9"),
    ("f_blob", "2, 1, 0.5, 1, 0.4"),
    ("f_blob2", "1.2, 0.8, 1.1, 0.3"),
    ("f_boy_surface", "0.001, 1"),
    ("f_boy_surface", "0.0005, 1.5"),
    ("f_comma", "1"),
    ("f_comma", "2.5"),
    ("f_cross_ellipsoids", "0.3, 1.1, 1.3, 0.6"),
    ("f_isect_ellipsoids", "0.3, 1.1, 1.3, 0.6"),
    ("f_flange_cover", "0.3, 1.1, 1.3, 0.6"),
    ("f_crossed_trough", "1"),
    ("f_cubic_saddle", "1"),
    ("f_cubic_saddle", "-2"),
    ("f_cushion", "1"),
    ("f_odd", "1"),
    ("f_devils_curve", "1"),
    ("f_devils_curve_2d", "1, 1.2, 0.7, 0, 0.3, 20"),
    ("f_devils_curve_2d", "1, 1.2, 0.7, 1, 0.3, 20"),
    ("f_dupin_cyclid", "0.0001, 3, 1, 0.5, 0.3, 4"),
    ("f_dupin_cyclid", "0.001, 1.5, 0.5, 1, 0.2, 2"),
    ("f_ellipsoid", "1, 2, 0.5"),
    ("f_enneper", "1"),
    ("f_folium_surface", "1, 0.4, 0.8"),
    ("f_folium_surface_2d", "1, 0.4, 0.8, 0, 0.3, 20"),
    ("f_folium_surface_2d", "1, 0.4, 0.8, 1, 0.3, 20"),
    ("f_glob", "1"),
    ("f_heart", "1"),
    ("f_helical_torus", "1, 6, 2, 0.2, 0.3, 0.5, 1.5, 4, 0.2, 0.3"),
    ("f_helix1", "2, 4, 0.2, 0.8, 1, 1, 0"),
    ("f_helix1", "1, 3, 0.2, 0.6, 1.5, 0.5, 30"),
    ("f_helix2", "0, 4, 0.2, 0.1, 0, 1, 0"),
    ("f_helix2", "0, 3, 0.3, 0.2, 0, 0.5, 40"),
    ("f_hex_x", "1"),
    ("f_hex_y", "1"),
    ("f_hetero_mf", "0.5, 2, 4.5, 0.7, 1, 2"),
    ("f_hetero_mf", "0.1, 3, 7, 0.7, 0.7, 3"),
    ("f_hunt_surface", "0.001"),
    ("f_hyperbolic_torus", "1, 0.6, 0.3"),
    ("f_kampyle_of_eudoxus", "1, 0.3, 0.8"),
    ("f_kampyle_of_eudoxus_2d", "1, 0.3, 0.8, 0, 0.3, 20"),
    ("f_kampyle_of_eudoxus_2d", "1, 0.3, 0.8, 1, 0.3, 20"),
    ("f_klein_bottle", "0.1"),
    ("f_kummer_surface_v1", "1"),
    ("f_kummer_surface_v2", "1, -0.7, -0.9, 0.4"),
    ("f_lemniscate_of_gerono", "1"),
    ("f_lemniscate_of_gerono_2d", "1, 1.2, 0.6, 0, 0.3, 20"),
    ("f_lemniscate_of_gerono_2d", "1, 1.2, 0.6, 1, 0.3, 20"),
    ("f_mesh1", "0.5, 0.6, 1, 0.2, 1.1"),
    ("f_mesh1", "0.15, 0.15, 1, 0.02, 1"),
    ("f_mitre", "1"),
    ("f_nodal_cubic", "1"),
    ("f_ovals_of_cassini", "1, 0.6, 0.4, 3"),
    ("f_paraboloid", "1"),
    ("f_parabolic_torus", "1, 0.6, 0.3"),
    ("f_ph", ""),
    ("f_pillow", "1"),
    ("f_piriform", "1"),
    ("f_piriform_2d", "1, 1.1, -0.8, 0.9, 0, 0.3, 20"),
    ("f_piriform_2d", "1, 1.1, -0.8, 0.9, 1, 0.3, 20"),
    ("f_poly4", "0.2, 0.1, 0.3, -0.2, 0.05"),
    ("f_poly4", "-9, 1, 0, 0, 0"),
    ("f_polytubes", "5, 0.2, 0.1, 0.3, -0.2, 0.05"),
    ("f_quantum", "1"),
    ("f_quartic_paraboloid", "1"),
    ("f_quartic_saddle", "1"),
    ("f_quartic_cylinder", "1, 0.9, 0.5"),
    ("f_r", ""),
    ("f_ridge", "2, 4, 0.5, 0.3, 0.6, 2"),
    ("f_ridge", "2.2, 4.6, 0.6, 0.7, 0.4, 3"),
    ("f_ridged_mf", "1.1, 2.1, 7, 0.7, 0.8, 2"),
    ("f_rounded_box", "0.2, 0.8, 0.7, 0.6"),
    ("f_rounded_box", "0, 0.5, 0.5, 0.5"),
    ("f_sphere", "1"),
    ("f_spikes", "0.1, 1.2, 1.3, 0.8, 0.9"),
    ("f_spikes_2d", "1, 4, 5, 0.6"),
    ("f_spiral", "0.3, 0.1, 1.4, 0, 0, 1"),
    ("f_spiral", "0.4, 0.1, 1.5, 0, 0, 0.5"),
    ("f_steiners_roman", "1"),
    ("f_strophoid", "1, 0.8, 0.4, 0.9"),
    ("f_strophoid_2d", "1, 0.8, 0.4, 0.9, 0, 0.3, 20"),
    ("f_strophoid_2d", "1, 0.8, 0.4, 0.9, 1, 0.3, 20"),
    ("f_superellipsoid", "0.3, 0.6"),
    ("f_superellipsoid", "1, 1"),
    ("f_th", ""),
    ("f_torus", "0.9, 0.3"),
    ("f_torus2", "1, 0.9, 0.3"),
    ("f_torus_gumdrop", "0.1"),
    ("f_umbrella", "1"),
    ("f_witch_of_agnesi", "1, 0.4"),
    ("f_witch_of_agnesi_2d", "1, 0.4, 0.6, 0, 0.3, 20"),
    ("f_witch_of_agnesi_2d", "1, 0.4, 0.6, 1, 0.3, 20"),
    ("f_noise3d", ""),
    ("f_noise_generator", "1"),
    ("f_noise_generator", "2"),
    ("f_heart", "-0.05"),
    ("f_superellipsoid", "2, 0.5"),
    ("f_helix1", "3, 2, 0.1, 0.5, 0.5, 0, 45"),
    ("f_helix1", "2, 3, 0.1, 0.5, 1, 2, 0"),
    ("f_helix2", "0, 2, 0.1, 0.4, 0, 2, 0"),
    ("f_spiral", "0.3, 0.1, 1.4, 0, 0, 0"),
    ("f_ridged_mf", "0.1, 3, 7, 0.7, 0.7, 3"),
    ("f_ridged_mf", "0.5, 2.1, 4.5, 1, 2, 1"),
    ("f_ridge", "2, 6, 0.5, 0.6, 0.5, 1"),
    ("f_hetero_mf", "0.7, 2.2, 5, 0.5, 2, 2"),
    ("f_hetero_mf", "0.7, 2.2, 5, 0.5, 0, 1"),
    ("f_noise_generator", "3"),
    ("f_noise_generator", "0"),
    ("f_noise_generator", "6.9"),
    ("f_polytubes", "0, 0.2, 0.1, 0.3, -0.2, 0.05"),
    ("f_polytubes", "3.5, 0.5, 0, 0.1, 0, 0"),
    ("f_rounded_box", "0.5, 0.4, 0.4, 0.4"),
    ("f_quantum", "2"),
    ("f_torus", "1, 0.25"),
    ("f_algbr_cyl1", "-0.7, 2, 1, 0, -30"),
    ("f_blob2", "0.5, 2, 1, 0.1"),
    ("f_mesh1", "0.3, 0.2, 0.5, 0.1, 1"),
    ("f_pattern", ""),
]


def numbers():
    """Name of each internal function to its number and count of extra parameters."""
    text = (HERE / "../../../functions/internals.def").read_text()
    entries = re.findall(r"DURER_INTERNAL\((\w+), +(\d+)", text)
    return {name: (i, int(extra)) for i, (name, extra) in enumerate(entries)}


def ask(scene_lines):
    """The lines that the scene writes to the debug stream."""
    with tempfile.TemporaryDirectory() as folder:
        scene = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n" + "\n".join(scene_lines)
        (pathlib.Path(folder) / "ask.pov").write_text(scene)
        run = subprocess.run(["povray", "+Iask.pov", "-D", "-F", "+W1", "+H1", "-GR", "-GS", "-GW"],
                             cwd=folder, capture_output=True, text=True, check=False)
    return [line[1:] for line in run.stderr.split("\n") if line.startswith("@")]


def evaluate(number, parameters):
    """Values at all points. Every set has its own run: f_ridged_mf keeps its first weights."""
    call = ", ".join(filter(None, ["%s", parameters]))
    lines = ["#declare F = function { internal(%d) }" % number]
    lines += ['#debug concat("@", str(F(%s), 0, 16), "\\n")' % (call % point) for point in POINTS]
    values = ask(lines + ["sphere { 0, 1 }"])
    assert len(values) == len(POINTS), (number, parameters)
    return values


def main():
    known = numbers()
    rows = []
    for name, parameters in SETS:
        number, extra = known[name]
        assert len([p for p in parameters.split(",") if p.strip()]) == extra, name
        for point, value in zip(POINTS, evaluate(number, parameters)):
            fields = [str(number), parameters.replace(",", "")] + point.split(", ") + [value]
            rows.append("\t".join(fields))
    (HERE / "internals.tsv").write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
