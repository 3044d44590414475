// golden: +W96 +H72 -A; psnr >= 36; both gather with noise of their own
#version 3.7;
// Bumps in indirect light, diffuse backsides and layers.
global_settings { assumed_gamma 1 radiosity { count 500 error_bound 0.2 normal on recursion_limit 1 minimum_reuse 0.005 } }
camera { location <0, 3, -6> look_at <0, 0.6, 0> angle 45 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.6, 0.4>] [1 rgb <0.2, 0.4, 0.9>] } } }
plane { y, 0 pigment { rgb 0.8 } normal { gradient x 0.8 scale 1.3 sine_wave } finish { diffuse 0.8 } }
disc { <1.4, 1.2, 0>, <0.3, 0.4, -1>, 0.9 pigment { rgb <0.9, 0.8, 0.3> } finish { diffuse 0.3, 0.7 } }
sphere { <-1.2, 1, 0>, 0.9 texture { pigment { rgb <0.3, 0.7, 0.4> } finish { diffuse 0.8 } }
  texture { pigment { gradient y color_map { [0.5 rgbt 1] [0.5 rgb 0.9] } scale 0.5 } finish { diffuse 0.5 } } }
