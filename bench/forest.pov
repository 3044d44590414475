// bench: +W640 +H480 -A; 200 copies of a tree of 5,000 parts (the oracle has no room for 10,000)
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 9, -14> look_at <0, 1, 6> angle 60 }
light_source { <60, 90, -50> 1 }
plane { y, 0 pigment { rgb <.5, .45, .3> } }
#declare R = seed(7);
#declare Twig = union {
  cylinder { 0, .5*y, .012 }
  #for (I, 1, 49)
    sphere {
      0, .06 scale <1, .3, .6> rotate <rand(R)*90, rand(R)*360, rand(R)*90>
      translate <rand(R)*.2 - .1, .1 + I*.009, rand(R)*.2 - .1>
      pigment { rgb <.1 + rand(R)*.3, .45 + rand(R)*.2, .1> }
    }
  #end
  pigment { rgb <.3, .2, .1> }
}
#declare Tree = union {
  cone { 0, .12, 3*y, .02 pigment { rgb <.3, .2, .1> } }
  #for (I, 0, 98)
    object { Twig rotate <40 + rand(R)*70, 0, 0> rotate y*I*137.5 translate y*(.8 + I*.022) }
  #end
}
#ifndef (Trees) #declare Trees = 200; #end
#for (I, 0, Trees - 1)
  object {
    Tree scale .7 + rand(R)*.6 rotate y*rand(R)*360
    translate <mod(I, 14)*1.6 - 10 + rand(R), 0, div(I, 14)*1.6 - 4 + rand(R)>
  }
#end
