// golden: +W128 +H96 -A; psnr >= 45; the arc is found by another solver
#version 3.7;
global_settings { assumed_gamma 1 }
// Eggs of several kinds, turned and scaled, in solid geometry, with surface coordinates.
camera { location <0.3, 5, -9> look_at <0, 0.6, -0.2> angle 40 }
light_source { <-4, 9, -7> rgb 1 }
#declare Two = texture { pigment { checker rgb <0.9, 0.6, 0.2> rgb <0.3, 0.5, 0.9> scale 0.2 } finish { phong 0.4 } }
ovus { 0.8, 0.5 texture { Two } translate <-2.2, 0.6, 1.2> }
ovus { 0.5, 0.7 uv_mapping pigment { checker rgb 1 rgb <0.7, 0.2, 0.3> scale 1/8 } rotate <-30, 0, 20> translate <0, 0.6, 1.5> }
ovus { 0.8, 0.1 sturm pigment { rgb <0.4, 0.8, 0.4> } scale <1, 0.7, 1> rotate 40*z translate <2.3, 0.5, 1> }
difference {
  ovus { 0.9, 0.6 pigment { rgb <0.9, 0.4, 0.7> } }
  ovus { 0.4, 0.5 translate <0.2, 0.3, -0.7> texture { Two } }
  plane { x, -0.5 }
  translate <0.1, 0.6, -1.4>
}
plane { y, -0.3 pigment { rgb 0.7 } }
