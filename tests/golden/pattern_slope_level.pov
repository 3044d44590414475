// golden: +W64 +H48 -A; psnr >= 60; level ground is 1 or 0, depending on how long the direction is
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4, 3, -10> direction z right 8*x up 6*y }
#default { finish { ambient 1 diffuse 0 } }
#declare C = color_map { [0 rgb <.1, 0, .3>] [.5 rgb <1, .6, .2>] [1 rgb 1] }
#declare Lengths = array[8] { 1, 1.3, 1.7, .7, .9, 1.1, 3, .123 };
#for (I, 0, 7)
  #local L = Lengths[I];
  #local Frame = box { <.05, .05, 0>, <.95, .95, 1> translate I*x }
  object { Frame pigment { slope -L*z color_map { C } } }
  object { Frame pigment { slope L*z color_map { C } } translate y }
  object { Frame pigment { slope { -L*z, .2, .8 } color_map { C } } translate 2*y }
  object { Frame pigment { slope { -L*z altitude .4*y, -1, 5 } color_map { C } } translate 3*y }
  object { Frame pigment { slope <0, .3, -L> color_map { C } frequency 3 } normal { gradient z, 3 no_bump_scale } translate 4*y }
  object { Frame pigment { slope { point_at <I + .5, 5.5, -L> } color_map { C } } translate 5*y }
#end
