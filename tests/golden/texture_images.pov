// golden: +W96 +H72 -A; psnr >= 50; material maps, objects and density files as patterns of textures
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <3, 2, -10> direction z right 6*x up 4*y }
light_source { <-20, 30, -30> rgb 0.8 }
light_source { <30, -5, -20> rgb <0.2, 0.1, 0.3> shadowless }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.4 roughness 0.02 } }
#declare N = 0;
#macro Ball(T)
  sphere { 0, 0.48 texture { T } translate <mod(N, 6) + 0.5, div(N, 6) + 0.5, 0> }
  #declare N = N + 1;
#end
#declare A = texture { pigment { rgb <1, .3, .2> } finish { ambient .2 } }
#declare B = texture { pigment { checker rgb 1 rgb <.2, .3, .8> scale .1 } normal { bumps .6 scale .1 } }
#declare C = texture { pigment { rgbt <.3, 1, .4, .4> } finish { specular 1 } }
Ball(texture { material_map { png "images/palette.png" texture { A } texture { B } texture { C } } scale .7 })
Ball(texture { material_map { png "images/palette.png" interpolate 2 texture { A } texture { B } texture { C } texture { A } } })
Ball(texture { material_map { png "images/palette.png" map_type 1 once texture { A } texture { B } texture { C } } })
Ball(texture { material_map { png "images/grey.png" texture { A } texture { B } } })
Ball(texture { material_map { png "images/colour.png" repeat <2, 2> texture { A } texture { B } texture { C } } scale .8 })
Ball(texture { material_map { gif "images/colour.gif" once offset <.2, .1> texture { B } texture { C } } rotate 20 })
Ball(texture { object { sphere { <-.1, .2, -.4>, .3 } texture { A } texture { B } } })
Ball(texture { pigment { object { box { -.25, .25 rotate 40 } rgb <1, .8, .3> rgb <.1, .3, .7> } turbulence .1 } })
Ball(texture { pigment { object { union { cylinder { -z, z, .1 } torus { .3, .06 rotate 90*x } } } } })
Ball(texture { pigment { object { intersection { box { -1, 1 } sphere { <.2, 0, -.4>, .3 } } pigment { granite } pigment { checker scale .1 } } scale .8 } })
Ball(texture { pigment { density_file df3 "images/waves.df3" interpolate 0 color_map { [0 rgb x] [1 rgb <1, 1, .6>] } translate -.5 } })
Ball(texture { pigment { density_file df3 "images/waves.df3" interpolate 1 color_map { [0 rgb x] [1 rgb <1, 1, .6>] } translate -.5 } })
Ball(texture { pigment { density_file df3 "images/waves.df3" interpolate 2 frequency 2 translate -.5 } })
Ball(texture { density_file df3 "images/waves.df3" texture_map { [.4 A] [.6 B] } translate -.5 })
sphere {
  0, 0.48
  texture { pigment { image_map { png "images/alpha.png" } } }
  interior_texture { pigment { image_map { png "images/palette.png" } scale .3 } }
  translate <5.5, 2.5, 0>
}
