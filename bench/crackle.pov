// bench: +W1280 +H960 -A; noise: crackle as pigment and as normal, solid, and with other metrics
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at <0, 0.4, 0> angle 44 }
light_source { <-8, 12, -6> rgb 1 }
#for (I, -2, 2)
  sphere { <I*1.4, 0.6, 0>, 0.6
    pigment { crackle solid color_map { [0 rgb <0.2, 0.3, 0.5>] [1 rgb <0.9, 0.8, 0.6>] } scale 0.12 }
    normal { crackle 0.6 form <1, 0, 0> scale 0.12 }
    finish { specular 0.4 }
  }
  box { -0.5, 0.5 rotate 35*y translate <I*1.4, 0.5, 1.8> pigment { crackle metric 1 form <0, 1, 0> scale 0.2 } normal { crackle 0.4 metric 3 scale 0.2 } }
#end
plane { y, 0
  pigment { crackle turbulence 0.2 color_map { [0 rgb 0.1] [0.1 rgb <0.5, 0.4, 0.3>] [1 rgb <0.9, 0.8, 0.7>] } scale 0.5 }
  normal { crackle 0.8 scale 0.5 }
}
