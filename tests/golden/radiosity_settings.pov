// golden: +W96 +H72 -A; psnr >= 36; both gather with noise of their own
#version 3.7;
// brightness, gray_threshold, max_sample; highlights, area of influence of no_image, no_reflection and no_radiosity.
global_settings { assumed_gamma 1
  radiosity { count 600 error_bound 0.3 recursion_limit 3 brightness 1.4 gray_threshold 0.4 max_sample 1.2 } }
camera { location <0, 2, -6> look_at <0, 0.6, 0> angle 45 }
light_source { <4, 5, -4> rgb 0.6 }
#default { finish { diffuse 0.7 } }
plane { y, 0 pigment { rgb 0.8 } }
plane { -z, -3 pigment { rgb <0.5, 0.7, 0.9> } }
sphere { <-2, 1, 0>, 0.6 pigment { rgb 1 } finish { diffuse 0 emission <3, 1, 0.3> } }
sphere { <0, 0.8, -0.4>, 0.8 pigment { rgb 1 } finish { phong 1 reflection 0.3 } }
sphere { <1.4, 0.5, 1>, 0.5 pigment { rgb 1 } finish { diffuse 0 emission <0, 2, 0.5> } no_radiosity }
sphere { <2.4, 0.5, 0>, 0.5 pigment { rgb 1 } finish { diffuse 0 emission <0.5, 0.2, 2> } no_image }
