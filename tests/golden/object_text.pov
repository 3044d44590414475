// golden: +W160 +H96 -A; psnr >= 40; rays along the edges of letters may go either way
// needs: timrom.ttf
#version 3.7;
global_settings { assumed_gamma 1 }
// Three of the built-in fonts, kerning and offsets, thick and thin, in solid geometry.
camera { location <0.3, 2, -7> look_at <0, 0.6, 0> angle 46 }
light_source { <-4, 9, -7> rgb 1 }
#declare Two = texture { pigment { checker rgb <0.9, 0.6, 0.2> rgb <0.3, 0.5, 0.9> scale 0.1 } finish { phong 0.4 } }
text { ttf "timrom.ttf" "AVA Type g&8%" 0.3, 0 texture { Two } scale 0.8 rotate 10*y translate <-2.6, 1.5, 0> }
text { internal 2 "Blind, Quad" 1, <0.05, 0.02, 3> pigment { rgb <0.8, 0.3, 0.3> } scale <0.6, 0.7, 0.4> rotate <15, -20, 0> translate <-2.4, 0.75, -0.3> }
text { internal 3 "(fix) @\n" 0.1, -0.1*x pigment { rgb <0.4, 0.8, 0.4> } scale 0.8 translate <0.7, 0.7, -0.5> }
difference {
  box { <-2.4, -0.2, 0>, <0.3, 0.6, 0.5> pigment { rgb <0.9, 0.4, 0.7> } }
  text { internal 1 "Carve" 0.4, 0 translate <-2.2, 0, -0.2> texture { Two } }
  rotate <10, 5, 0>
}
intersection {
  text { internal 1 "OSo" 1, 0 scale 1.1 pigment { rgb <0.5, 0.7, 0.9> } }
  sphere { <0.9, 0.2, 0.4>, 0.9 texture { Two } }
  rotate <-20, 15, 0> translate <0.6, -0.3, -0.5>
}
plane { y, -0.7 pigment { rgb 0.7 } }
