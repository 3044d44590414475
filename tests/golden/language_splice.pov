// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// Half blocks: a macro opens what its caller closes, and a branch opens what stands after #end.
#macro Open(Kind) #if (Kind = 1) sphere { 0, 0.7 #else box { -0.6, 0.6 #end #end
#macro Close(At, C) translate At pigment { rgb C } } #end
Open(1) scale <1, 0.6, 1> Close(<-2.4, 1.2, 0>, <0.9, 0.4, 0.2>)
Open(2) rotate 25*z Close(<0, 1.2, 0>, <0.3, 0.7, 0.4>)
#declare Joined = yes;
#if (Joined) merge { #end
  sphere { <2, 1.2, 0>, 0.5 }
  sphere { <2.6, 1.2, 0>, 0.5 }
#if (Joined) pigment { rgb <0.4, 0.5, 0.9> } } #end
#macro Pair() <-1.5, -1.4, 0>, <1.5, -1, 1> #end
box { Pair() pigment { rgb <#if (Joined) 0.8, #else 0.1, #end 0.7, 0.3> } }
cylinder { -2.5*y - 3*x, #if (Joined) -2.5*y #else 5 #end + 3*x, 0.2 pigment { rgb <0.8, 0.4, 0.8> } }
