// golden: +W120 +H90 -A; psnr >= 50; thousands of copies of a few things, kept once and placed often
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 6, -9> look_at <0, 0, 1> angle 55 }
light_source { <20, 30, -20> 1 }
plane { y, -.5 pigment { checker rgb .8 rgb .4 } }
#declare R = seed(3);
// Bumps and patterns move with what they are on; a solid, a lone bound and its own matter inside.
#declare Thing = union {
  #for (I, 1, 14)
    sphere { <rand(R), rand(R), rand(R)> - .5, .1
      #switch (mod(I, 4))
        #case (0) pigment { bozo color_map { [0 rgb x] [1 rgb y] } scale .1 } normal { bumps 1 scale .05 } #break
        #case (1) pigment { gradient y color_map { [0 rgb 1] [1 rgb z] } scale .3 } #break
        #case (2) pigment { rgbt <.8, .9, 1, .8> } finish { specular .5 } interior { ior 1.3 } #break
      #end
    }
  #end
  difference {
    box { -.2, .2 } cylinder { -y, y, .12 } sphere { .2, .15 pigment { rgb <1, .6, 0> } }
    pigment { checker rgb 1 rgb .2 scale .1 rotate 20 } normal { wrinkles .8 scale .1 }
  }
  torus { .45, .05 texture { pigment { slope { y } color_map { [0 rgb 0] [1 rgb <1, 1, .3>] } } } }
}
#declare Row = union {
  #for (I, -20, 20)
    object { Thing scale <.2, .2 + rand(R)*.1, .2> rotate rand(R)*90 translate <I*.3, rand(R)*.3, rand(R)*.2>
      #if (mod(I, 3) = 0) pigment { wood scale .2 turbulence .1 } #end
      #if (mod(I, 5) = 0) no_shadow #end
      #if (mod(I, 7) = 0) inverse inverse hollow #end
    }
  #end
}
#for (I, 0, 39)
  object { Row rotate y*(I*3 - 20) translate <rand(R), 0, I*.3 - 6>
    #if (mod(I, 4) = 0) texture { pigment { rgb <.3, .9, .4> } finish { reflection .3 } } #end
    #if (mod(I, 4) = 1) scale <-1, 1, 1> #end
    #if (mod(I, 4) = 2) bounded_by { sphere { <0, 0, I*.3 - 6>, 4 } } #end
    #if (I = 8) clipped_by { box { <-3, -1, -9>, <3, .2, 9> } } #end
    #if (I = 9) texture { pigment { agate } finish { phong 1 } scale .5 } #end
  }
#end
union {
  #for (I, 1, 600)
    object { Thing scale .15 translate <-8 + rand(R)*2, rand(R)*4 - .5, rand(R)*10 - 2> }
  #end
  pigment { leopard scale .2 color_map { [0 rgb x] [1 rgb 1] } }
}
// Many more where nobody looks: what is copied less often is not worth keeping once.
#for (I, 1, 320) object { Row translate <0, 0, -20 - I> } #end
#for (I, 1, 12500) object { Thing translate <mod(I, 100) - 50, 60, -div(I, 100) - 20> no_shadow } #end
