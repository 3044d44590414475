// golden: +W96 +H72 -A; psnr >= 50; fog is a formula
#version 3.7;
global_settings { assumed_gamma 1 }
// Ground fog about an axis that leans, with light that it weakens and light that it does not.
camera { location <0, 1, -4> look_at <0, 0, 4> angle 50 }
light_source { <-6, 9, -6> rgb 0.6 media_attenuation on }
light_source { <6, 9, -6> rgb 0.4 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.7, 0.8, 1>] [0.6 rgb <0.1, 0.2, 0.6>] } } }
box { <-4, -1, -1>, <4, -0.9, 30> pigment { checker rgb 0.8, rgb <0.3, 0.35, 0.4> } }
#for (I, 0, 5) sphere { <2 * mod(I, 2) - 1, 0, 1 + 3 * I>, 0.8 pigment { rgb <0.9, 0.5 - 0.05 * I, 0.1 * I> } finish { phong 0.6 } } #end
fog { fog_type 2 distance 3 color rgbt <0.8, 0.8, 0.75, 0.1> fog_offset -0.6 fog_alt 0.35 up y rotate z * 4 }
