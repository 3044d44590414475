// golden: +W128 +H96 -A; psnr >= 40; single pixels where checks and shadows end
#version 3.7;
global_settings { assumed_gamma 1 }
// From a grey picture, a coloured one and functions; smooth or not, with water, in solid geometry.
camera { location <0.3, 6, -9> look_at <0, 0, -0.2> angle 42 }
light_source { <-4, 9, -7> rgb 1 }
#declare Two = texture { pigment { checker rgb <0.9, 0.6, 0.2> rgb <0.3, 0.5, 0.9> scale 0.2 } finish { phong 0.4 } }
height_field { png "include/hills.png" smooth texture { Two } translate <-0.5, 0, -0.5> scale <2.6, 0.8, 2.4> rotate 20*y translate <-2.2, 0, 1.6> }
height_field { png "object_sphere" water_level 0.2 pigment { rgb <0.8, 0.3, 0.3> } translate -0.5 scale <2.2, 0.5, 2> rotate <-20, 0, 0> translate <0.8, 0.4, 1.9> }
height_field { function 40, 30 { 0.5 + 0.4*sin(12*x)*cos(9*y) } texture { pigment { rgb <0.4, 0.8, 0.4> } finish { specular 0.5 } }
  translate -0.5 scale <2, 0.7, 2> rotate 10*z translate <2.6, 0.2, -0.3> }
difference {
  box { <-0.1, -0.6, -0.1>, <1.1, 1, 1.1> pigment { rgb <0.9, 0.4, 0.7> } }
  height_field { function 20, 20 { pow(x - 0.5, 2) + pow(y - 0.5, 2) + 0.3 } smooth inverse texture { Two } scale <1, 0.9, 1> }
  translate -0.5 scale <2, 1, 2> rotate 25*y translate <-1.6, 0.2, -1.8>
}
intersection {
  height_field { function 12, 12 { 0.3 + 0.5*x*y } pigment { rgb <0.5, 0.7, 0.9> } }
  box { <0.1, -0.2, 0.1>, <0.9, 0.45, 0.9> texture { Two } }
  translate -0.5 scale <2, 1.4, 2> translate <1.2, 0, -2>
}
plane { y, -0.7 pigment { rgb 0.7 } }
