// golden: +W96 +H72 -A; psnr >= 50; many objects of one mesh, each with settings of its own
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 angle 50 }
light_source { <5, 8, -9> 1 }
plane { y, -1 pigment { checker rgb 1 rgb .3 } }
#declare Red = texture { pigment { rgb <1, .2, .1> } finish { phong .6 } }
#declare Leaf = mesh {
  smooth_triangle { <-1, -1, 0>, <-1, 0, -1>, <1, -1, 0>, <1, 0, -1>, <0, 1, 0>, <0, 1, -1> }
  triangle { <-1, -1, 0>, <1, -1, 0>, <0, -1, 1> }
  triangle { <-1, -1, 0>, <1, -1, 0>, <0, -1, 0> }  // no area: dropped
  texture { Red }
}
#declare I = 0;
#while (I < 300)
  object {
    Leaf scale <.1, .15, .1> rotate I*37*y
    translate <mod(I, 20)/5 - 2, div(I, 100)*.3 - .8, div(I, 20)/6 - 1>
    #if (mod(I, 3) = 0) no_shadow #end
    #if (mod(I, 5) = 0) double_illuminate #end
    #if (mod(I, 7) = 0) texture { pigment { rgb <.2, 1, .3> } } #end
  }
  #declare I = I + 1;
#end
object { Leaf no_image scale .5 translate <0, 1, 0> }
object { Leaf no_reflection scale .2 translate <-1, 1, 0> }
object { Leaf scale .5 bounded_by { sphere { 0, .3 } } translate <1, 1, 0> }
sphere { <0, .5, 1>, .5 pigment { rgb 0 } finish { reflection 1 } }
