// golden: +W120 +H90 -A; psnr >= 45; endless things that others bound: cut, clipped, gated, and turned as a whole
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0, 0> angle 50 }
light_source { <-4, 8, -5> rgb 1 }
plane { y, -2 pigment { checker rgb .7 rgb .3 } }
#declare Hyper = quadric { <1, -1, 1>, 0, 0, -1 }
intersection { object { Hyper scale .5 } plane { y, .9 } plane { -y, .9 } rotate <30, 0, 40> translate <-3, 1, 0> pigment { rgb x + .3 } }
object { Hyper scale .3 clipped_by { plane { y, 1 } plane { -y, 1 } } rotate <-40, 20, 10> translate <-1, 1, 0> pigment { rgb y + .3 } }
difference { quadric { <1, 0, 1>, 0, 0, -.5 } plane { y, -.8 } plane { -y, -.9 rotate 20*z } rotate 50*z translate <1, 1, 0> pigment { rgb z + .3 } }
merge { intersection { quadric { <1, 0, 0>, 0, 0, -.05 } quadric { <0, 1, 0>, 0, 0, -.3 } quadric { <0, 0, 1>, 0, 0, -.3 } rotate <10, 20, 30> } sphere { 0, .4 } translate <3, 1, 0> pigment { rgb <1, 1, .3> } }
quartic { <0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -0.1666, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0.5, 0, -1, 0, 0, 0, 0, 0>
  clipped_by { quadric { <1, 1, 0>, 0, 0, -1 } plane { z, 1.4 } plane { -z, 0 } } bounded_by { clipped_by }
  rotate <50, 20, 10> translate <-2.5, -1, 0> pigment { rgb <1, .3, 1> } }
union {
  quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -1.25, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 0, -1.25, 0, .25> sturm }
  sphere { 0, .3 }
  bounded_by { box { -1.2, 1.2 } } rotate <-30, 20, 0> translate <0, -.8, 0> pigment { rgb <.3, 1, 1> }
}
poly { 4, <1, 0, 0, 0, 2, 0, 0, 2, 0, -1.25, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 0, -1.25, 0, .25>
  bounded_by { sphere { 0, 1.2 } } rotate <-30, 20, 0> translate <2.5, -.8, 0> pigment { rgb <.9, .6, .3> } }
