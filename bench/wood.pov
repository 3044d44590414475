// bench: +W1280 +H960 -A; noise: balls, boxes and a floor of layered wood and agate
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at <0, 0.4, 0> angle 44 }
light_source { <-8, 12, -6> rgb 0.7 }
light_source { <9, 6, -8> rgb <0.3, 0.3, 0.5> }
#declare Grain =
  texture {
    pigment { wood turbulence 0.08 omega 0.6 octaves 4 color_map { [0 rgb <0.5, 0.3, 0.15>] [0.8 rgb <0.7, 0.45, 0.25>] [1 rgb <0.3, 0.15, 0.05>] } scale 0.15 rotate 3*x }
    finish { specular 0.3 roughness 0.02 }
  }
  texture {
    pigment { agate agate_turb 0.8 color_map { [0 rgbt <0.3, 0.1, 0.05, 0.3>] [0.5 rgbt <0.9, 0.7, 0.4, 0.7>] [1 rgbt 1] } scale 0.6 }
  }
  texture {
    pigment { bozo turbulence <0.5, 0.3, 0.5> octaves 5 lambda 2.2 color_map { [0 rgbt <0, 0, 0, 0.6>] [0.4 rgbt 1] [1 rgbt 1] } scale <0.4, 0.05, 0.05> }
  }
#for (I, -2, 2)
  sphere { <I*1.4, 0.6, 0>, 0.6 texture { Grain rotate 30*I*z } }
  box { -0.5, 0.5 rotate 35*y translate <I*1.4, 0.5, 1.8> texture { Grain } }
#end
plane { y, 0 texture { Grain rotate 90*y scale 1.5 } }
