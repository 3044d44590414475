// golden: +W96 +H72 -A; psnr >= 50; textures that lie on the surface, and move with it or not
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 angle 50 }
light_source { <5, 8, -9> 1 }
plane { y, -1 pigment { checker rgb 1 rgb .3 } }
#declare Card = mesh2 {
  vertex_vectors { 4, <-1, -1, 0>, <1, -1, 0>, <1, 1, 0>, <-1, 1, 0> }
  uv_vectors { 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }
  face_indices { 2, <0, 1, 2>, <0, 2, 3> }
}
// of the object: whatever moves it does not move the pattern
object { Card uv_mapping pigment { checker rgb 1 rgb x scale .2 } rotate 40*y translate -x }
// of the pigment: what stands in it counts, what stands in the texture does not
object {
  Card rotate -40*y translate x
  texture { pigment { uv_mapping gradient x color_map { [0 rgb x] [1 rgb y] } scale .5 } scale 7 }
}
mesh {
  triangle { <-.5, -1, -1>, <.5, -1, -1>, <0, 0, -1> uv_vectors <0, 0>, <3, 0>, <0, 3> }
  uv_mapping texture { pigment { checker rgb 1 rgb z scale .3 } }
}
// One pair for all corners, and indices of their own.
mesh2 {
  vertex_vectors { 3, <-2, -1, -.6>, <-1, -1, -.6>, <-1.5, 0, -.6> }
  uv_vectors { 5, <0, 0>, <2, 0>, <0, 2>, <9, 9>, <7, 7> }
  face_indices { 1, <0, 1, 2> } uv_indices { 1, <0, 1, 2> }
  uv_mapping pigment { checker rgb 1 rgb <1, 0, 1> scale .3 }
}
// Things without coordinates of their own take the world's x and y.
cylinder { <-.3, 1, 0>, <.3, 1, 0>, .3 pigment { uv_mapping checker rgb 1 rgb z scale .1 } }
union {
  cylinder { <1, 1, 0>, <1.3, 1, 0>, .3 }
  cone { <1.4, 1, 0>, .3, <1.6, 1, 0>, .1 }
  uv_mapping pigment { checker rgb 1 rgb <1, 1, 0> scale .1 } translate <.1, .1, 0>
}
