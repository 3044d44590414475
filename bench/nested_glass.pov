// bench: +W320 +H240 +A0.3; nested glass: balls and blocks with bubbles and other glass within
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 15 }
camera { location <0, 4.5, -9> look_at <0, 0.4, 0> angle 42 }
light_source { <-8, 12, -6> rgb 1 }
background { rgb <0.6, 0.7, 0.9> }
#declare Clear = finish { ambient 0 diffuse 0 specular 0.6 roughness 0.005 reflection { 0.02, 1 fresnel } conserve_energy }
#declare Glass = material {
  texture { pigment { rgbf <0.97, 1, 0.98, 0.95> } finish { Clear } }
  interior { ior 1.5 fade_distance 3 fade_power 1001 fade_color <0.6, 0.9, 0.7> }
}
#declare Amber = material { texture { pigment { rgbf <1, 0.8, 0.45, 0.9> } finish { Clear } } interior { ior 1.7 } }
#declare Air = material { texture { pigment { rgbf 1 } finish { Clear } } interior { ior 1 } }
#declare R = seed(23);
#for (I, -3, 3)
  #for (K, -2, 2)
    union {
      #if (mod(I + K + 10, 2))
        sphere { 0, 0.42 material { Glass } }
      #else
        box { -0.34, 0.34 material { Glass } rotate 90*rand(R)*y }
      #end
      #for (B, 0, 3)
        sphere { vrotate(<0.17, 0, 0>, <0, 90*B + 40*rand(R), 60*rand(R) - 30>), 0.05 + 0.03*rand(R) material { Air } }
      #end
      sphere { 0, 0.1 material { Amber } }
      translate <1.1*I, 0.43, 1.1*K>
    }
  #end
#end
plane { y, 0 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.6> scale 0.5 } }
