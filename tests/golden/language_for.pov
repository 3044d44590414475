// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// Steps up and down, fractions, an empty range, and a changed step count by #break.
#for (I, 0, 7) box { <I - 3.9, 2, 0>, <I - 3.2, 2.2 + I/12, 1> pigment { rgb <1, I/7, 0> } } #end
#for (I, 3.5, -3.5, -1) sphere { <I, 1, 0>, 0.1 + abs(I)/12 pigment { rgb <0, 0.5 + I/8, 1> } } #end
#for (A, 0, 2*pi - 0.001, pi/9) cylinder { <0, -1.4, 0>, <1.3*cos(A), 1.3*sin(A) - 1.4, 0>, 0.05 pigment { rgb <0.5 + cos(A)/2, 0.5, 0.5 + sin(A)/2> } } #end
#for (I, 1, 0) sphere { 0, 3 } #end
#for (I, 0, 9) #if (I = 3) #break #end sphere { <2.2 + I/2, -2.4, 0>, 0.2 pigment { rgb 0.8 } } #end
