// The fields of every struct of the scene, by name: one table for printing and comparing.
#pragma once

#include <array>
#include <tuple>

#include "scene/image.h"
#include "scene/mesh.h"
#include "scene/scene.h"

namespace durer::scene {

/// What the number in a field stands for.
enum class Role : std::uint8_t {
  plain,
  id,         // index into one of the scene's vectors; `none` if there is nothing
  primitive,  // index into Registry::primitives
  pattern,    // index into Registry::patterns
  warp,       // index into Registry::warps
  operands,   // laid out by the Params of the type in the same struct
  place,      // OriginId
};

template <typename Struct, typename Member>
struct Field {
  std::string_view name;
  Member Struct::*member;
  Role role = Role::plain;
};

template <typename Struct, typename Member>
constexpr Field<Struct, Member> field(std::string_view name, Member Struct::*member,
                                      Role role = Role::plain) {
  return {name, member, role};
}

/// `Fields<T>::all` is a tuple of Field, one for every member of T in its order.
template <typename T>
struct Fields;

template <typename T>
concept HasFields = requires {
  Fields<T>::all;
};

template <>
struct Fields<HeightField> {
  static constexpr std::tuple all{field("width", &HeightField::width),
                                  field("height", &HeightField::height),
                                  field("heights", &HeightField::heights)};
};

template <>
struct Fields<ObjectPhotons> {
  static constexpr std::tuple all{field("target", &ObjectPhotons::target),
                                  field("refraction", &ObjectPhotons::refraction),
                                  field("reflection", &ObjectPhotons::reflection),
                                  field("pass_through", &ObjectPhotons::pass_through),
                                  field("collect", &ObjectPhotons::collect)};
};

template <>
struct Fields<LightPhotons> {
  static constexpr std::tuple all{field("refraction", &LightPhotons::refraction),
                                  field("reflection", &LightPhotons::reflection),
                                  field("area", &LightPhotons::area)};
};

template <>
struct Fields<Photons> {
  static constexpr std::tuple all{
      field("spacing", &Photons::spacing),
      field("count", &Photons::count),
      field("gather_min", &Photons::gather_min),
      field("gather_max", &Photons::gather_max),
      field("media_steps", &Photons::media_steps),
      field("media_factor", &Photons::media_factor),
      field("jitter", &Photons::jitter),
      field("autostop", &Photons::autostop),
      field("expand_increase", &Photons::expand_increase),
      field("expand_min", &Photons::expand_min),
      field("surface_radius", &Photons::surface_radius),
      field("surface_factor", &Photons::surface_factor),
      field("media_radius", &Photons::media_radius),
      field("media_factor_of_radius", &Photons::media_factor_of_radius),
      field("max_trace_level", &Photons::max_trace_level),
      field("adc_bailout", &Photons::adc_bailout),
      field("save_file", &Photons::save_file),
      field("loaded", &Photons::loaded)};
};

template <>
struct Fields<ObjectExtras> {
  static constexpr std::tuple all{field("mesh", &ObjectExtras::mesh),
                                  field("isosurface", &ObjectExtras::isosurface),
                                  field("parametric", &ObjectExtras::parametric),
                                  field("heights", &ObjectExtras::heights),
                                  field("part_textures", &ObjectExtras::part_textures, Role::id),
                                  field("interior_texture", &ObjectExtras::interior_texture),
                                  field("clips", &ObjectExtras::clips, Role::id),
                                  field("bounds", &ObjectExtras::bounds, Role::id),
                                  field("clip_transform", &ObjectExtras::clip_transform),
                                  field("bound_transform", &ObjectExtras::bound_transform),
                                  field("media_transform", &ObjectExtras::media_transform),
                                  field("photons", &ObjectExtras::photons),
                                  field("unsupported", &ObjectExtras::unsupported)};
};

template <>
struct Fields<Object> {
  static constexpr std::tuple all{
      field("kind", &Object::kind),
      field("inverse", &Object::inverse),
      field("no_shadow", &Object::no_shadow),
      field("no_image", &Object::no_image),
      field("no_reflection", &Object::no_reflection),
      field("no_radiosity", &Object::no_radiosity),
      field("double_illuminate", &Object::double_illuminate),
      field("sturm", &Object::sturm),
      field("importance", &Object::importance),
      field("kept_whole", &Object::kept_whole),
      field("cutaway_textures", &Object::cutaway_textures),
      field("hollow", &Object::hollow),
      field("uv_mapping", &Object::uv_mapping),
      field("global_lights", &Object::global_lights),
      field("type", &Object::type, Role::primitive),
      field("light", &Object::light, Role::id),
      field("interior", &Object::interior, Role::id),
      field("origin", &Object::origin, Role::place),
      field("args", &Object::args, Role::operands),
      field("children", &Object::children, Role::id),
      field("transform", &Object::transform),
      field("texture", &Object::texture),
      field("extras", &Object::extras)};
};

template <>
struct Fields<Container> {
  static constexpr std::tuple all{
      field("kind", &Container::kind), field("lo", &Container::lo), field("hi", &Container::hi),
      field("centre", &Container::centre), field("radius", &Container::radius)};
};

template <>
struct Fields<Isosurface> {
  static constexpr std::tuple all{field("function", &Isosurface::function),
                                  field("container", &Isosurface::container),
                                  field("threshold", &Isosurface::threshold),
                                  field("accuracy", &Isosurface::accuracy),
                                  field("max_gradient", &Isosurface::max_gradient),
                                  field("evaluate", &Isosurface::evaluate),
                                  field("max_trace", &Isosurface::max_trace),
                                  field("open", &Isosurface::open)};
};

template <>
struct Fields<Parametric> {
  static constexpr std::tuple all{field("functions", &Parametric::functions),
                                  field("from", &Parametric::from),
                                  field("to", &Parametric::to),
                                  field("container", &Parametric::container),
                                  field("accuracy", &Parametric::accuracy),
                                  field("max_gradient", &Parametric::max_gradient)};
};

template <>
struct Fields<Mesh> {
  static constexpr std::tuple all{field("vertices", &Mesh::vertices),
                                  field("normals", &Mesh::normals),
                                  field("uvs", &Mesh::uvs),
                                  field("faces", &Mesh::faces),
                                  field("face_normals", &Mesh::face_normals),
                                  field("face_uvs", &Mesh::face_uvs),
                                  field("normals_by_vertex", &Mesh::normals_by_vertex),
                                  field("uvs_by_vertex", &Mesh::uvs_by_vertex),
                                  field("textures", &Mesh::textures, Role::id),
                                  field("face_textures", &Mesh::face_textures, Role::id),
                                  field("inside_vector", &Mesh::inside_vector)};
};

template <>
struct Fields<TextureUse> {
  static constexpr std::tuple all{field("texture", &TextureUse::texture, Role::id),
                                  field("transform", &TextureUse::transform)};
};

template <>
struct Fields<Root> {
  static constexpr std::tuple all{field("object", &Root::object, Role::id),
                                  field("default_texture", &Root::default_texture, Role::id)};
};

template <>
struct Fields<LightArea> {
  static constexpr std::tuple all{
      field("u", &LightArea::u),               field("v", &LightArea::v),
      field("n1", &LightArea::n1),             field("n2", &LightArea::n2),
      field("adaptive", &LightArea::adaptive), field("jitter", &LightArea::jitter),
      field("circular", &LightArea::circular), field("orient", &LightArea::orient),
      field("illumination", &LightArea::illumination)};
};

template <>
struct Fields<Light> {
  static constexpr std::tuple all{field("kind", &Light::kind),
                                  field("position", &Light::position),
                                  field("colour", &Light::colour),
                                  field("parallel", &Light::parallel),
                                  field("shadowless", &Light::shadowless),
                                  field("point_at", &Light::point_at),
                                  field("radius_deg", &Light::radius_deg),
                                  field("falloff_deg", &Light::falloff_deg),
                                  field("tightness", &Light::tightness),
                                  field("fade_distance", &Light::fade_distance),
                                  field("fade_power", &Light::fade_power),
                                  field("media_interaction", &Light::media_interaction),
                                  field("media_attenuation", &Light::media_attenuation),
                                  field("has_area", &Light::has_area),
                                  field("area", &Light::area),
                                  field("projected_through", &Light::projected_through, Role::id),
                                  field("photons", &Light::photons),
                                  field("origin", &Light::origin, Role::place)};
};

template <>
struct Fields<Lens> {
  static constexpr std::tuple all{field("aperture", &Lens::aperture),
                                  field("least_samples", &Lens::least_samples),
                                  field("most_samples", &Lens::most_samples),
                                  field("focal_distance", &Lens::focal_distance),
                                  field("confidence", &Lens::confidence),
                                  field("variance", &Lens::variance),
                                  field("has_bokeh", &Lens::has_bokeh),
                                  field("bokeh", &Lens::bokeh)};
};

template <>
struct Fields<MeshCamera> {
  static constexpr std::tuple all{field("rays", &MeshCamera::rays),
                                  field("distribution", &MeshCamera::distribution),
                                  field("reach", &MeshCamera::reach),
                                  field("smooth", &MeshCamera::smooth),
                                  field("meshes", &MeshCamera::meshes),
                                  field("transforms", &MeshCamera::transforms)};
};

template <>
struct Fields<Camera> {
  static constexpr std::tuple all{field("kind", &Camera::kind),
                                  field("location", &Camera::location),
                                  field("direction", &Camera::direction),
                                  field("right", &Camera::right),
                                  field("up", &Camera::up),
                                  field("angle_deg", &Camera::angle_deg),
                                  field("vertical_angle_deg", &Camera::vertical_angle_deg),
                                  field("cylinder_type", &Camera::cylinder_type),
                                  field("location_functions", &Camera::location_functions),
                                  field("direction_functions", &Camera::direction_functions),
                                  field("transform", &Camera::transform),
                                  field("normal", &Camera::normal),
                                  field("lens", &Camera::lens),
                                  field("mesh", &Camera::mesh),
                                  field("origin", &Camera::origin, Role::place)};
};

template <>
struct Fields<SkySphere> {
  static constexpr std::tuple all{
      field("pigments", &SkySphere::pigments), field("emission", &SkySphere::emission),
      field("transform", &SkySphere::transform), field("origin", &SkySphere::origin, Role::place)};
};

template <>
struct Fields<Radiosity> {
  static constexpr std::tuple all{field("count", &Radiosity::count),
                                  field("pool", &Radiosity::pool),
                                  field("recursion_limit", &Radiosity::recursion_limit),
                                  field("error_bound", &Radiosity::error_bound),
                                  field("low_error_factor", &Radiosity::low_error_factor),
                                  field("nearest_count", &Radiosity::nearest_count),
                                  field("adaptive_count", &Radiosity::adaptive_count),
                                  field("minimum_reuse", &Radiosity::minimum_reuse),
                                  field("maximum_reuse", &Radiosity::maximum_reuse),
                                  field("gray_threshold", &Radiosity::gray_threshold),
                                  field("brightness", &Radiosity::brightness),
                                  field("max_sample", &Radiosity::max_sample),
                                  field("adc_bailout", &Radiosity::adc_bailout),
                                  field("pretrace_start", &Radiosity::pretrace_start),
                                  field("pretrace_end", &Radiosity::pretrace_end),
                                  field("always_sample", &Radiosity::always_sample),
                                  field("normal", &Radiosity::normal),
                                  field("media", &Radiosity::media),
                                  field("subsurface", &Radiosity::subsurface),
                                  field("background_importance", &Radiosity::background_importance)};
};

template <>
struct Fields<Fog> {
  static constexpr std::tuple all{
      field("kind", &Fog::kind),           field("distance", &Fog::distance),
      field("colour", &Fog::colour),       field("offset", &Fog::offset),
      field("alt", &Fog::alt),             field("up", &Fog::up),
      field("turbulent", &Fog::turbulent), field("turbulence", &Fog::turbulence),
      field("turb_depth", &Fog::turb_depth), field("octaves", &Fog::octaves),
      field("omega", &Fog::omega),         field("lambda", &Fog::lambda),
      field("origin", &Fog::origin, Role::place)};
};

template <>
struct Fields<Rainbow> {
  static constexpr std::tuple all{field("direction", &Rainbow::direction),
                                  field("up", &Rainbow::up),
                                  field("angle_deg", &Rainbow::angle_deg),
                                  field("width_deg", &Rainbow::width_deg),
                                  field("arc_angle_deg", &Rainbow::arc_angle_deg),
                                  field("falloff_angle_deg", &Rainbow::falloff_angle_deg),
                                  field("distance", &Rainbow::distance),
                                  field("jitter", &Rainbow::jitter),
                                  field("colours", &Rainbow::colours),
                                  field("origin", &Rainbow::origin, Role::place)};
};

template <>
struct Fields<Subsurface> {
  static constexpr std::tuple all{field("samples", &Subsurface::samples),
                                  field("single_samples", &Subsurface::single_samples),
                                  field("radiosity", &Subsurface::radiosity)};
};

template <>
struct Fields<Settings> {
  static constexpr std::tuple all{field("adc_bailout", &Settings::adc_bailout),
                                  field("max_trace_level", &Settings::max_trace_level),
                                  field("ambient_light", &Settings::ambient_light),
                                  field("irid_wavelength", &Settings::irid_wavelength),
                                  field("noise_generator", &Settings::noise_generator),
                                  field("number_of_waves", &Settings::number_of_waves),
                                  field("mm_per_unit", &Settings::mm_per_unit),
                                  field("radiosity", &Settings::radiosity),
                                  field("photons", &Settings::photons),
                                  field("subsurface", &Settings::subsurface),
                                  field("gamma_mode", &Settings::gamma_mode),
                                  field("assumed_gamma", &Settings::assumed_gamma),
                                  field("effective_version", &Settings::effective_version),
                                  field("declared_version", &Settings::declared_version)};
};

template <>
struct Fields<PigmentEntry> {
  static constexpr std::tuple all{field("key", &PigmentEntry::key),
                                  field("colour", &PigmentEntry::colour),
                                  field("pigment", &PigmentEntry::pigment, Role::id)};
};

template <>
struct Fields<Warp> {
  static constexpr std::tuple all{field("type", &Warp::type, Role::warp),
                                  field("args", &Warp::args, Role::operands),
                                  field("transform", &Warp::transform),
                                  field("classic", &Warp::classic)};
};

template <>
struct Fields<PaletteChange> {
  static constexpr std::tuple all{field("index", &PaletteChange::index),
                                  field("value", &PaletteChange::value)};
};

template <>
struct Fields<Image> {
  static constexpr std::tuple all{
      field("picture", &Image::picture),
      field("stored", &Image::stored),
      field("working", &Image::working),
      field("projection", &Image::projection),
      field("interpolation", &Image::interpolation),
      field("once", &Image::once),
      field("use_index", &Image::use_index),
      field("use_alpha", &Image::use_alpha),
      field("premultiplied", &Image::premultiplied),
      field("repeat", &Image::repeat),
      field("offset", &Image::offset),
      field("filter_all", &Image::filter_all),
      field("transmit_all", &Image::transmit_all),
      field("filter", &Image::filter),
      field("transmit", &Image::transmit)};
};

template <>
struct Fields<Voxels> {
  static constexpr std::tuple all{field("size", &Voxels::size), field("width", &Voxels::width),
                                  field("bytes", &Voxels::bytes)};
};

template <>
struct Fields<Pattern> {
  static constexpr std::tuple all{field("type", &Pattern::type, Role::pattern),
                                  field("args", &Pattern::args, Role::operands),
                                  field("function", &Pattern::function),
                                  field("pigment", &Pattern::pigment),
                                  field("image", &Pattern::image),
                                  field("voxels", &Pattern::voxels),
                                  field("warps", &Pattern::warps),
                                  field("transform", &Pattern::transform),
                                  field("frequency", &Pattern::frequency),
                                  field("phase", &Pattern::phase),
                                  field("wave", &Pattern::wave),
                                  field("wave_exponent", &Pattern::wave_exponent),
                                  field("noise_generator", &Pattern::noise_generator)};
};

template <>
struct Fields<Pigment> {
  static constexpr std::tuple all{field("pattern", &Pigment::pattern),
                                  field("colour", &Pigment::colour),
                                  field("entries", &Pigment::entries),
                                  field("children", &Pigment::children),
                                  field("uv_mapping", &Pigment::uv_mapping),
                                  field("quick_colour", &Pigment::quick_colour),
                                  field("origin", &Pigment::origin, Role::place),
                                  field("unsupported", &Pigment::unsupported)};
};

template <>
struct Fields<Finish> {
  static constexpr std::tuple all{field("ambient", &Finish::ambient),
                                  field("emission", &Finish::emission),
                                  field("diffuse", &Finish::diffuse),
                                  field("diffuse_back", &Finish::diffuse_back),
                                  field("indirect", &Finish::indirect),
                                  field("indirect_back", &Finish::indirect_back),
                                  field("brilliance", &Finish::brilliance),
                                  field("phong", &Finish::phong),
                                  field("phong_size", &Finish::phong_size),
                                  field("specular", &Finish::specular),
                                  field("roughness", &Finish::roughness),
                                  field("metallic", &Finish::metallic),
                                  field("crand", &Finish::crand),
                                  field("reflection_min", &Finish::reflection_min),
                                  field("reflection_max", &Finish::reflection_max),
                                  field("reflection_falloff", &Finish::reflection_falloff),
                                  field("reflection_exponent", &Finish::reflection_exponent),
                                  field("reflection_metallic", &Finish::reflection_metallic),
                                  field("fresnel", &Finish::fresnel),
                                  field("conserve_energy", &Finish::conserve_energy),
                                  field("irid", &Finish::irid),
                                  field("irid_thickness", &Finish::irid_thickness),
                                  field("irid_turbulence", &Finish::irid_turbulence),
                                  field("translucency", &Finish::translucency),
                                  field("subsurface", &Finish::subsurface),
                                  field("ior", &Finish::ior),
                                  field("caustics", &Finish::caustics),
                                  field("refraction", &Finish::refraction),
                                  field("unsupported", &Finish::unsupported)};
};

template <>
struct Fields<NormalEntry> {
  static constexpr std::tuple all{field("key", &NormalEntry::key),
                                  field("normal", &NormalEntry::normal, Role::id)};
};

template <>
struct Fields<SlopeEntry> {
  static constexpr std::tuple all{field("key", &SlopeEntry::key),
                                  field("height", &SlopeEntry::height),
                                  field("slope", &SlopeEntry::slope)};
};

template <>
struct Fields<Normal> {
  static constexpr std::tuple all{field("pattern", &Normal::pattern),
                                  field("amount", &Normal::amount),
                                  field("accuracy", &Normal::accuracy),
                                  field("no_bump_scale", &Normal::no_bump_scale),
                                  field("uv_mapping", &Normal::uv_mapping),
                                  field("entries", &Normal::entries),
                                  field("children", &Normal::children),
                                  field("slopes", &Normal::slopes),
                                  field("origin", &Normal::origin, Role::place),
                                  field("unsupported", &Normal::unsupported)};
};

template <>
struct Fields<Layer> {
  static constexpr std::tuple all{field("pigment", &Layer::pigment),
                                  field("finish", &Layer::finish),
                                  field("unsupported", &Layer::unsupported),
                                  field("normal", &Layer::normal)};
};

template <>
struct Fields<TextureEntry> {
  static constexpr std::tuple all{field("key", &TextureEntry::key),
                                  field("texture", &TextureEntry::texture, Role::id)};
};

template <>
struct Fields<Texture> {
  static constexpr std::tuple all{field("layers", &Texture::layers),
                                  field("origin", &Texture::origin, Role::place),
                                  field("unsupported", &Texture::unsupported),
                                  field("pattern", &Texture::pattern),
                                  field("entries", &Texture::entries),
                                  field("uv_mapping", &Texture::uv_mapping),
                                  field("no_bump_scale", &Texture::no_bump_scale)};
};

template <>
struct Fields<Interior> {
  static constexpr std::tuple all{field("ior", &Interior::ior),
                                  field("dispersion", &Interior::dispersion),
                                  field("dispersion_samples", &Interior::dispersion_samples),
                                  field("caustics", &Interior::caustics),
                                  field("fade_distance", &Interior::fade_distance),
                                  field("fade_power", &Interior::fade_power),
                                  field("fade_colour", &Interior::fade_colour),
                                  field("refraction", &Interior::refraction),
                                  field("media", &Interior::media),
                                  field("origin", &Interior::origin, Role::place),
                                  field("unsupported", &Interior::unsupported)};
};

template <>
struct Fields<Media> {
  static constexpr std::tuple all{field("absorption", &Media::absorption),
                                  field("emission", &Media::emission),
                                  field("scattering", &Media::scattering),
                                  field("phase", &Media::phase),
                                  field("eccentricity", &Media::eccentricity),
                                  field("extinction", &Media::extinction),
                                  field("collect", &Media::collect),
                                  field("densities", &Media::densities),
                                  field("method", &Media::method),
                                  field("intervals", &Media::intervals),
                                  field("min_samples", &Media::min_samples),
                                  field("max_samples", &Media::max_samples),
                                  field("confidence", &Media::confidence),
                                  field("variance", &Media::variance),
                                  field("ratio", &Media::ratio),
                                  field("jitter", &Media::jitter),
                                  field("aa_threshold", &Media::aa_threshold),
                                  field("aa_level", &Media::aa_level),
                                  field("origin", &Media::origin, Role::place)};
};

template <>
struct Fields<Colour> {
  static constexpr std::tuple all{field("rgb", &Colour::rgb), field("filter", &Colour::filter),
                                  field("transmit", &Colour::transmit)};
};

template <>
struct Fields<GammaCurve> {
  static constexpr std::tuple all{field("kind", &GammaCurve::kind),
                                  field("gamma", &GammaCurve::gamma)};
};

template <>
struct Fields<Affine> {
  static constexpr std::tuple all{field("x", &Affine::x), field("y", &Affine::y),
                                  field("z", &Affine::z), field("t", &Affine::t)};
};

/// The words of an enumeration, in its order.
template <typename T>
struct Words;

template <>
struct Words<NodeKind> {
  static constexpr std::array<std::string_view, 8> all{"primitive",   "union", "merge",
                                                       "intersection", "difference", "light",
                                                       "light_group", "unsupported"};
};
template <>
struct Words<Container::Kind> {
  static constexpr std::array<std::string_view, 2> all{"box", "sphere"};
};
template <>
struct Words<Light::Kind> {
  static constexpr std::array<std::string_view, 3> all{"point", "spotlight", "cylinder"};
};
template <>
struct Words<Camera::Kind> {
  static constexpr std::array all{
#define DURER_ENTRY(name) std::string_view(#name),
#include "scene/cameras.def"
#undef DURER_ENTRY
  };
};
template <>
struct Words<Fog::Kind> {
  static constexpr std::array<std::string_view, 2> all{"constant", "ground"};
};
template <>
struct Words<Phase> {
  static constexpr std::array<std::string_view, 5> all{"isotropic", "mie_hazy", "mie_murky",
                                                       "rayleigh", "henyey_greenstein"};
};
template <>
struct Words<GammaMode> {
  static constexpr std::array<std::string_view, 4> all{"off", "legacy", "explicit", "implied"};
};
template <>
struct Words<Image::Projection> {
  static constexpr std::array<std::string_view, 4> all{"planar", "spherical", "cylindrical",
                                                       "toroidal"};
};
template <>
struct Words<Image::Interpolation> {
  static constexpr std::array<std::string_view, 4> all{"nearest", "bilinear", "bicubic", "distance"};
};
template <>
struct Words<Wave> {
  static constexpr std::array<std::string_view, 6> all{"ramp",    "sine",  "triangle",
                                                       "scallop", "cubic", "poly"};
};
template <>
struct Words<GammaCurve::Kind> {
  static constexpr std::array<std::string_view, 3> all{"linear", "power", "srgb"};
};

}  // namespace durer::scene
