// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// Conditions of every kind; branches that hold parts of blocks; an else chain.
#declare Many = 3;
#declare Lit = yes;
#for (I, -3, 3)
  sphere { <I, 1.5, 0>,
    #if (I < 0) 0.2 #elseif (I = 0) 0.5 #else 0.35 #end
    pigment { rgb #if (Lit & (I != 1)) <0.9, 0.6, 0.2> #else <0.2, 0.6, 0.9> #end }
    #ifdef (Many) scale <1, Many/2, 1> translate -0.7*y #end
    #ifndef (Few) finish { phong 0.8 } #end
  }
#end
#if (Many >= 3 | no) box { #else sphere { #end
  <-3, -2, 0>, <3, -1.6, 1> pigment { rgb <0.5, 0.8, 0.4> }
}
#if (!Lit) sphere { 0, 3 } #end
