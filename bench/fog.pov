// bench: +W480 +H360 +A0.3; fog of both types, a sky of noise, a rainbow, mirrors and glass
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 1.6, -9> look_at <0, 1.2, 0> angle 55 }
light_source { <-30, 40, -20> rgb 1 media_attenuation on }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.8, 0.85, 0.9>] [0.6 rgb <0.2, 0.35, 0.7>] } }
  pigment { bozo turbulence 0.6 omega 0.6 color_map { [0.4 rgbt 1] [0.7 rgb 1] } scale <0.5, 0.1, 0.5> }
}
fog { distance 60 rgb <0.75, 0.8, 0.85> }
fog { fog_type 2 distance 5 rgb <0.9, 0.85, 0.8> fog_offset 0.1 fog_alt 0.5 turbulence 0.4 turb_depth 0.6 }
rainbow { angle 30 width 7 distance 40 direction <0.1, -0.1, 1>
  color_map { [0 rgbt <0.7, 0.1, 1, 0.9>] [0.4 rgbt <0.1, 0.9, 0.3, 0.7>] [0.8 rgbt <1, 0.5, 0.1, 0.7>] [1 rgbt <1, 0, 0, 1>] } }
plane { y, 0 hollow pigment { checker rgb 0.7, rgb <0.35, 0.45, 0.3> } }
#declare R = seed(5);
#for (I, 0, 149)
  #declare P = <30 * rand(R) - 15, 0.4 + rand(R), 40 * rand(R) - 5>;
  sphere { P, 0.4
    #switch (mod(I, 3))
      #case (0) pigment { rgb <0.9, 0.3, 0.2> } #break
      #case (1) pigment { rgb 0.1 } finish { reflection 0.7 } #break
      #else pigment { rgbf <0.9, 1, 0.95, 0.9> } interior { ior 1.4 } hollow
    #end
  }
#end
