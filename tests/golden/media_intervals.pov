// golden: +W64 +H48 -A; psnr >= 60; exact: lit parts of a ray get their share of the intervals
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 50 }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { y, -1 pigment { rgb 0.7 } hollow }
plane { z, 5 inverse pigment { rgb 0.7 } hollow finish { ambient 0.1 } }
light_source { <3, 4, -2>, 1.5 spotlight point_at <0, -1, 0> radius 10 falloff 15 }
light_source { <-3, 4, -2>, <0.4, 0.6, 1> spotlight point_at <1, -1, 0> radius 10 falloff 12 tightness 4 }
light_source { <0, 1, -1>, 1 spotlight point_at <0, 1, 10> radius 10 falloff 12 tightness 4 }
media { scattering { 1, 0.05 extinction 0.7 } intervals 7 ratio 0.6 }
