// golden: +W160 +H120 -A; psnr >= 45; flags of unions and solids, of their parts, seen directly, mirrored and through glass
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.6, 0> angle 60 }
light_source { <-4, 8, -5> rgb 1 }
plane { y, -1 pigment { rgb .7 } }
box { <-6, -1, 4>, <6, 4, 4.1> pigment { rgb 0.05 } finish { reflection 0.7 } }
box { <0, -1, -4>, <6, 4, -3.9> pigment { rgbt <.9, 1, .9, .9> } interior { ior 1.3 } no_shadow }
#macro Flag(K) #switch (K) #case (0) no_image #break #case (1) no_reflection #break #case (2) no_shadow #break #end #end
// `part`: the flag on one part of it, else on all of it.
#macro Thing(I, K, Part)
  #switch (I)
    #case (0) union { sphere { <-.2, 0, 0>, .3 #if (Part) Flag(K) #end } box { 0, .4 } pigment { rgb <1, .4, .2> } #break
    #case (1) union { sphere { <-.2, 0, 0>, .3 #if (Part) Flag(K) #end } box { 0, .4 } pigment { rgb <.4, 1, .2> } split_union 0 #break
    #case (2) difference { sphere { 0, .4 } box { 0, 1 #if (Part) Flag(K) #end pigment { rgb <1, .4, 1> } } pigment { rgb <.2, .4, 1> } #break
    #case (3) merge { sphere { <-.2, 0, 0>, .3 #if (Part) Flag(K) #end pigment { rgb 1 } } box { -.2, .4 } pigment { rgb <1, 1, .2> } #break
  #end
  #if (!Part) Flag(K) #end
  }
#end
#for (K, 0, 2) #for (Side, 0, 1) #for (I, 0, 3)
  object { Thing(I, K, 1) translate <I*.95 - 3.5 + Side*3.9, -.2, K*2 - 2> }
  object { Thing(I, K, 0) scale .7 translate <I*.95 - 3.5 + Side*3.9, .9, K*2 - 2> }
#end #end #end
