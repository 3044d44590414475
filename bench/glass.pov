// bench: +W640 +H480 -A; refraction: 80 glass balls and blocks on a checkered floor
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { location <0, 4.5, -9> look_at <0, 0.2, 0> angle 46 }
light_source { <-8, 12, -6> rgb 1 }
background { rgb <0.6, 0.7, 0.9> }
#declare Glass = texture {
  pigment { checker rgbf <0.95, 1, 0.97, 0.95> rgbf <0.9, 0.7, 0.4, 0.9> scale 0.3 }
  finish { ambient 0 diffuse 0.1 phong 0.8 reflection { 0.02, 1 fresnel } conserve_energy }
}
#for (I, -5, 4)
  #for (K, -4, 3)
    #if (mod(I + K + 20, 2)) sphere { <I + 0.5, 0.42, K + 0.5>, 0.42 texture { Glass } interior { ior 1.5 } }
    #else box { <-0.33, 0, -0.33>, <0.33, 0.8, 0.33> rotate 25*I*y translate <I + 0.5, 0.01, K + 0.5> texture { Glass } interior { ior 1.4 } }
    #end
  #end
#end
plane { y, 0 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.6> scale 0.5 } }
