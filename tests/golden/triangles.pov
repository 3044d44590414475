// golden: +W96 +H72 -A; psnr >= 50; flat and smooth ones from all sides, and some that are not seen
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 angle 50 }
light_source { <5, 8, -9> 1 }
plane { y, -1 pigment { checker rgb 1 rgb .3 } }
#declare Red = texture { pigment { rgb <1, .2, .1> } finish { phong .6 } }
#declare Green = texture { pigment { rgb <.2, 1, .1> } finish { reflection .3 } }
#declare I = 0;
#while (I < 24)
  triangle { <-1, -1, 0>, <-.2, -1, .3>, <-.6, .2, 0> texture { Red } interior_texture { Green } rotate I*15*y }
  smooth_triangle {
    <-1, .3, 0>, <-.5, 0, -1>, <-.2, .3, .3>, <.4, 0, -1>, <-.6, 1.2, 0>, <0, .3, -1>
    texture { Green } interior_texture { Red } scale <1, .8, 1> rotate (I*15 + 7)*y
  }
  #declare I = I + 1;
#end
triangle { <1, -1, -1>, <2, -1, -1>, <1.5, 0, -1> texture { Red } interior_texture { Green } translate .1*x }
triangle { <2, -1, -1>, <1, -1, -1>, <1.5, -2, -1> texture { Red } interior_texture { Green } translate y }
triangle { <0, 0, 0>, <1, 1, 1>, <2, 2, 2> }
smooth_triangle { <-1, .3, 0>, <-.5, 0, -1>, <-.2, .3, .3>, <.4, 0, 1>, <-.6, 1.2, 0>, <0, .3, -1> }
