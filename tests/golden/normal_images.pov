// golden: +W96 +H72 -A; psnr >= 50; bumps of pictures and of density files
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
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { bump_map { png "images/grey.png" bump_size 2 } } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { bump_map { png "images/grey.png" } bump_size 3 } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { bump_map { png "images/grey.png" interpolate 2 bump_size 4 } } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { bump_map { png "images/grey16.png" interpolate 3 bump_size -4 } } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { bump_map { png "images/palette.png" bump_size 1.5 } } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { bump_map { png "images/palette.png" use_index bump_size .2 } } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { bump_map { png "images/colour.png" once bump_size 3 } } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { bump_map { png "images/colour.png" map_type 1 interpolate 2 bump_size 5 } } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { bump_map { png "images/grey.png" map_type 2 interpolate 4 bump_size 5 } scale .5 } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { bump_map { png "images/grey.png" map_type 5 bump_size 3 } scale .3 rotate 30 } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { bump_map { png "images/grey.png" interpolate 2 bump_size 3 repeat <3, 3> } no_bump_scale } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { image_pattern { png "images/grey.png" interpolate 2 } 3 scale .6 } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { density_file df3 "images/waves.df3" interpolate 1 bump_size 2 translate -.5 } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { gradient x normal_map { [.3 bump_map { png "images/grey.png" bump_size 3 }] [.7 bumps scale .1] } scale .7 } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { average normal_map { [1 bump_map { png "images/grey.png" bump_size 3 }] [2 dents 1 scale .2] } } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { checker normal { bump_map { function 8, 8 { pattern { bozo scale .3 } } interpolate 2 bump_size 3 } } normal { quilted 1 scale .2 } scale .4 } })
Ball(texture { pigment { rgb <0.8, 0.7, 0.5> } normal { object { box { -.3, .3 rotate 45 } normal { waves 1 scale .1 } normal { bumps 1 scale .1 } } } })
