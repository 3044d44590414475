// Language §1.6: reserved words.
#version 3.7;
global_settings { assumed_gamma 1 }

//= no reserved word is a defined name
#if(defined(aa_level))#debug"aa_level\n"#end #if(defined(aa_threshold))#debug"aa_threshold\n"#end
#if(defined(abs))#debug"abs\n"#end #if(defined(absorption))#debug"absorption\n"#end
#if(defined(accuracy))#debug"accuracy\n"#end #if(defined(acos))#debug"acos\n"#end #if(defined(acosh))#debug"acosh\n"#end
#if(defined(adaptive))#debug"adaptive\n"#end #if(defined(adc_bailout))#debug"adc_bailout\n"#end
#if(defined(agate))#debug"agate\n"#end #if(defined(agate_turb))#debug"agate_turb\n"#end
#if(defined(albedo))#debug"albedo\n"#end #if(defined(all))#debug"all\n"#end
#if(defined(all_intersections))#debug"all_intersections\n"#end #if(defined(alpha))#debug"alpha\n"#end
#if(defined(altitude))#debug"altitude\n"#end #if(defined(always_sample))#debug"always_sample\n"#end
#if(defined(ambient))#debug"ambient\n"#end #if(defined(ambient_light))#debug"ambient_light\n"#end
#if(defined(angle))#debug"angle\n"#end #if(defined(anisotropy))#debug"anisotropy\n"#end
#if(defined(aoi))#debug"aoi\n"#end #if(defined(aperture))#debug"aperture\n"#end #if(defined(append))#debug"append\n"#end
#if(defined(arc_angle))#debug"arc_angle\n"#end #if(defined(area_illumination))#debug"area_illumination\n"#end
#if(defined(area_light))#debug"area_light\n"#end #if(defined(array))#debug"array\n"#end
#if(defined(asc))#debug"asc\n"#end #if(defined(ascii))#debug"ascii\n"#end #if(defined(asin))#debug"asin\n"#end
#if(defined(asinh))#debug"asinh\n"#end #if(defined(assumed_gamma))#debug"assumed_gamma\n"#end
#if(defined(atan))#debug"atan\n"#end #if(defined(atan2))#debug"atan2\n"#end #if(defined(atanh))#debug"atanh\n"#end
#if(defined(autostop))#debug"autostop\n"#end #if(defined(average))#debug"average\n"#end
#if(defined(b_spline))#debug"b_spline\n"#end #if(defined(background))#debug"background\n"#end
#if(defined(bezier_spline))#debug"bezier_spline\n"#end #if(defined(bicubic_patch))#debug"bicubic_patch\n"#end
#if(defined(bitwise_and))#debug"bitwise_and\n"#end #if(defined(bitwise_or))#debug"bitwise_or\n"#end
#if(defined(bitwise_xor))#debug"bitwise_xor\n"#end #if(defined(black_hole))#debug"black_hole\n"#end
#if(defined(blob))#debug"blob\n"#end #if(defined(blue))#debug"blue\n"#end
#if(defined(blur_samples))#debug"blur_samples\n"#end #if(defined(bmp))#debug"bmp\n"#end
#if(defined(bokeh))#debug"bokeh\n"#end #if(defined(bounded_by))#debug"bounded_by\n"#end
#if(defined(box))#debug"box\n"#end #if(defined(boxed))#debug"boxed\n"#end #if(defined(bozo))#debug"bozo\n"#end
#if(defined(break))#debug"break\n"#end #if(defined(brick))#debug"brick\n"#end
#if(defined(brick_size))#debug"brick_size\n"#end #if(defined(brightness))#debug"brightness\n"#end
#if(defined(brilliance))#debug"brilliance\n"#end #if(defined(bump_map))#debug"bump_map\n"#end
#if(defined(bump_size))#debug"bump_size\n"#end #if(defined(bumps))#debug"bumps\n"#end
#if(defined(camera))#debug"camera\n"#end #if(defined(case))#debug"case\n"#end
#if(defined(caustics))#debug"caustics\n"#end #if(defined(ceil))#debug"ceil\n"#end #if(defined(cells))#debug"cells\n"#end
#if(defined(charset))#debug"charset\n"#end #if(defined(checker))#debug"checker\n"#end #if(defined(chr))#debug"chr\n"#end
#if(defined(circular))#debug"circular\n"#end #if(defined(clipped_by))#debug"clipped_by\n"#end
#if(defined(clock))#debug"clock\n"#end #if(defined(clock_on))#debug"clock_on\n"#end
#if(defined(collect))#debug"collect\n"#end #if(defined(color))#debug"color\n"#end
#if(defined(color_map))#debug"color_map\n"#end #if(defined(colour))#debug"colour\n"#end
#if(defined(colour_map))#debug"colour_map\n"#end #if(defined(component))#debug"component\n"#end
#if(defined(composite))#debug"composite\n"#end #if(defined(concat))#debug"concat\n"#end
#if(defined(cone))#debug"cone\n"#end #if(defined(confidence))#debug"confidence\n"#end
#if(defined(conic_sweep))#debug"conic_sweep\n"#end #if(defined(conserve_energy))#debug"conserve_energy\n"#end
#if(defined(contained_by))#debug"contained_by\n"#end #if(defined(control0))#debug"control0\n"#end
#if(defined(control1))#debug"control1\n"#end #if(defined(coords))#debug"coords\n"#end #if(defined(cos))#debug"cos\n"#end
#if(defined(cosh))#debug"cosh\n"#end #if(defined(count))#debug"count\n"#end #if(defined(crackle))#debug"crackle\n"#end
#if(defined(crand))#debug"crand\n"#end #if(defined(cube))#debug"cube\n"#end #if(defined(cubic))#debug"cubic\n"#end
#if(defined(cubic_spline))#debug"cubic_spline\n"#end #if(defined(cubic_wave))#debug"cubic_wave\n"#end
#if(defined(cutaway_textures))#debug"cutaway_textures\n"#end #if(defined(cylinder))#debug"cylinder\n"#end
#if(defined(cylindrical))#debug"cylindrical\n"#end #if(defined(datetime))#debug"datetime\n"#end
#if(defined(debug))#debug"debug\n"#end #if(defined(declare))#debug"declare\n"#end
#if(defined(default))#debug"default\n"#end #if(defined(defined))#debug"defined\n"#end
#if(defined(degrees))#debug"degrees\n"#end #if(defined(density))#debug"density\n"#end
#if(defined(density_file))#debug"density_file\n"#end #if(defined(density_map))#debug"density_map\n"#end
#if(defined(dents))#debug"dents\n"#end #if(defined(deprecated))#debug"deprecated\n"#end
#if(defined(df3))#debug"df3\n"#end #if(defined(difference))#debug"difference\n"#end
#if(defined(diffuse))#debug"diffuse\n"#end #if(defined(dimension_size))#debug"dimension_size\n"#end
#if(defined(dimensions))#debug"dimensions\n"#end #if(defined(direction))#debug"direction\n"#end
#if(defined(disc))#debug"disc\n"#end #if(defined(dispersion))#debug"dispersion\n"#end
#if(defined(dispersion_samples))#debug"dispersion_samples\n"#end #if(defined(dist_exp))#debug"dist_exp\n"#end
#if(defined(distance))#debug"distance\n"#end #if(defined(div))#debug"div\n"#end
#if(defined(double_illuminate))#debug"double_illuminate\n"#end #if(defined(dtag))#debug"dtag\n"#end
#if(defined(eccentricity))#debug"eccentricity\n"#end #if(defined(else))#debug"else\n"#end
#if(defined(elseif))#debug"elseif\n"#end #if(defined(emission))#debug"emission\n"#end #if(defined(end))#debug"end\n"#end
#if(defined(error))#debug"error\n"#end #if(defined(error_bound))#debug"error_bound\n"#end
#if(defined(evaluate))#debug"evaluate\n"#end #if(defined(exp))#debug"exp\n"#end
#if(defined(expand_thresholds))#debug"expand_thresholds\n"#end #if(defined(exponent))#debug"exponent\n"#end
#if(defined(exr))#debug"exr\n"#end #if(defined(exterior))#debug"exterior\n"#end
#if(defined(extinction))#debug"extinction\n"#end #if(defined(face_indices))#debug"face_indices\n"#end
#if(defined(facets))#debug"facets\n"#end #if(defined(fade_color))#debug"fade_color\n"#end
#if(defined(fade_colour))#debug"fade_colour\n"#end #if(defined(fade_distance))#debug"fade_distance\n"#end
#if(defined(fade_power))#debug"fade_power\n"#end #if(defined(falloff))#debug"falloff\n"#end
#if(defined(falloff_angle))#debug"falloff_angle\n"#end #if(defined(false))#debug"false\n"#end
#if(defined(fclose))#debug"fclose\n"#end #if(defined(file_exists))#debug"file_exists\n"#end
#if(defined(filter))#debug"filter\n"#end #if(defined(finish))#debug"finish\n"#end
#if(defined(fisheye))#debug"fisheye\n"#end #if(defined(flatness))#debug"flatness\n"#end
#if(defined(flip))#debug"flip\n"#end #if(defined(floor))#debug"floor\n"#end
#if(defined(focal_point))#debug"focal_point\n"#end #if(defined(fog))#debug"fog\n"#end
#if(defined(fog_alt))#debug"fog_alt\n"#end #if(defined(fog_offset))#debug"fog_offset\n"#end
#if(defined(fog_type))#debug"fog_type\n"#end #if(defined(fopen))#debug"fopen\n"#end #if(defined(for))#debug"for\n"#end
#if(defined(form))#debug"form\n"#end #if(defined(frequency))#debug"frequency\n"#end
#if(defined(fresnel))#debug"fresnel\n"#end #if(defined(function))#debug"function\n"#end
#if(defined(gamma))#debug"gamma\n"#end #if(defined(gather))#debug"gather\n"#end #if(defined(gif))#debug"gif\n"#end
#if(defined(global_lights))#debug"global_lights\n"#end #if(defined(global_settings))#debug"global_settings\n"#end
#if(defined(gradient))#debug"gradient\n"#end #if(defined(granite))#debug"granite\n"#end
#if(defined(gray))#debug"gray\n"#end #if(defined(gray_threshold))#debug"gray_threshold\n"#end
#if(defined(green))#debug"green\n"#end #if(defined(hdr))#debug"hdr\n"#end
#if(defined(height_field))#debug"height_field\n"#end #if(defined(hexagon))#debug"hexagon\n"#end
#if(defined(hf_gray_16))#debug"hf_gray_16\n"#end #if(defined(hierarchy))#debug"hierarchy\n"#end
#if(defined(hollow))#debug"hollow\n"#end #if(defined(hypercomplex))#debug"hypercomplex\n"#end
#if(defined(if))#debug"if\n"#end #if(defined(ifdef))#debug"ifdef\n"#end #if(defined(iff))#debug"iff\n"#end
#if(defined(ifndef))#debug"ifndef\n"#end #if(defined(image_map))#debug"image_map\n"#end
#if(defined(image_pattern))#debug"image_pattern\n"#end #if(defined(importance))#debug"importance\n"#end
#if(defined(include))#debug"include\n"#end #if(defined(inside))#debug"inside\n"#end
#if(defined(inside_vector))#debug"inside_vector\n"#end #if(defined(int))#debug"int\n"#end
#if(defined(interior))#debug"interior\n"#end #if(defined(interior_texture))#debug"interior_texture\n"#end
#if(defined(internal))#debug"internal\n"#end #if(defined(interpolate))#debug"interpolate\n"#end
#if(defined(intersection))#debug"intersection\n"#end #if(defined(intervals))#debug"intervals\n"#end
#if(defined(inverse))#debug"inverse\n"#end #if(defined(ior))#debug"ior\n"#end #if(defined(irid))#debug"irid\n"#end
#if(defined(irid_wavelength))#debug"irid_wavelength\n"#end #if(defined(isosurface))#debug"isosurface\n"#end
#if(defined(jitter))#debug"jitter\n"#end #if(defined(jpeg))#debug"jpeg\n"#end #if(defined(julia))#debug"julia\n"#end
#if(defined(julia_fractal))#debug"julia_fractal\n"#end #if(defined(lambda))#debug"lambda\n"#end
#if(defined(lathe))#debug"lathe\n"#end #if(defined(leopard))#debug"leopard\n"#end
#if(defined(light_group))#debug"light_group\n"#end #if(defined(light_source))#debug"light_source\n"#end
#if(defined(linear_spline))#debug"linear_spline\n"#end #if(defined(linear_sweep))#debug"linear_sweep\n"#end
#if(defined(ln))#debug"ln\n"#end #if(defined(load_file))#debug"load_file\n"#end #if(defined(local))#debug"local\n"#end
#if(defined(location))#debug"location\n"#end #if(defined(log))#debug"log\n"#end
#if(defined(look_at))#debug"look_at\n"#end #if(defined(looks_like))#debug"looks_like\n"#end
#if(defined(low_error_factor))#debug"low_error_factor\n"#end #if(defined(macro))#debug"macro\n"#end
#if(defined(magnet))#debug"magnet\n"#end #if(defined(major_radius))#debug"major_radius\n"#end
#if(defined(mandel))#debug"mandel\n"#end #if(defined(map_type))#debug"map_type\n"#end
#if(defined(marble))#debug"marble\n"#end #if(defined(material))#debug"material\n"#end
#if(defined(material_map))#debug"material_map\n"#end #if(defined(matrix))#debug"matrix\n"#end
#if(defined(max))#debug"max\n"#end #if(defined(max_extent))#debug"max_extent\n"#end
#if(defined(max_gradient))#debug"max_gradient\n"#end #if(defined(max_intersections))#debug"max_intersections\n"#end
#if(defined(max_iteration))#debug"max_iteration\n"#end #if(defined(max_sample))#debug"max_sample\n"#end
#if(defined(max_trace))#debug"max_trace\n"#end #if(defined(max_trace_level))#debug"max_trace_level\n"#end
#if(defined(maximum_reuse))#debug"maximum_reuse\n"#end #if(defined(media))#debug"media\n"#end
#if(defined(media_attenuation))#debug"media_attenuation\n"#end
#if(defined(media_interaction))#debug"media_interaction\n"#end #if(defined(merge))#debug"merge\n"#end
#if(defined(mesh))#debug"mesh\n"#end #if(defined(mesh2))#debug"mesh2\n"#end
#if(defined(mesh_camera))#debug"mesh_camera\n"#end #if(defined(metallic))#debug"metallic\n"#end
#if(defined(method))#debug"method\n"#end #if(defined(metric))#debug"metric\n"#end #if(defined(min))#debug"min\n"#end
#if(defined(min_extent))#debug"min_extent\n"#end #if(defined(minimum_reuse))#debug"minimum_reuse\n"#end
#if(defined(mm_per_unit))#debug"mm_per_unit\n"#end #if(defined(mod))#debug"mod\n"#end
#if(defined(mortar))#debug"mortar\n"#end #if(defined(natural_spline))#debug"natural_spline\n"#end
#if(defined(nearest_count))#debug"nearest_count\n"#end #if(defined(no))#debug"no\n"#end
#if(defined(no_bump_scale))#debug"no_bump_scale\n"#end #if(defined(no_image))#debug"no_image\n"#end
#if(defined(no_radiosity))#debug"no_radiosity\n"#end #if(defined(no_reflection))#debug"no_reflection\n"#end
#if(defined(no_shadow))#debug"no_shadow\n"#end #if(defined(noise_generator))#debug"noise_generator\n"#end
#if(defined(normal))#debug"normal\n"#end #if(defined(normal_indices))#debug"normal_indices\n"#end
#if(defined(normal_map))#debug"normal_map\n"#end #if(defined(normal_vectors))#debug"normal_vectors\n"#end
#if(defined(now))#debug"now\n"#end #if(defined(number_of_sides))#debug"number_of_sides\n"#end
#if(defined(number_of_tiles))#debug"number_of_tiles\n"#end #if(defined(number_of_waves))#debug"number_of_waves\n"#end
#if(defined(object))#debug"object\n"#end #if(defined(octaves))#debug"octaves\n"#end #if(defined(off))#debug"off\n"#end
#if(defined(offset))#debug"offset\n"#end #if(defined(omega))#debug"omega\n"#end
#if(defined(omnimax))#debug"omnimax\n"#end #if(defined(on))#debug"on\n"#end #if(defined(once))#debug"once\n"#end
#if(defined(onion))#debug"onion\n"#end #if(defined(open))#debug"open\n"#end #if(defined(orient))#debug"orient\n"#end
#if(defined(orientation))#debug"orientation\n"#end #if(defined(orthographic))#debug"orthographic\n"#end
#if(defined(ovus))#debug"ovus\n"#end #if(defined(panoramic))#debug"panoramic\n"#end
#if(defined(parallel))#debug"parallel\n"#end #if(defined(parametric))#debug"parametric\n"#end
#if(defined(pass_through))#debug"pass_through\n"#end #if(defined(pattern))#debug"pattern\n"#end
#if(defined(pavement))#debug"pavement\n"#end #if(defined(perspective))#debug"perspective\n"#end
#if(defined(pgm))#debug"pgm\n"#end #if(defined(phase))#debug"phase\n"#end #if(defined(phong))#debug"phong\n"#end
#if(defined(phong_size))#debug"phong_size\n"#end #if(defined(photons))#debug"photons\n"#end
#if(defined(pi))#debug"pi\n"#end #if(defined(pigment))#debug"pigment\n"#end
#if(defined(pigment_map))#debug"pigment_map\n"#end #if(defined(pigment_pattern))#debug"pigment_pattern\n"#end
#if(defined(planar))#debug"planar\n"#end #if(defined(plane))#debug"plane\n"#end #if(defined(png))#debug"png\n"#end
#if(defined(point_at))#debug"point_at\n"#end #if(defined(poly))#debug"poly\n"#end
#if(defined(poly_wave))#debug"poly_wave\n"#end #if(defined(polygon))#debug"polygon\n"#end
#if(defined(polynomial))#debug"polynomial\n"#end #if(defined(pot))#debug"pot\n"#end #if(defined(pow))#debug"pow\n"#end
#if(defined(ppm))#debug"ppm\n"#end #if(defined(precision))#debug"precision\n"#end
#if(defined(precompute))#debug"precompute\n"#end #if(defined(premultiplied))#debug"premultiplied\n"#end
#if(defined(pretrace_end))#debug"pretrace_end\n"#end #if(defined(pretrace_start))#debug"pretrace_start\n"#end
#if(defined(prism))#debug"prism\n"#end #if(defined(prod))#debug"prod\n"#end
#if(defined(projected_through))#debug"projected_through\n"#end #if(defined(pwr))#debug"pwr\n"#end
#if(defined(quadratic_spline))#debug"quadratic_spline\n"#end #if(defined(quadric))#debug"quadric\n"#end
#if(defined(quartic))#debug"quartic\n"#end #if(defined(quaternion))#debug"quaternion\n"#end
#if(defined(quick_color))#debug"quick_color\n"#end #if(defined(quick_colour))#debug"quick_colour\n"#end
#if(defined(quilted))#debug"quilted\n"#end #if(defined(radial))#debug"radial\n"#end
#if(defined(radians))#debug"radians\n"#end #if(defined(radiosity))#debug"radiosity\n"#end
#if(defined(radius))#debug"radius\n"#end #if(defined(rainbow))#debug"rainbow\n"#end
#if(defined(ramp_wave))#debug"ramp_wave\n"#end #if(defined(rand))#debug"rand\n"#end
#if(defined(range))#debug"range\n"#end #if(defined(ratio))#debug"ratio\n"#end #if(defined(read))#debug"read\n"#end
#if(defined(reciprocal))#debug"reciprocal\n"#end #if(defined(recursion_limit))#debug"recursion_limit\n"#end
#if(defined(red))#debug"red\n"#end #if(defined(reflection))#debug"reflection\n"#end
#if(defined(reflection_exponent))#debug"reflection_exponent\n"#end #if(defined(refraction))#debug"refraction\n"#end
#if(defined(render))#debug"render\n"#end #if(defined(repeat))#debug"repeat\n"#end #if(defined(rgb))#debug"rgb\n"#end
#if(defined(rgbf))#debug"rgbf\n"#end #if(defined(rgbft))#debug"rgbft\n"#end #if(defined(rgbt))#debug"rgbt\n"#end
#if(defined(right))#debug"right\n"#end #if(defined(ripples))#debug"ripples\n"#end
#if(defined(rotate))#debug"rotate\n"#end #if(defined(roughness))#debug"roughness\n"#end
#if(defined(samples))#debug"samples\n"#end #if(defined(save_file))#debug"save_file\n"#end
#if(defined(scale))#debug"scale\n"#end #if(defined(scallop_wave))#debug"scallop_wave\n"#end
#if(defined(scattering))#debug"scattering\n"#end #if(defined(seed))#debug"seed\n"#end
#if(defined(select))#debug"select\n"#end #if(defined(shadowless))#debug"shadowless\n"#end
#if(defined(sin))#debug"sin\n"#end #if(defined(sine_wave))#debug"sine_wave\n"#end #if(defined(sinh))#debug"sinh\n"#end
#if(defined(sint16be))#debug"sint16be\n"#end #if(defined(sint16le))#debug"sint16le\n"#end
#if(defined(sint32be))#debug"sint32be\n"#end #if(defined(sint32le))#debug"sint32le\n"#end
#if(defined(sint8))#debug"sint8\n"#end #if(defined(size))#debug"size\n"#end #if(defined(sky))#debug"sky\n"#end
#if(defined(sky_sphere))#debug"sky_sphere\n"#end #if(defined(slice))#debug"slice\n"#end
#if(defined(slope))#debug"slope\n"#end #if(defined(slope_map))#debug"slope_map\n"#end
#if(defined(smooth))#debug"smooth\n"#end #if(defined(smooth_triangle))#debug"smooth_triangle\n"#end
#if(defined(solid))#debug"solid\n"#end #if(defined(sor))#debug"sor\n"#end #if(defined(spacing))#debug"spacing\n"#end
#if(defined(specular))#debug"specular\n"#end #if(defined(sphere))#debug"sphere\n"#end
#if(defined(sphere_sweep))#debug"sphere_sweep\n"#end #if(defined(spherical))#debug"spherical\n"#end
#if(defined(spiral1))#debug"spiral1\n"#end #if(defined(spiral2))#debug"spiral2\n"#end
#if(defined(spline))#debug"spline\n"#end #if(defined(split_union))#debug"split_union\n"#end
#if(defined(spotlight))#debug"spotlight\n"#end #if(defined(spotted))#debug"spotted\n"#end
#if(defined(sqr))#debug"sqr\n"#end #if(defined(sqrt))#debug"sqrt\n"#end #if(defined(square))#debug"square\n"#end
#if(defined(srgb))#debug"srgb\n"#end #if(defined(srgbf))#debug"srgbf\n"#end #if(defined(srgbft))#debug"srgbft\n"#end
#if(defined(srgbt))#debug"srgbt\n"#end #if(defined(statistics))#debug"statistics\n"#end
#if(defined(steps))#debug"steps\n"#end #if(defined(str))#debug"str\n"#end #if(defined(strcmp))#debug"strcmp\n"#end
#if(defined(strength))#debug"strength\n"#end #if(defined(strlen))#debug"strlen\n"#end
#if(defined(strlwr))#debug"strlwr\n"#end #if(defined(strupr))#debug"strupr\n"#end #if(defined(sturm))#debug"sturm\n"#end
#if(defined(substr))#debug"substr\n"#end #if(defined(subsurface))#debug"subsurface\n"#end
#if(defined(sum))#debug"sum\n"#end #if(defined(superellipsoid))#debug"superellipsoid\n"#end
#if(defined(switch))#debug"switch\n"#end #if(defined(sys))#debug"sys\n"#end #if(defined(t))#debug"t\n"#end
#if(defined(tan))#debug"tan\n"#end #if(defined(tanh))#debug"tanh\n"#end #if(defined(target))#debug"target\n"#end
#if(defined(text))#debug"text\n"#end #if(defined(texture))#debug"texture\n"#end
#if(defined(texture_list))#debug"texture_list\n"#end #if(defined(texture_map))#debug"texture_map\n"#end
#if(defined(tga))#debug"tga\n"#end #if(defined(thickness))#debug"thickness\n"#end
#if(defined(threshold))#debug"threshold\n"#end #if(defined(tiff))#debug"tiff\n"#end
#if(defined(tightness))#debug"tightness\n"#end #if(defined(tile2))#debug"tile2\n"#end
#if(defined(tiles))#debug"tiles\n"#end #if(defined(tiling))#debug"tiling\n"#end
#if(defined(tolerance))#debug"tolerance\n"#end #if(defined(toroidal))#debug"toroidal\n"#end
#if(defined(torus))#debug"torus\n"#end #if(defined(trace))#debug"trace\n"#end
#if(defined(transform))#debug"transform\n"#end #if(defined(translate))#debug"translate\n"#end
#if(defined(translucency))#debug"translucency\n"#end #if(defined(transmit))#debug"transmit\n"#end
#if(defined(triangle))#debug"triangle\n"#end #if(defined(triangle_wave))#debug"triangle_wave\n"#end
#if(defined(triangular))#debug"triangular\n"#end #if(defined(true))#debug"true\n"#end #if(defined(ttf))#debug"ttf\n"#end
#if(defined(turb_depth))#debug"turb_depth\n"#end #if(defined(turbulence))#debug"turbulence\n"#end
#if(defined(type))#debug"type\n"#end #if(defined(u))#debug"u\n"#end #if(defined(u_steps))#debug"u_steps\n"#end
#if(defined(uint16be))#debug"uint16be\n"#end #if(defined(uint16le))#debug"uint16le\n"#end
#if(defined(uint8))#debug"uint8\n"#end #if(defined(ultra_wide_angle))#debug"ultra_wide_angle\n"#end
#if(defined(undef))#debug"undef\n"#end #if(defined(union))#debug"union\n"#end #if(defined(up))#debug"up\n"#end
#if(defined(use_alpha))#debug"use_alpha\n"#end #if(defined(use_color))#debug"use_color\n"#end
#if(defined(use_colour))#debug"use_colour\n"#end #if(defined(use_index))#debug"use_index\n"#end
#if(defined(utf8))#debug"utf8\n"#end #if(defined(uv_indices))#debug"uv_indices\n"#end
#if(defined(uv_mapping))#debug"uv_mapping\n"#end #if(defined(uv_vectors))#debug"uv_vectors\n"#end
#if(defined(v))#debug"v\n"#end #if(defined(v_steps))#debug"v_steps\n"#end #if(defined(val))#debug"val\n"#end
#if(defined(variance))#debug"variance\n"#end #if(defined(vaxis_rotate))#debug"vaxis_rotate\n"#end
#if(defined(vcross))#debug"vcross\n"#end #if(defined(vdot))#debug"vdot\n"#end #if(defined(version))#debug"version\n"#end
#if(defined(vertex_vectors))#debug"vertex_vectors\n"#end #if(defined(vlength))#debug"vlength\n"#end
#if(defined(vnormalize))#debug"vnormalize\n"#end #if(defined(vrotate))#debug"vrotate\n"#end
#if(defined(vstr))#debug"vstr\n"#end #if(defined(vturbulence))#debug"vturbulence\n"#end
#if(defined(warning))#debug"warning\n"#end #if(defined(warp))#debug"warp\n"#end
#if(defined(water_level))#debug"water_level\n"#end #if(defined(waves))#debug"waves\n"#end
#if(defined(while))#debug"while\n"#end #if(defined(width))#debug"width\n"#end #if(defined(wood))#debug"wood\n"#end
#if(defined(wrinkles))#debug"wrinkles\n"#end #if(defined(write))#debug"write\n"#end #if(defined(x))#debug"x\n"#end
#if(defined(xyz))#debug"xyz\n"#end #if(defined(y))#debug"y\n"#end #if(defined(yes))#debug"yes\n"#end
#if(defined(z))#debug"z\n"#end
#debug concat("none", "\n")
// expect: none

//= @ cannot be declared (directive words (after `#`; several also have other uses))
#declare @ = 1;
// each: append break case debug declare default else elseif end error fclose fopen for if ifdef ifndef
// each: include local macro once range read render statistics switch undef version warning while write
// error: D0101 at 1:10

//= @ cannot be declared (float functions)
#declare @ = 1;
// each: abs acos acosh asc asin asinh atan atan2 atanh bitwise_and bitwise_or bitwise_xor ceil cos cosh defined
// each: degrees dimension_size dimensions div exp file_exists floor inside int ln log max min mod pow prod radians
// each: rand seed select sin sinh sqrt strcmp strlen sum tan tanh val vdot vlength
// error: D0101 at 1:10

//= @ cannot be declared (float constants and variables)
#declare @ = 1;
// each: clock clock_on false no now off on pi true yes
// error: D0101 at 1:10

//= @ cannot be declared (vector functions)
#declare @ = 1;
// each: max_extent min_extent trace vaxis_rotate vcross vnormalize vrotate vturbulence
// error: D0101 at 1:10

//= @ cannot be declared (vector constants)
#declare @ = 1;
// each: t u v x y z
// error: D0101 at 1:10

//= @ cannot be declared (string functions)
#declare @ = 1;
// each: chr concat datetime str strlwr strupr substr vstr
// error: D0101 at 1:10

//= @ cannot be declared (colour words)
#declare @ = 1;
// each: alpha blue color colour filter gray green red rgb rgbf rgbft rgbt srgb srgbf srgbft srgbt transmit
// error: D0101 at 1:10

//= @ cannot be declared (value constructors)
#declare @ = 1;
// each: array function internal spline transform
// error: D0101 at 1:10

//= @ cannot be declared (data formats of `#write`)
#declare @ = 1;
// each: sint16be sint16le sint32be sint32le sint8 uint16be uint16le uint8
// error: D0101 at 1:10

//= @ cannot be declared (finite and infinite solids, patches)
#declare @ = 1;
// each: bicubic_patch blob box cone cubic cylinder disc height_field isosurface julia_fractal lathe mesh mesh2 ovus
// each: parametric plane poly polygon polynomial prism quadric quartic smooth_triangle sor sphere sphere_sweep
// each: superellipsoid text torus triangle
// error: D0101 at 1:10

//= @ cannot be declared (cSG and grouping)
#declare @ = 1;
// each: difference intersection light_group merge object split_union union
// error: D0101 at 1:10

//= @ cannot be declared (other top-level blocks)
#declare @ = 1;
// each: background camera fog global_settings light_source media photons radiosity rainbow sky_sphere
// error: D0101 at 1:10

//= @ cannot be declared (object modifiers)
#declare @ = 1;
// each: bounded_by clipped_by collect cutaway_textures double_illuminate hierarchy hollow interior interior_texture
// each: inverse material no_image no_radiosity no_reflection no_shadow pass_through sturm target uv_mapping uv_vectors
// error: D0101 at 1:10

//= @ cannot be declared (transformations)
#declare @ = 1;
// each: matrix rotate scale translate
// error: D0101 at 1:10

//= @ cannot be declared (primitive parameters)
#declare @ = 1;
// each: accuracy all_intersections b_spline bezier_spline component conic_sweep contained_by control0 control1 cube
// each: cubic_spline evaluate face_indices flatness hypercomplex inside_vector linear_spline linear_sweep max_gradient
// each: max_iteration max_trace method natural_spline normal_indices normal_vectors open precision precompute pwr
// each: quadratic_spline quaternion reciprocal slice smooth sqr square strength texture_list threshold tolerance ttf
// each: type u_steps uv_indices v_steps vertex_vectors water_level xyz
// error: D0101 at 1:10

//= @ cannot be declared (camera words)
#declare @ = 1;
// each: angle aperture blur_samples bokeh confidence direction fisheye focal_point location look_at mesh_camera
// each: omnimax orthographic panoramic perspective right sky spherical ultra_wide_angle up variance
// error: D0101 at 1:10

//= @ cannot be declared (light words)
#declare @ = 1;
// each: adaptive area_illumination area_light circular fade_color fade_colour fade_distance fade_power falloff
// each: global_lights jitter looks_like media_attenuation media_interaction orient parallel point_at projected_through
// each: radius shadowless spotlight tightness
// error: D0101 at 1:10

//= @ cannot be declared (texture blocks)
#declare @ = 1;
// each: bump_map color_map colour_map density density_map finish image_map material_map normal normal_map pigment
// each: pigment_map quick_color quick_colour slope_map texture texture_map tiles
// error: D0101 at 1:10

//= @ cannot be declared (pattern words)
#declare @ = 1;
// each: agate average boxed bozo brick bumps cells checker crackle cylindrical density_file dents facets gradient
// each: granite hexagon image_pattern julia leopard magnet mandel marble onion pattern pavement pigment_pattern planar
// each: quilted radial ripples slope solid spiral1 spiral2 spotted tiling triangular waves wood wrinkles
// error: D0101 at 1:10

//= @ cannot be declared (pattern parameters)
#declare @ = 1;
// each: agate_turb altitude black_hole brick_size bump_size coords cubic_wave dist_exp exponent exterior flip form
// each: frequency interpolate lambda map_type metric mortar no_bump_scale noise_generator number_of_sides
// each: number_of_tiles octaves offset omega orientation phase poly_wave ramp_wave repeat scallop_wave sine_wave size
// each: steps thickness toroidal triangle_wave turb_depth turbulence use_alpha use_color use_colour use_index warp
// error: D0101 at 1:10

//= @ cannot be declared (finish words)
#declare @ = 1;
// each: albedo ambient aoi brilliance caustics conserve_energy crand diffuse emission fresnel ior irid irid_wavelength
// each: metallic phong phong_size reflection reflection_exponent refraction roughness specular subsurface translucency
// error: D0101 at 1:10

//= @ cannot be declared (interior and media words)
#declare @ = 1;
// each: aa_level aa_threshold absorption anisotropy dispersion dispersion_samples eccentricity extinction intervals
// each: ratio samples scattering
// error: D0101 at 1:10

//= @ cannot be declared (fog and rainbow words)
#declare @ = 1;
// each: arc_angle distance falloff_angle fog_alt fog_offset fog_type width
// error: D0101 at 1:10

//= @ cannot be declared (global settings, radiosity, photons)
#declare @ = 1;
// each: adc_bailout all always_sample ambient_light ascii assumed_gamma autostop brightness charset count error_bound
// each: expand_thresholds gather gray_threshold hf_gray_16 importance load_file low_error_factor max_intersections
// each: max_sample max_trace_level maximum_reuse minimum_reuse mm_per_unit nearest_count number_of_waves pretrace_end
// each: pretrace_start recursion_limit save_file spacing sys utf8
// error: D0101 at 1:10

//= @ cannot be declared (image file types and map words)
#declare @ = 1;
// each: bmp df3 exr gamma gif hdr iff jpeg pgm png pot ppm premultiplied tga tiff
// error: D0101 at 1:10

//= @ cannot be declared (reserved but unused or obsolete in practice)
#declare @ = 1;
// each: composite dtag major_radius tile2
// error: D0101 at 1:10

//= predefined variables are ordinary names
#debug concat(str(defined(image_width), 0, 0), "\n")
#debug concat(str(defined(image_height), 0, 0), "\n")
#debug concat(str(defined(input_file_name), 0, 0), "\n")
#debug concat(str(defined(frame_number), 0, 0), "\n")
#debug concat(str(defined(initial_frame), 0, 0), "\n")
#debug concat(str(defined(final_frame), 0, 0), "\n")
#debug concat(str(defined(initial_clock), 0, 0), "\n")
#debug concat(str(defined(final_clock), 0, 0), "\n")
#debug concat(str(defined(clock_delta), 0, 0), "\n")
// expect: 1
// expect: 1
// expect: 1
// expect: 1
// expect: 1
// expect: 1
// expect: 1
// expect: 1
// expect: 1

//= they can be declared anew
#declare image_width = 5; #declare frame_number = "x";
#debug concat(str(image_width, 0, 0), "\n")
#debug concat(frame_number, "\n")
// expect: 5
// expect: x

//= they can be removed
#undef image_width
#debug concat(str(defined(image_width), 0, 0), "\n")
// expect: 0

//= tau and grey are free names in 3.7
#declare tau = 6.28; #declare grey = 0.5; #declare mixed = 1; #declare global = 2; #declare optional = 3; #declare dictionary = 4;
#debug concat(str(tau, 0, 2), "\n")
#debug concat(str(grey, 0, 2), "\n")
#debug concat(str(mixed, 0, 2), "\n")
#debug concat(str(global, 0, 2), "\n")
#debug concat(str(optional, 0, 2), "\n")
#debug concat(str(dictionary, 0, 2), "\n")
// expect: 6.28
// expect: 0.50
// expect: 1.00
// expect: 2.00
// expect: 3.00
// expect: 4.00

//= sqr is reserved but no function
#declare A = sqr(3);
// error: D0201 at 1:14

//= cube is reserved but no function
#declare A = cube(3);
// error: D0201 at 1:14

//= obsolete reserved words
#declare tile2 = 1;
// error: D0101 at 1:10

//= @ is no parameter of a macro
#macro M(@) 1 #end
// each: append sin clock pi true x y t rgb red array sphere union fog hollow scale sturm angle jitter pigment bozo octaves phong
// each: media width all png dtag
// error: D0101 at 1:10

//= @ is no macro
#macro @() 1 #end
// each: append sin clock pi true x y t rgb red array sphere union fog hollow scale sturm angle jitter pigment bozo octaves phong
// each: media width all png dtag
// error: D0101 at 1:8

//= @ is no loop variable
#for (@, 0, 1) #end
// each: append sin clock pi true x y t rgb red array sphere union fog hollow scale sturm angle jitter pigment bozo octaves phong
// each: media width all png dtag
// error: D0101 at 1:7

//= @ is no parameter of a function
#declare F = function(@) { 1 }
// each: append sin clock pi true t rgb red array sphere union fog hollow scale sturm angle jitter pigment bozo octaves phong
// each: media width all png dtag
// error: D0201 at 1:23

//= @ is a parameter of functions all the same
#declare F = function(@) { 2*@ } #debug concat(str(F(3), 0, 0), "\n")
// each: x y z u v
// expect: 6

//= @ cannot be removed
#undef @
// each: append sin clock pi true x y t rgb red array sphere union fog hollow scale sturm angle jitter pigment bozo octaves phong
// each: media width all png dtag
// error: D0201 at 1:1

//= @ is no file
#fopen @ "data.txt" read
// each: append sin clock pi true x y t rgb red array sphere union fog hollow scale sturm angle jitter pigment bozo octaves phong
// each: media width all png dtag
// error: D0201 at 1:8

//= deprecated cannot be declared
#declare deprecated = 1;
// error: D0101 at 1:23
