// golden: +W96 +H72 -A; psnr >= 50; shared vertices and normals, and faces that share them not
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <5, 8, -9> 1 }
plane { y, -1 pigment { checker rgb 1 rgb .3 } }
#declare Corners = array[5] { <-1, -1, -1>, <1, -1, -1>, <1, -1, 1>, <-1, -1, 1>, <0, 1, 0> };
mesh2 {
  vertex_vectors { 5, #local I = 0; #while (I < 5) Corners[I], #local I = I + 1; #end }
  face_indices { 6, <0, 1, 4>, <1, 2, 4>, <2, 3, 4>, <3, 0, 4>, <0, 1, 2>, <0, 2, 3> }
  inside_vector y
  pigment { rgb <1, .5, .2> } finish { phong .5 reflection .2 } rotate 20*y
}
// Normals of the vertices' own numbers, and normals by number with fewer rows than faces.
mesh2 {
  vertex_vectors { 4, <-2, -1, -.5>, <-1, -1, -.5>, <-1.5, 1, -.5>, <-2.5, .5, -.5> }
  normal_vectors { 4, <-1, 0, -1>, <1, 0, -1>, <0, 1, -1>, <-1, 1, -1> }
  face_indices { 2, <0, 1, 2>, <0, 2, 3> }
  pigment { rgb <.2, 1, .3> } finish { phong .7 }
}
mesh2 {
  vertex_vectors { 4, <1, -1, -.5>, <2, -1, -.5>, <1.5, 1, -.5>, <.7, .5, -.5> }
  normal_vectors { 3, <-1, 0, -1>, <1, 0, -1>, 0 }
  face_indices { 3, <0, 1, 2>, <0, 2, 3>, <0, 0, 1> }
  normal_indices { 1, <0, 1, 2> }
  pigment { rgb <.2, .5, 1> } finish { phong .7 }
}
