// golden: +W128 +H96 -A; psnr >= 45; roots by another solver
#version 3.7;
global_settings { assumed_gamma 1 }
// Closed and open, turned and scaled, in solid geometry, with surface coordinates on side and ends.
camera { location <0.3, 5, -9> look_at <0, 0.6, -0.2> angle 40 }
light_source { <-4, 9, -7> rgb 1 }
#declare Vase = sor { 8, <0.4, -0.2>, <0.5, 0>, <0.9, 0.5>, <0.6, 1.1>, <0.25, 1.4>, <0.3, 1.6>, <0.55, 1.8>, <0.7, 2> }
#declare Two = texture { pigment { checker rgb <0.9, 0.6, 0.2> rgb <0.3, 0.5, 0.9> scale 0.2 } finish { phong 0.4 } }
object { Vase texture { Two } translate <-2.2, 0, 1.2> }
sor { 6, <0.4, -0.2>, <0.5, 0>, <0.9, 0.5>, <0.6, 1.1>, <0.9, 1.5>, <1, 1.8> open
  texture { pigment { rgb <0.4, 0.8, 0.4> } finish { specular 0.5 } } interior_texture { pigment { rgb <0.8, 0.8, 0.2> } }
  rotate <-20, 0, 10> translate <2.1, 0, 1> }
sor { 5, <0.1, -0.5>, <0.9, 0>, <0.4, 0.6>, <0.7, 1>, <0.1, 1.5> uv_mapping pigment { checker rgb 1 rgb <0.7, 0.2, 0.3> scale 1/8 }
  rotate -70*x translate <0, 0.9, 1> }
difference {
  object { Vase pigment { rgb <0.9, 0.4, 0.7> } }
  sor { 5, <0.5, -1>, <0.3, 0.2>, <0.5, 1>, <0.15, 2>, <0.3, 3> texture { Two } }
  plane { z, 0 rotate 20*y pigment { rgb 0.9 } }
  scale <1, 0.8, 1.3> rotate 15*z translate <0.3, 0, -1.8>
}
plane { y, -0.2 pigment { rgb 0.7 } }
