// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// Full strength at the fade distance, twice as much close by; two powers; parallel light fades too.
camera { location <0, 5, -4> look_at <0, 0, 0.2> angle 54 }
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0 } }
light_source { <-1.6, 0.8, 0.6> rgb <1, 0.7, 0.4> fade_distance 0.7 fade_power 2 }
light_source { <1.6, 0.8, 0.6> rgb <0.4, 0.7, 1> fade_distance 0.7 fade_power 5 }
light_source { <0, 3, -2.5> rgb <0.06, 0.12, 0.06> fade_distance 2 fade_power 1 parallel point_at <0, 0, -1> }
sphere { <0, 0.4, 0.4>, 0.4 pigment { rgb 0.9 } }
