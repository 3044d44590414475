// bench: +W640 +H480 -A; six lamps behind 400 panes that colour the shadows
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 9, -10> look_at <0, 0, 0> angle 44 }
background { rgb 0.2 }
#for (L, 0, 5) light_source { <12*cos(L*pi/3), 10, 12*sin(L*pi/3)> rgb 0.25 } #end
#declare Random = seed(3);
#for (I, 1, 400)
  box {
    <-0.3, 0, -0.3>, <0.3, 0.02, 0.3>
    rotate <20, 90, 20>*rand(Random)
    translate <rand(Random)*9 - 4.5, 0.3 + 2*rand(Random), rand(Random)*7 - 3.5>
    pigment { rgbf <rand(Random), rand(Random), rand(Random), 0.8> }
  }
#end
plane { y, 0 pigment { rgb 0.95 } }
