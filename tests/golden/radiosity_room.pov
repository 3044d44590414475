// golden: +W96 +H72 -A; psnr >= 38; both gather with noise of their own
#version 3.7;
// Indirect light in a closed room; its walls colour each other. Two bounces.
global_settings { assumed_gamma 1 radiosity { count 200 error_bound 0.4 } }
#default { finish { diffuse 0.8 } }
camera { location <0, 1, -3.8> look_at <0, 0.9, 0> angle 60 }
light_source { <0.5, 1.8, -0.5> rgb 0.8 }
box { <-2, 0, -4>, <2, 2, 2> hollow
  pigment { gradient x translate 0.5*x scale 4.002 translate -4.002*x*0.5
    color_map { [0.002 rgb <0.9, 0.2, 0.2>] [0.002 rgb 0.9] [0.998 rgb 0.9] [0.998 rgb <0.2, 0.9, 0.2>] } } }
sphere { <-0.7, 0.6, 0.4>, 0.6 pigment { rgb 1 } }
box { <0.3, 0, -0.2>, <1.1, 1.1, 0.6> pigment { rgb <0.4, 0.5, 0.9> } }
