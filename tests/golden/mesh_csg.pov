// golden: +W96 +H72 -A; psnr >= 50; meshes with and without an inside, as operands and clips
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 angle 50 }
light_source { <5, 8, -9> 1 }
plane { y, -1 pigment { checker rgb 1 rgb .3 } }
#declare Red = texture { pigment { rgb <1, .2, .1> } finish { phong .6 } }
#declare Tiles = texture { pigment { checker rgb <.1, 1, .2> rgb <.8, 1, .8> scale .25 } finish { reflection .3 } }
#declare Glass = texture { pigment { rgbt <.1, .2, 1, .7> } finish { ambient .3 } }
#macro Pyramid(Inside)
  mesh2 {
    vertex_vectors { 5, <-1, -1, -1>, <1, -1, -1>, <1, -1, 1>, <-1, -1, 1>, <0, 1, 0> }
    face_indices { 6, <0, 1, 4>, <1, 2, 4>, <2, 3, 4>, <3, 0, 4>, <0, 1, 2>, <0, 2, 3> }
    #if (Inside) inside_vector <.1, 1, .23> #end
  }
#end
#declare Solid = Pyramid(yes)
#declare Shell = Pyramid(no)
difference { object { Solid rotate 20*y } sphere { <0, -.3, -.8>, .6 texture { Red } } texture { Tiles } translate -1.2*x }
intersection { object { Solid texture { Red } } sphere { 0, .7 texture { Tiles } } rotate 20*y translate .1*x }
difference {
  sphere { <1.7, 0, 0>, .8 texture { Tiles } }
  object { Solid texture { Red } scale .7 rotate 30*z translate <1.7, .2, -.5> }
}
object { Shell clipped_by { plane { z, 0 } } texture { Red } interior_texture { Tiles } rotate 120*y scale .5 translate <0, 1.4, 1> }
object { Solid clipped_by { plane { z, 0 } } texture { Red } interior_texture { Tiles } rotate 120*y scale .5 translate <1.4, 1.4, 1> }
intersection { object { Shell texture { Red } } box { -1, <1, .3, 1> } scale .5 translate <-1.4, 1.4, 1> }
object { Solid inverse texture { Glass } scale .3 interior_texture { Red } translate <0, -.7, -1.5> }
merge { object { Solid } sphere { 0, .5 } pigment { rgbt .6 } scale .4 translate <-1, -.6, -1.5> }
sphere { <1, -.6, -1.5>, .4 clipped_by { object { Solid scale .5 translate <1, -.6, -1.5> } } texture { Red } }
