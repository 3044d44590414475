// golden: +W96 +H72 -A; psnr >= 50; shading formulas are given exactly
#version 3.7;
global_settings { assumed_gamma 1 }
// Soft and hard edges, tightness, and a cone that misses its point by moving.
camera { location <0, 5, -5> look_at <0, 0, 0.2> angle 50 }
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0.02 } }
light_source { <-1.6, 3, 0.9> rgb <1, 0.9, 0.6> spotlight radius 8 falloff 20 point_at <-1.6, 0, 0.9> }
light_source { <0.2, 3, 0.9> rgb <0.6, 0.9, 1> spotlight point_at <0.2, 0, 0.9> radius 16 falloff 16.5 }
light_source { <1.9, 3, 0.9> rgb 1 spotlight radius 5 falloff 25 tightness 30 point_at <1.7, 0, 0.9> }
light_source { <-4, 2.5, -3> rgb <1, 0.5, 0.4> spotlight radius 7 falloff 14 tightness 2 point_at <-0.6, 0, -1.2> }
light_source { 0, rgb <0.5, 1, 0.5> spotlight radius 10 falloff 14 point_at -y translate <1.4, 3, -1.2> }
sphere { <-0.6, 0.4, -1.1>, 0.4 pigment { rgb 0.9 } }
cone { <1.5, 0, -1.2>, 0.3, <1.5, 0.8, -1.2>, 0 pigment { rgb 0.9 } }
