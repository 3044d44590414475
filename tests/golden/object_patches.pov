// golden: +W128 +H96 -A; psnr >= 42; patches are triangles in single precision here
#version 3.7;
global_settings { assumed_gamma 1 }
// Polygons with holes and star shapes, patches coarse and fine, cut and with surface coordinates.
camera { location <0.3, 5, -9> look_at <0, 0.6, -0.2> angle 40 }
light_source { <-4, 9, -7> rgb 1 }
#declare Two = texture { pigment { checker rgb <0.9, 0.6, 0.2> rgb <0.3, 0.5, 0.9> scale 0.2 } finish { phong 0.4 } }
polygon { 9, <-1, -1, 0>, <1, -1, 0>, <1, 1, 0>, <-1, 1, 0>, <-1, -1, 0>, <-0.5, -0.5, 0>, <0.5, -0.5, 0>, <0, 0.5, 0>, <-0.5, -0.5, 0>
  texture { Two } rotate <40, 20, 0> translate <-2, 0.8, 1> }
polygon { 6, <0, 1, 0>, <0.6, -0.8, 0>, <-1, 0.3, 0>, <1, 0.3, 0>, <-0.6, -0.8, 0>, <0, 1, 0>
  texture { pigment { rgb <0.9, 0.3, 0.3> } } interior_texture { pigment { rgb <0.3, 0.3, 0.9> } } rotate <30, 0, 0> translate <0.3, 1, 1.5> }
#macro Net(S)
  <0, 0, 0>, <1, 0, S>, <2, 0, -S>, <3, 0, 0>, <0, 1, S>, <1, 1, 1>, <2, 1, 1>, <3, 1, 0>,
  <0, 2, -S>, <1, 2, 1>, <2, 2, 1>, <3, 2, S>, <0, 3, 0>, <1, 3, 0>, <2, 3, 0>, <3, 3, -0.5>
#end
bicubic_patch { type 1 u_steps 4 v_steps 4 flatness 0.005 Net(0.5) uv_mapping pigment { checker rgb 1 rgb <0.2, 0.5, 0.2> scale 1/8 }
  finish { phong 0.5 } scale 0.6 rotate 30*x translate <1.2, -0.2, -0.2> }
bicubic_patch { type 0 u_steps 1 v_steps 2 Net(-0.5) pigment { rgb <0.4, 0.8, 0.8> } scale 0.5 rotate <70, 0, 20> translate <-1.5, 0.2, -2.4> }
polygon { 4, <-0.6, 0, 0>, <0.6, 0, 0>, <0.6, 1.2, 0>, <-0.6, 1.2, 0> pigment { rgb <0.9, 0.4, 0.7> }
  clipped_by { sphere { <0, 0.6, 0>, 0.6 inverse } } rotate <20, -30, 0> translate <0, -0.2, -1.6> }
plane { y, -0.3 pigment { rgb 0.7 } }
