// golden: +W96 +H72 -A; psnr >= 35; both gather with noise of their own
#version 3.7;
// How densely light is gathered beforehand, and how far a sample may serve.
global_settings { assumed_gamma 1
  radiosity { count 500 nearest_count 12 error_bound 0.4 recursion_limit 2 pretrace_start 0.1 pretrace_end 0.02
    low_error_factor 0.7 minimum_reuse 0.01 maximum_reuse 0.12 adc_bailout 0.02 } }
camera { location <0, 2, -6> look_at <0, 0.6, 0> angle 45 }
light_source { <4, 5, -4> rgb 0.8 }
#default { finish { diffuse 0.7 } }
plane { y, 0 pigment { rgb 0.8 } }
plane { -z, -3 pigment { rgb <0.5, 0.7, 0.9> } }
sphere { <-1.6, 0.8, 0>, 0.8 pigment { rgb <0.9, 0.3, 0.2> } }
box { <0.4, 0, -0.6>, <1.6, 1.3, 0.6> rotate 20*y pigment { rgb <0.9, 0.8, 0.3> } }
cylinder { <2.3, 0, -1>, <2.3, 1.6, -1>, 0.3 pigment { rgb 0.9 } }
