// Language §8.1: global_settings.
#version 3.7;
global_settings { assumed_gamma 1 }

//= every item
global_settings { adc_bailout 0.01 ambient_light rgb 0.5 irid_wavelength rgb <0.7,0.5,0.4> max_trace_level 10 noise_generator 3 number_of_waves 8 charset ascii }
#debug concat("fine", "\n")
// expect: fine

//= several times, in any order
global_settings { max_trace_level 3 } global_settings { max_trace_level 4 adc_bailout 0 }
#debug concat("fine", "\n")
// expect: fine

//= an unknown item
global_settings { sphere }
// error: D0214 at 1:19

//= a noise generator that is not there
global_settings { noise_generator 4 }
// error: D0302 at 1:19

//= inside of an object
sphere { 0, 1 global_settings { max_trace_level 3 } }
// error: D0214 at 1:15

//= the noise generator acts on functions
#declare F = function { internal(76) } global_settings { noise_generator 1 }
#debug concat(str(F(0.3,1.7,-2.2), 0, 6), "\n")
// expect: 0.527186
