// Built-in functions §3 and §5: noise kernels and fractal sums.
#version 3.7;
global_settings { assumed_gamma 1 }

//= noise generators 1, 2 and 3
#declare N = function { internal(78) } #debug concat(str(N(0.3,1.7,-2.2,1), 0, 12), " ", str(N(0.3,1.7,-2.2,2), 0, 12), " ", str(N(0.3,1.7,-2.2,3), 0, 12), "\n")
// expect: 0.527186399413 0.528851478062 0.670296324321

//= generators are numbered modulo 4, and truncated
#declare N = function { internal(78) } #debug concat(str(N(0.3,1.7,-2.2,0), 0, 9), " ", str(N(0.3,1.7,-2.2,4), 0, 9), " ", str(N(0.3,1.7,-2.2,5), 0, 9), " ", str(N(0.3,1.7,-2.2,6.9), 0, 9), " ", str(N(0.3,1.7,-2.2,7), 0, 9), "\n")
// expect: 0.527186399 0.527186399 0.527186399 0.528851478 0.670296324

//= noise generator @ of the scene
global_settings { noise_generator @ } #declare F = function { internal(76) } #declare N = function { internal(78) } #debug concat(str((F(0.3,1.7,-2.2) = N(0.3,1.7,-2.2,@)), 0, 0), "\n")
// each: 1 2 3
// expect: 1

//= at lattice points, far away and below zero
#declare N = function { internal(78) }
#debug concat(str(N(0,0,0,1), 0, 9), " ", str(N(1,2,3,1), 0, 9), " ", str(N(-1,-2,-3,1), 0, 9), " ", str(N(12345.6,-9876.5,4321.1,1), 0, 9), "\n")
#debug concat(str(N(0,0,0,2), 0, 9), " ", str(N(1,2,3,2), 0, 9), " ", str(N(-1,-2,-3,2), 0, 9), " ", str(N(12345.6,-9876.5,4321.1,2), 0, 9), "\n")
#debug concat(str(N(0,0,0,3), 0, 9), " ", str(N(1,2,3,3), 0, 9), " ", str(N(-1,-2,-3,3), 0, 9), " ", str(N(12345.6,-9876.5,4321.1,3), 0, 9), "\n")
// expect: 0.056580500 0.306996500 0.773007000 0.000684709
// expect: 0.298322439 0.420990174 0.649268130 0.270941561
// expect: 0.511354305 0.471585305 0.503377531 0.601779090

//= ridged multifractal: octaves are whole
#declare F = function { internal(59) } #debug concat(str(F(0.3,-0.7,1.1, 1.1, 2.1, 4.5, 0.7, 0.8, 2), 0, 9), "\n")
// expect: 0.391744656

//= heterofractal: exponents below 1, fractional octaves
#declare F = function { internal(29) } #debug concat(str(F(0.3,-0.7,1.1, 0.5, 2, 4.5, 0.7, 0.5, 1), 0, 9), " ", str(F(0.3,-0.7,1.1, 0.5, 2, 3, 0.7, 2.5, 3), 0, 9), "\n")
// expect: 1.414241665 1.942858112

//= ridges: fractional octaves, generators
#declare F = function { internal(58) } #debug concat(str(F(0.3,-0.7,1.1, 2, 3.5, 0.5, 0.3, 0.6, 1), 0, 9), " ", str(F(0.3,-0.7,1.1, 2, 1, 0.5, 0.3, 0.6, 3), 0, 9), "\n")
// expect: 0.091992887 -0.368758570
