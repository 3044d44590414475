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

//= item @
global_settings { @ } #debug "fine\n"
// each: 'adc_bailout 0' 'adc_bailout 0.01' 'ambient_light 0.5' 'ambient_light rgb <0.5,1,1>' 'assumed_gamma 2.2' 'assumed_gamma srgb' 'charset ascii' 'charset utf8' 'hf_gray_16' 'hf_gray_16 on' 'hf_gray_16 off' 'irid_wavelength rgb <0.25,0.18,0.14>'
// each: 'max_intersections 64' 'max_trace_level 256' 'max_trace_level 0' 'max_trace_level 1000' 'max_trace_level -1' 'mm_per_unit 10' 'noise_generator 1' 'noise_generator 2' 'noise_generator 3' 'number_of_waves 1' 'number_of_waves 0' 'number_of_waves -3'
// expect: fine

//= item radiosity
global_settings { radiosity { count 10 } } #debug "fine\n"
// expect: fine

//= radiosity takes @
global_settings { radiosity { @ } } #debug "fine\n"
// each: 'count 100' 'count 100, 200' 'recursion_limit 20' 'error_bound 0.5' 'low_error_factor 1' 'nearest_count 10' 'nearest_count 10, 5' 'minimum_reuse 0.01' 'maximum_reuse 0.1' 'gray_threshold 0.5' 'brightness 2'
// each: 'max_sample 1' 'adc_bailout 0.1' 'pretrace_start 0.1' 'pretrace_end 0.01' 'always_sample on' 'normal on' 'media off' 'subsurface on' 'minimum_reuse 0.15' 'maximum_reuse 0.02' 'minimum_reuse 0.1 maximum_reuse 0.15' 'load_file "a"' 'save_file "a"'
// expect: fine

//= radiosity does not take @
global_settings { radiosity { @ } }
// each: 'count 0' 'recursion_limit 0' 'recursion_limit 21' 'error_bound 0' 'nearest_count 0' 'nearest_count 21' 'nearest_count 5, 5' 'gray_threshold 2' 'brightness 0' 'adc_bailout 0' 'pretrace_start 0' 'pretrace_end 2'
// error: D0302 at 1:31

//= pretrace_end beyond pretrace_start
global_settings { radiosity { pretrace_start 0.01 pretrace_end 0.02 } }
// error: D0302 at 1:19

//= minimum_reuse beyond maximum_reuse
global_settings { radiosity { minimum_reuse 0.2 maximum_reuse 0.1 } }
// error: D0302 at 1:19

//= settings of old radiosity
global_settings { radiosity { distance_maximum 1 } }
// error: D0214 at 1:31

//= item photons
global_settings { photons { count 1000 } } sphere { 0, 1 photons { target reflection on } } #debug "fine\n"
// expect: fine

//= item subsurface
global_settings { subsurface { samples 20, 10 radiosity off } } #debug "fine\n"
// expect: fine

//= @ has no value
global_settings { @
}
// each: adc_bailout assumed_gamma charset max_trace_level mm_per_unit noise_generator number_of_waves max_intersections
// error: D0201 at 2:1

//= unknown item @
global_settings { @ 1 }
// each: angle sphere Nothing phong count
// error: D0214 at 1:19

//= only the first assumed_gamma counts
global_settings { assumed_gamma 2.2 } #declare C = srgb 0.5; #debug concat(str(C.red, 0, 5), "\n")
// expect: 0.21404

//= noise generator @ does not exist
global_settings { noise_generator @ }
// each: 0 4 -1 1000
// error: D0302 at 1:19

//= assumed_gamma must be positive: @
global_settings { assumed_gamma @ }
// each: 0 -1
// error: D0302 at 1:19

//= items in any order, with directives between
global_settings { max_trace_level 3 #if (1) adc_bailout 0.1 #end #declare Q = 1; ambient_light 1 }
#debug concat(str(Q, 0, 0), "\n")
// expect: 1

//= a name may not stand there
#declare G = 1; global_settings { G }
// error: D0201 at 1:35
