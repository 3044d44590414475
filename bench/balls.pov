// bench: +W640 +H480 -A; 60,000 mirror balls in a random cloud, built by a loop
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
camera { location <0, 3, -26> look_at 0 angle 40 }
light_source { <-30, 40, -40> rgb 1 }
background { rgb <0.4, 0.5, 0.7> }
#declare Random = seed(1);
#for (I, 1, 60000)
  #local Way = vnormalize(<rand(Random), rand(Random), rand(Random)> - 0.5);
  sphere {
    Way*9*pow(rand(Random), 0.4), 0.05 + 0.06*rand(Random)
    pigment { rgb <0.4 + 0.5*rand(Random), 0.5, 0.4> }
    finish { reflection 0.35 phong 0.5 }
  }
#end
plane { y, -10 pigment { checker rgb 0.8, rgb 0.3 scale 3 } }
