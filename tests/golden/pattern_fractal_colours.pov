// golden: +W160 +H120 -A; psnr >= 50; inside and outside of fractals: every kind, powers up to 33
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4, 3, -10> direction z right 8*x up 6*y }
#default { finish { ambient 1 diffuse 0 } }
#declare N = 0;
#declare C = color_map { [0 rgb <.1, 0, .3>] [.25 rgb x] [.5 rgb <1, .6, .2>] [.75 rgb <0, .7, .4>] [1 rgb 1] }
#macro Next()
  translate <mod(N, 8) + .5, div(N, 8) + .5, 0>
  #declare N = N + 1;
#end
#macro Frame() box { -<.48, .48, 0>, <.48, .48, 1> #end
#for (T, 0, 8)
  Frame() pigment { mandel 25 exterior T, (T < 7 ? .6 : 3.5) color_map { C } scale .3 translate .2*x } Next() }
#end
#for (T, 0, 6)
  Frame() pigment { julia <-.4, .3>, 12 interior T, .8 exterior 0, 1 color_map { C } scale .35 } Next() }
#end
#for (T, 0, 6)
  Frame() pigment { mandel 15 exponent 3 interior T, 1.5 exterior 1, 2 color_map { C } scale .35 } Next() }
#end
#for (E, 4, 7)
  Frame() pigment { mandel 20 exponent E exterior 1, 3 color_map { C } scale .35 } Next() }
#end
Frame() pigment { mandel 8 exponent 33 exterior 1, 3 color_map { C } scale .4 } Next() }
Frame() pigment { julia <.5, .5>, 15 exponent 3 exterior 1, 2 interior 1, 1 color_map { C } scale .35 } Next() }
Frame() pigment { julia <.6, .3>, 15 exponent 5 exterior 8, 2.5 interior 6, 1 color_map { C } scale .35 } Next() }
Frame() pigment { julia <.4, .5>, 15 exponent 9 exterior 2, .3 interior 4, 2 color_map { C } scale .4 } Next() }
#for (K, 1, 2)
  Frame() pigment { magnet K mandel 20 exterior 1, 2 interior 6, .1 color_map { C } scale .15 translate -.2*x } Next() }
  Frame() pigment { magnet K mandel 20 exterior 8, 4 interior 2, .3 color_map { C } scale .15 translate -.2*x } Next() }
  Frame() pigment { magnet K julia <.5, .8>, 20 exterior 6, .01 interior 1, .5 color_map { C } scale .15 } Next() }
  Frame() pigment { magnet K julia <1.2, -.4>, 20 exterior 1, 1 interior 5, .2 color_map { C } scale .2 } Next() }
#end
Frame() pigment { mandel 30 frequency 3 sine_wave color_map { C } turbulence .1 scale .35 } Next() }
Frame() pigment { julia <-.7, .3>, 25 rotate 30 pigment_map { [.3 checker rgb 0 rgb 1 scale .1] [.8 rgb x] } scale .4 } Next() }
