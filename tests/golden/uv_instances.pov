// golden: +W120 +H90 -A; psnr >= 45; surface coordinates in contents that are kept once and placed often
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 angle 50 }
light_source { <-8, 10, -12> rgb 1 }
#declare R = seed(1);
#declare Map = pigment { image_map { png "images/colour.png" interpolate 2 } scale <.25, .5, 1> }
#declare Thing = union {
  #for (I, 1, 12)
    sphere { 0, .3 + .1*rand(R) #switch (mod(I,3)) #case (0) uv_mapping pigment { checker rgb 1 rgb x scale 1/8 } #break #case (1) pigment { uv_mapping Map } #break #end
      scale <1, .6 + .4*rand(R), 1> rotate 360*<rand(R), rand(R), rand(R)> translate 1.6*(<rand(R), rand(R), rand(R)> - .5) }
  #end
  #for (I, 1, 8)
    box { -.2, .2 #if (mod(I, 2)) uv_mapping pigment { Map } #end rotate 360*<rand(R), rand(R), rand(R)> translate 1.6*(<rand(R), rand(R), rand(R)> - .5) }
  #end
  difference { torus { .5, .2 } box { 0, 1 } }
}
#for (I, -1, 1)
  object { Thing rotate 70*I*y translate 2.2*I*x + y*1.1 uv_mapping pigment { checker rgb 1 rgb y scale 1/6 } }
  object { Thing rotate 70*I*z translate 2.2*I*x - y*1.1 #if (I) texture { pigment { uv_mapping Map } } rotate 20*I*x #end }
#end
#for (I, 1, 12000) object { Thing translate <mod(I, 100) - 50, 60, -div(I, 100) - 20> pigment { rgb 1 } } #end
