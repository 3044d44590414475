// golden: +W128 +H96 -A; psnr >= 45; noise and filtering layers of old versions; single pixels may differ
#version 3.1; 
camera{location <0,3,-8> look_at 0 angle 45}
light_source{<-20,30,-30> color red 1 green 1 blue 1}
plane{y,-1 pigment{hexagon scale .4 turbulence .1}}
sphere{<-2,0,0>,.9 pigment{bozo turbulence .6 octaves 4 lambda 2.7 omega .6 scale .4}}
sphere{<0,0,0>,.9 pigment{agate scale .6} normal{bumps scale .1}}
sphere{<2,0,0>,.9 texture{pigment{wood turbulence .05 scale .2}} texture{pigment{crackle scale .3 color_map{[0 rgb 0][.1 rgbf 1]}}} }
