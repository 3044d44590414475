// bench: +W1024 +H768 -A; a smooth mesh of 500,000 triangles, written by loops
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <-8, 12, -10> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
camera { location <0, 2.2, -3.2> look_at <0, -.1, 0> }
#declare N = 1000;
#declare M = 250;
#macro Around(I, J, R)
  <(1 + R*cos(2*pi*J/M))*cos(2*pi*I/N), R*sin(2*pi*J/M), (1 + R*cos(2*pi*J/M))*sin(2*pi*I/N)>
#end
mesh2 {
  vertex_vectors {
    N*M, #for (I, 0, N - 1) #for (J, 0, M - 1) Around(I, J, .45 + .05*sin(18*pi*I/N)*sin(14*pi*J/M)), #end #end
  }
  normal_vectors {
    N*M, #for (I, 0, N - 1) #for (J, 0, M - 1) Around(I, J, 1) - Around(I, J, 0), #end #end
  }
  face_indices {
    2*N*M,
    #for (I, 0, N - 1)
      #local A = I*M;
      #local B = mod(I + 1, N)*M;
      #for (J, 0, M - 1)
        #local K = mod(J + 1, M);
        <A + J, B + J, B + K>, <A + J, B + K, A + K>,
      #end
    #end
  }
  pigment { rgb <.9, .6, .3> } finish { phong .6 } rotate 20*y
}
plane { y, -.6 pigment { rgb .7 } }
