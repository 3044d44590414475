// golden: +W96 +H72 -A; psnr >= 45; edges of a checkered sky; last bits of angles
#version 3.7;
global_settings { assumed_gamma 1 }
camera { ultra_wide_angle location <1, 2, -3> right x * 4/3 look_at <2, 1.8, 0> angle 150 }
sky_sphere { pigment { checker rgb <0.9, 0.8, 0.6>, rgb <0.2, 0.4, 0.7> scale 0.17 } }
#for (I, 0, 11) sphere { vrotate(<0, 0.4 * mod(I, 3) - 0.5, 3>, <0, 30 * I, 0>) + <1, 2, -3>, 0.45 pigment { rgb <mod(I, 2), I / 11, 0.3> } finish { ambient 0.4 } } #end
light_source { <1, 6, -3> rgb 1 }
