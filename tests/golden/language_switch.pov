// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// #case falls through without #break; #range; #else; fractional values.
#for (I, 0, 9)
  #local At = <mod(I, 5)*1.5 - 3, 1 - 2*div(I, 5), 0>;
  union {
    #switch (I/2)
      #case (0) sphere { 0, 0.5 } #break
      #case (0.5) box { -0.4, 0.4 }
      #case (1) torus { 0.5, 0.1 rotate 90*x } #break
      #range (1.5, 2.5) cone { -0.5*y, 0.5, 0.5*y, 0.1 * I } #break
      #range (3, 4) cylinder { -0.5*x, 0.5*x, 0.1*(I - 5) }
      #else sphere { 0.3*y, 0.25 }
    #end
    pigment { rgb <0.9 - I/12, 0.5, 0.2 + I/12> } translate At
  }
#end
