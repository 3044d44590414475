// golden: +W128 +H96 -A; psnr >= 45; single pixels at the rim of shadows may differ
#version 3.5; global_settings{assumed_gamma 2.2 noise_generator 3 number_of_waves 3}
camera{location <0,3,-8> look_at 0 angle 45}
light_source{<-20,30,-30> rgb 1}
plane{y,-1 pigment{brick turbulence .2 scale .1} normal{brick .3 scale .1}}
#default{pigment{bozo scale .5} normal{dents 1}}
sphere{<-2,0,0>,.9 pigment{granite}}
sphere{<0,0,0>,.9 pigment{gradient x} normal{waves .5 scale .2}}
sphere{<2,0,0>,.9 texture{pigment{marble turbulence .5 frequency 3} normal{bozo normal_map{[.3 ripples scale .2][.6 quilted scale .2 turbulence .2]} scale <.5,1,2> rotate 30 no_bump_scale} finish{phong .5 metallic}}}
sphere{<0,1.7,0>,.6 pigment{pigment_pattern{marble turbulence .4 color_map{[0 rgb 0][1 rgb 1]}} color_map{[0 rgb x][1 rgbt<0,0,1,.5>]} scale .4} normal{function{x*y*5} .4 slope_map{[0 <0,1>][1 <1,1>]}}}
sky_sphere{pigment{wrinkles turbulence .4 scale <1,.2,1> color_map{[.3 rgb<.3,.4,.9>][.7 rgb 1]}}}
