// golden: +W96 +H72 -A; psnr >= 35; both gather with noise of their own
#version 3.7;
// Unimportant objects are asked less often, and count the more; old scenes add ambient light.
global_settings { radiosity { count 1000, 4000 error_bound 0.4 nearest_count 8, 4 recursion_limit 1 always_sample on } }
camera { location <0, 2, -6> look_at <0, 0.6, 0> angle 45 }
background { rgb <0.5, 0.6, 0.8> }
plane { y, 0 pigment { rgb 0.8 } finish { diffuse 0.7 } }
union { sphere { <-1.2, 1, 0>, 0.6 } box { <0.6, 0.2, -0.5>, <1.6, 1.2, 0.5> }
  pigment { rgb <1, 0.5, 0.2> } finish { diffuse 0.3 emission 0.4 } radiosity { importance 0.3 } }
