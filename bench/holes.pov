// bench: +W400 +H300 -A; one difference with 1,800 cutters, cylinders and cones
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <3.2, 7.5, -8> look_at <0.3, -0.2, -0.3> angle 52 }
light_source { <-8, 12, -6> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
#declare Columns = 50;
#declare Rows = 36;
difference {
  box { <-5, -0.3, -3.6>, <5, 0.3, 3.6> }
  #for (I, 0, Columns - 1)
    #for (K, 0, Rows - 1)
      #local At = <(I - Columns/2 + 0.5)*0.195, 0, (K - Rows/2 + 0.5)*0.195>;
      #if (mod(I + K, 3)) cylinder { At - 0.4*y, At + 0.4*y, 0.06 + 0.015*mod(I*K, 3) }
      #else cone { At - 0.31*y, 0.03, At + 0.31*y, 0.09 }
      #end
    #end
  #end
  pigment { rgb <0.8, 0.7, 0.5> }
  finish { phong 0.6 phong_size 40 }
}
plane { y, -1.5 pigment { rgb <0.4, 0.5, 0.6> } }
