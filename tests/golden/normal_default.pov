// golden: +W96 +H72 -A; psnr >= 50; bumps that begin with the default normal, and default colours
#version 3.7; global_settings{assumed_gamma 1}
camera{orthographic location <0,0,-10> right 4*x up 3*y direction z}
light_source{<-20,30,-100> rgb 1}
#default{ normal{bump_size 2} }
sphere{<1,0,0>,.9 pigment{rgb 1} normal{bumps scale .2}}
sphere{<-1,0,0>,.9 pigment{mandel 30 exponent 3} normal{dents} finish{ambient 1 diffuse 0}}
