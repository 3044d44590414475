// golden: +W120 +H80 -A; psnr >= 50; flags of what stands in a union that is not split
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, 0, 0> angle 50 }
light_source { <10, 20, -10> 1 }
plane { y, -1 pigment { rgb .8 } }
box { <-5, -1, 4>, <5, 3, 4.1> pigment { rgb .1 } finish { reflection .6 } }
#declare Three = union {
  sphere { -x, .4 no_shadow pigment { rgb x } }
  sphere { 0, .4 no_image pigment { rgb y } }
  sphere { x, .4 no_reflection pigment { rgb z } }
  pigment { rgb 1 }
}
object { Three translate <-2.5, 0, 2> }
union { object { Three } split_union off translate <.8, 0, 2> }
union { object { Three } bounded_by { sphere { 0, 3 } } translate <-2.5, 0, 0> }
union { object { Three } clipped_by { plane { y, .2 } } translate <.8, 0, 0> }
union { object { Three } plane { y, 0 clipped_by { cylinder { -y, y, .2 } } pigment { rgb 0 } }
  bounded_by { sphere { 0, 3 } } translate <-2.5, 0, -2> }
merge { object { Three } split_union off translate <.8, 0, -2> }
union { union { object { Three } } split_union off no_shadow translate <3.2, 0, 0> scale .9 }
