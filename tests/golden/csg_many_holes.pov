// golden: +W96 +H72 -A; psnr >= 48; rims of holes are pixel-sized edges
#version 3.7;
global_settings { assumed_gamma 1 }
// A plate with 120 holes: the search inside one big difference.
camera { location <0, 4, -4.5> look_at <0, 0, -0.1> angle 44 }
light_source { <-3, 6, -2> rgb 1 }
difference {
  box { <-2, -0.2, -1.6>, <2, 0.2, 1.6> }
  #for (I, 0, 11)
    #for (K, 0, 9)
      #local At = <(I - 5.5)*0.32, 0, (K - 4.5)*0.3>;
      #if (mod(I + K, 2)) cylinder { At - y, At + y, 0.1 }
      #else cone { At - 0.21*y, 0.05, At + 0.21*y, 0.13 }
      #end
    #end
  #end
  pigment { rgb <0.8, 0.75, 0.6> } finish { phong 0.5 phong_size 30 }
}
plane { y, -0.6 pigment { rgb <0.3, 0.4, 0.6> } }
