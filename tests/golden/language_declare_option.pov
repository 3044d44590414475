// golden: +W96 +H72 -A Declare=Count=5 declare=Width=1.5; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// Values from the command line.
#ifndef (Count) #declare Count = 9; #end
#for (I, 1, Count) sphere { <I - 3, 0.6, 0>, 0.45 pigment { rgb <I/5, 0.6, 0.3> } } #end
box { <-3, -1.5, 0>, <Width, -1, 1> pigment { rgb <0.4, 0.6, 0.9> } }
