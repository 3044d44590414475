// bench: +W480 +H360 -A; a spotlit fog: scattering media in a room with columns
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -9> look_at <0, 1.6, 0> angle 52 }
light_source { <-4, 7, -3> rgb 2.2 spotlight point_at <0.5, 0, 1> radius 14 falloff 20 media_interaction on }
light_source { <6, 5, -8> rgb 0.15 media_interaction off }
plane { y, 0 pigment { checker rgb 0.6, rgb 0.35 } }
#for (I, 0, 6)
  cylinder { <1.3*I - 4, 0, 1 + mod(I, 2)*1.4>, <1.3*I - 4, 4.5, 1 + mod(I, 2)*1.4>, 0.16
    pigment { rgb <0.8, 0.7, 0.55> } }
#end
sphere { <0.4, 0.9, 0.2>, 0.9 pigment { rgb <0.3, 0.5, 0.8> } finish { phong 0.6 } }
box { <-7, 0, -4>, <7, 8, 6> hollow pigment { rgbt 1 }
  interior { media { scattering { 1, rgb 0.05 extinction 0.6 } method 3 intervals 1 samples 24, 24 } } }
