// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// Nested loops, a loop that never runs, and #break.
#declare I = 0;
#while (I < 8)
  #declare K = 0;
  #while (true)
    #if (K > I) #break #end
    sphere { <I - 3.5, K*0.7 - 2.5, 0>, 0.3 pigment { rgb <I/8, 0.4, K/8> } }
    #declare K = K + 1;
  #end
  #declare I = I + 1;
#end
#while (I < 8) sphere { 0, 3 } #end
