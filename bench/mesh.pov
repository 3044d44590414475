// bench: +W640 +H480 -A; a reflecting mesh of 200,000 triangles, written by loops
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 2.2, -3.2> look_at <0, -.1, 0> }
light_source { <5, 8, -9> 1 }
light_source { <-5, 6, -3> rgb .4 }
plane { y, -.6 pigment { checker rgb 1 rgb .3 } }
sky_sphere { pigment { gradient y color_map { [0 rgb 1] [1 rgb <.2, .4, .9>] } } }
#declare N = 400;
#declare M = 250;
// A ring with bumps; J runs around its tube.
#macro Point(I, J)
  #local U = 2*pi*I/N;
  #local V = 2*pi*J/M;
  #local R = .45 + .05*sin(9*U)*sin(7*V);
  <(1 + R*cos(V))*cos(U), R*sin(V), (1 + R*cos(V))*sin(U)>
#end
mesh2 {
  vertex_vectors {
    N*M,
    #local I = 0;
    #while (I < N)
      #local J = 0;
      #while (J < M) Point(I, J), #local J = J + 1; #end
      #local I = I + 1;
    #end
  }
  face_indices {
    2*N*M,
    #local I = 0;
    #while (I < N)
      #local A = I*M;
      #local B = mod(I + 1, N)*M;
      #local J = 0;
      #while (J < M)
        #local K = mod(J + 1, M);
        <A + J, B + J, B + K>, <A + J, B + K, A + K>,
        #local J = J + 1;
      #end
      #local I = I + 1;
    #end
  }
  inside_vector <.1, 1, .2>
  pigment { rgb <.9, .6, .3> } finish { reflection .5 phong .6 } rotate 20*y
}
