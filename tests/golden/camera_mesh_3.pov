// golden: +W48 +H36 -A; psnr >= 45; the uv plane of the mesh
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Dome = mesh {
  #for (J, 0, 7) #for (I, 0, 9)
    #macro P(A, B) vrotate(vrotate(-z, x * (B * 12 - 48)), y * (A * 14 - 70)) #end
    #macro T(A, B, C, D, E, F)
      smooth_triangle { P(A, B), P(A, B), P(C, D), P(C, D), P(E, F), P(E, F) uv_vectors <A / 10, B / 8>, <C / 10, D / 8>, <E / 10, F / 8> }
    #end
    T(I, J, I + 1, J, I + 1, J + 1)
    T(I, J, I + 1, J + 1, I, J + 1)
  #end #end
}
camera { mesh_camera { 1 3 mesh { Dome rotate y * 30 }  } location <0, 0, 0.2> }
sphere { <0.8, 0.3, -3>, 0.5 pigment { rgb <0.9, 0.3, 0.2> } finish { ambient 0.4 } }
sky_sphere { pigment { checker rgb <0.9, 0.8, 0.6>, rgb <0.2, 0.4, 0.7> scale 0.17 } }
sphere { <0.4, 0.3, 3>, 0.5 pigment { rgb <0.9, 0.3, 0.2> } finish { ambient 0.4 } }
sphere { <-0.7, -0.4, 4>, 0.6 pigment { rgbf <0.4, 0.9, 0.5, 0.6> } finish { ambient 0.4 } }
light_source { <1, 6, -3> rgb 1 }
