// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// Streams of random numbers: the same seed gives the same numbers, bit for bit.
#declare A = seed(7);
#declare B = seed(1234567);
#for (I, 1, 60)
  sphere { <rand(A)*7 - 3.5, rand(A)*2.4 + 0.2, rand(A)>, 0.1 + 0.15*rand(A) pigment { rgb <rand(A), rand(A), rand(A)> } }
  box { -0.12, 0.12 rotate 90*rand(B)*z translate <rand(B)*7 - 3.5, rand(B)*-2.4 - 0.2, rand(B)> pigment { rgb <rand(B), 0.5, rand(B)> } }
#end
