// golden: +W96 +H72 -A; psnr >= 50; faces with one texture, three, or that of the mesh
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 angle 50 }
light_source { <5, 8, -9> 1 }
plane { y, -1 pigment { checker rgb 1 rgb .3 } }
#declare Red = texture { pigment { rgb <1, .2, .1> } finish { phong .6 } }
#declare Tiles = texture { pigment { checker rgb <.1, 1, .2> rgb <.8, 1, .8> scale .25 } finish { reflection .3 } }
#declare Glass = texture { pigment { rgbt <.1, .2, 1, .7> } finish { ambient .3 } }
mesh2 {
  vertex_vectors { 5, <-1, -1, -1>, <1, -1, -1>, <1, -1, 1>, <-1, -1, 1>, <0, 1, 0> }
  texture_list { 3, texture { Red } texture { Tiles } texture { Glass } }
  face_indices { 6, <0, 1, 4>, 0, 1, 2, <1, 2, 4>, 1, <2, 3, 4>, 0, <3, 0, 4>, 1, <0, 1, 2>, <0, 2, 3> }
  inside_vector y
  pigment { rgb <1, .5, .2> } rotate 20*y
}
mesh {
  triangle { <-2, -1, 0>, <-1, -1, 0>, <-1.5, 1, 0> texture { Tiles } }
  triangle { <-2, 0, -1>, <-1, 0, -1>, <-1.5, .5, -1> texture_list { Red Tiles Glass } }
  smooth_triangle {
    <1, -1, 0>, <-1, 0, -1>, <2, -1, 0>, <1, 0, -1>, <1.5, 1, 0>, <0, 1, -1>
    texture_list { Glass Red Tiles }
  }
  triangle { <1, 0, -1>, <2, 0, -1>, <1.5, .5, -1> }
  pigment { rgb <.2, 1, .3> } interior_texture { Red } translate .1*x
}
