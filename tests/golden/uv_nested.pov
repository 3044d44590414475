// golden: +W96 +H72 -A; psnr >= 50; what lies on the surface inside of patterns, lists and averages
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <3, 2, -10> direction z right 6*x up 4*y }
light_source { <-20, 30, -30> rgb 0.8 }
#default { finish { ambient 0.3 diffuse 0.7 } }
#declare N = 0;
#macro Card(T)
  mesh2 {
    vertex_vectors { 4, <0, 0, 0>, <.95, 0, 0>, <.95, .95, 0>, <0, .95, 0> }
    uv_vectors { 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }
    face_indices { 2, <0, 1, 2>, <0, 2, 3> }
    texture { T }
    translate <mod(N, 3)*2 + .5, div(N, 3) + .03, 0>
  }
  #declare N = N + 1;
#end
#declare A = texture { pigment { rgb <1, .3, .2> } }
#declare B = texture { pigment { checker rgb 1 rgb <.2, .3, .8> scale .1 } normal { bumps .6 scale .1 } }
Card(texture { pigment { uv_mapping image_map { png "images/colour.png" } rotate 30*z } })
Card(texture { pigment { gradient x pigment_map { [.3 uv_mapping image_map { png "images/palette.png" }] [.6 rgb <.3, .6, .2>] } scale 2 } })
Card(texture { pigment { checker pigment { uv_mapping gradient x } pigment { uv_mapping gradient y scale .5 } scale .2 } })
Card(texture { pigment { average pigment_map { [1 uv_mapping checker scale .2] [2 bozo scale .2] } } })
Card(texture { pigment { rgb .8 } normal { uv_mapping bump_map { png "images/grey.png" interpolate 2 bump_size 4 } } })
Card(texture { pigment { rgb .8 } normal { gradient x normal_map { [.4 uv_mapping waves 1 scale .1] [.6 bumps 1 scale .1] } } })
Card(texture { uv_mapping material_map { png "images/palette.png" texture { A } texture { B } texture { A } } })
Card(texture { uv_mapping gradient x texture_map { [.4 A] [.6 B] } rotate 90*z })
Card(texture { pigment { pigment_pattern { uv_mapping gradient y } color_map { [0 rgb x] [1 rgb z] } } })
Card(texture { bozo texture_map { [.4 A] [.6 uv_mapping checker texture { A } texture { B } scale .25] } scale .4 })
