// bench: +W8 +H6 -A; (b) a mesh2 of 500,000 triangles written by loops
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -4> look_at 0 angle 40 }
light_source { <-4, 6, -6> rgb 1 }
#declare N = 500;
#macro Height(X, Z) (0.2*sin(9*X)*cos(7*Z)) #end
#macro Corner(I, K) ((N + 1)*(I) + K) #end
mesh2 {
  vertex_vectors {
    (N + 1)*(N + 1),
    #for (I, 0, N)
      #local X = 2*I/N - 1;
      #for (K, 0, N)
        #local Z = 2*K/N - 1;
        <X, Height(X, Z), Z>,
      #end
    #end
  }
  face_indices {
    2*N*N,
    #for (I, 0, N - 1)
      #for (K, 0, N - 1)
        #local C = Corner(I, K);
        <C, C + 1, C + N + 1>, <C + 1, C + N + 1, C + N + 2>,
      #end
    #end
  }
  pigment { rgb <0.4, 0.7, 0.3> }
}
