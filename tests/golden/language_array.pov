// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// Filled, grown, two-dimensional, of objects; sizes asked for; passed to a macro.
#declare Heights = array[6] { 0.5, 1.5, 1, 2.2, 0.8, 1.7 }
#declare Grid = array[3][4] { { 1, 2, 3, 4 }, { 4, 3, 2, 1 }, { 2, 4, 1, 3 } }
#declare Shapes = array[2]
#declare Shapes[0] = sphere { 0, 0.3 }
#declare Shapes[1] = box { -0.25, 0.25 rotate 45*z }
#macro Bars(List) #for (I, 0, dimension_size(List, 1) - 1) box { <I*0.6, 0, 0>, <I*0.6 + 0.5, List[I], 1> } #end #end
union { Bars(Heights) pigment { rgb <0.9, 0.6, 0.2> } translate <-3.7, 0.3, 0> }
#for (I, 0, dimension_size(Grid, 1) - 1)
  #for (K, 0, dimension_size(Grid, 2) - 1)
    object { Shapes[mod(I + K, dimensions(Grid))] scale Grid[I][K]/3 translate <K*0.9 + 0.7, 2.2 - I*0.9, 0> pigment { rgb <I/2, K/3, 0.6> } }
  #end
#end
#declare Heights[2] = Heights[0] + Heights[3];
union { Bars(Heights) pigment { rgb <0.3, 0.7, 0.8> } scale <1, 0.7, 1> translate <-3.7, -2.8, 0> }
