// golden: +W120 +H80 -A; psnr >= 50; clipped_by on surfaces of every sort, and where it has no effect
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0, 0> angle 50 }
light_source { <10, 20, -10> 1 }
background { rgb <.2, .3, .4> }
#default { pigment { rgb <1, .8, .5> } }
#declare Patch = bicubic_patch {
  type 1 flatness 0 u_steps 3 v_steps 3
  <-1, -1, 0>, <-.3, -1, 1>, <.3, -1, -1>, <1, -1, 0>, <-1, -.3, 0>, <-.3, -.3, 1>, <.3, -.3, -1>, <1, -.3, 0>,
  <-1, .3, 0>, <-.3, .3, 1>, <.3, .3, -1>, <1, .3, 0>, <-1, 1, 0>, <-.3, 1, 1>, <.3, 1, -1>, <1, 1, 0>
}
#macro Cut(O, At) object { O clipped_by { plane { x, .2 rotate 30*z } } translate At } #end
Cut(Patch, <-3, 1.2, 0>)
union { object { Patch } clipped_by { plane { x, .2 rotate 30*z } } translate <-.8, 1.2, 0> }
Cut(mesh { triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> } triangle { <-1, -1, 1>, <1, -1, 0>, <0, 1, 0> } }, <1.4, 1.2, 0>)
Cut(height_field { function 9, 9 { x*y } scale 2 translate -1 }, <-3, -1.2, 0>)
Cut(blob { threshold .3 sphere { 0, 1.4, 1 } sphere { y, 1, -1 } }, <-.8, -1.2, 0>)
Cut(polygon { 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> }, <1.4, -1.2, 0>)
Cut(lathe { linear_spline 3, <.2, -1>, <1, 0>, <.5, 1> }, <3.6, -1.2, 0>)
