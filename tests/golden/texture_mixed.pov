// golden: +W128 +H96 -A; psnr >= 45; single pixels at the rim of shadows may differ
#version 3.7; global_settings{assumed_gamma 1 max_trace_level 6}
camera{location <0,3,-8> look_at 0 angle 45}
light_source{<-20,30,-30> rgb 1}
plane{y,-1 pigment{checker rgb .9 rgb .6} }
#declare A=texture{pigment{rgbf<.9,.3,.2,.8>} normal{bumps .6 scale .1} finish{phong .8}}
#declare B=texture{pigment{slope{y} color_map{[0 rgb x][.5 rgbt<0,1,0,.6>][1 rgb z]}} normal{wrinkles 1 scale .5} finish{reflection .2}}
sphere{<-2,0,0>,.9 texture{gradient y texture_map{[.3 A][.7 B]} scale <.5,2,1> rotate 40*z} interior{ior 1.3}}
difference{ sphere{<0,0,0>,.9 texture{checker texture{A} texture{B} scale .3}} box{0,2 texture{bozo scale .2 texture_map{[.4 pigment{rgb 1}][.6 A]}}} rotate 30*y}
sphere{<2,0,0>,.9 texture{pigment{rgb <.7,.7,.3>} normal{crackle .5 scale .3}} texture{pigment{aoi color_map{[.5 rgbt 1][.8 rgbf<1,0,0,.3>]}} } texture{pigment{slope x color_map{[.6 rgbt 1][.8 rgb y]}} normal{ripples .4 scale .2} finish{specular .5}} }
sphere{<0,1.7,0>,.6 texture{average texture_map{[1 A][2 B][.5 pigment{agate turbulence .3}]} no_bump_scale scale .5} no_shadow}
